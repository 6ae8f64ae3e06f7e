# Isolation rewrites object files with GNU binutils. Link-time optimisation has no machine code to
# rewrite yet, and macOS has no such linker: there the plain objects are linked.
if(APPLE OR CS550_LTO)
  set(CS550_ISOLATE_LABS FALSE)
else()
  find_program(CS550_BFD_LINKER ld.bfd)
  if(CS550_BFD_LINKER AND CMAKE_OBJCOPY AND CMAKE_NM)
    set(CS550_ISOLATE_LABS TRUE)
  else()
    set(CS550_ISOLATE_LABS FALSE)
    message(STATUS "GNU binutils not found: lab objects are linked without isolation")
  endif()
endif()
