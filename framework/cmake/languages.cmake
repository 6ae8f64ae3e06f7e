set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

# Editors search for the database in the root folder. Only the presets' builds write it there: a test
# that configures in a folder of its own would leave a broken link.
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
cmake_path(GET PROJECT_BINARY_DIR PARENT_PATH build_folder)
if(build_folder STREQUAL "${PROJECT_SOURCE_DIR}/build")
  # A file system may have no links, and the root folder may be read-only.
  file(CREATE_LINK "${PROJECT_BINARY_DIR}/compile_commands.json"
       "${PROJECT_SOURCE_DIR}/compile_commands.json" RESULT without_link SYMBOLIC)
  if(without_link)
    message(STATUS "Editors find no compile_commands.json in the root folder: ${without_link}")
  endif()
endif()

# g++ collects its garbage whenever its memory has doubled, from 128 MB on. In a batch of files (given_code.cmake) that
# takes a tenth of the time. Without it, the largest batch needs 1.0 GB of memory instead of 0.8 GB.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)

if(CS550_LTO)
  include(CheckIPOSupported)
  check_ipo_supported(LANGUAGES CXX)
  set(CMAKE_INTERPROCEDURAL_OPTIMIZATION ON)
  # By default g++ does not inline functions of more than 30 instructions, nor most others once the program has
  # grown by two fifths. Rotations are longer, and a call passes their vectors through memory.
  set(inline_more $<$<CXX_COMPILER_ID:GNU>:--param=max-inline-insns-auto=120>
                  $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=300>)
  add_compile_options(${inline_more})
  add_link_options(${inline_more})
endif()

# Students wait for the linker after every edit. lld and gold need a third to a half of ld.bfd's time.
if(NOT APPLE AND NOT CS550_LTO)
  foreach(linker lld gold)
    find_program(CS550_LD_${linker} ld.${linker})
    if(CS550_LD_${linker})
      add_link_options(-fuse-ld=${linker})
      break()
    endif()
  endforeach()
endif()
