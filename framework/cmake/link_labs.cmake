# Which code of each lab an executable runs. The objects are linked directly: an archive would
# silently take the wrong definition or none.
#
#   cs550_link_lab(target number variant)    one lab
#   cs550_link_other_labs(target number)     every lab but this one, see cs550_trusted_variant
#   cs550_link_reference_labs(target)        all of them: the reference, or the stub without one
#   cs550_link_fast_labs(target)             the same, with fast kernels where they exist
#   cs550_link_student_labs(target)          all of them: the student's
# CS550_RUNS_ON_STUBS: whether "the reference" is in part a stub.

function(cs550_link_lab target number variant)
  if(CS550_ISOLATE_LABS)
    target_sources(${target} PRIVATE "${lab_folder}/lab${number}_${variant}.o")
    set_source_files_properties("${lab_folder}/lab${number}_${variant}.o" PROPERTIES
                                EXTERNAL_OBJECT TRUE GENERATED TRUE)
    add_dependencies(${target} lab${number}_${variant}_object)
  else()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:lab${number}_${variant}_code>)
  endif()
endfunction()

# The first of the wished-for variants that this lab has.
function(cs550_first_variant result number)
  foreach(variant IN LISTS ARGN)
    if(variant IN_LIST CS550_LAB${number}_VARIANTS)
      set(${result} ${variant} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${result} "" PARENT_SCOPE)
endfunction()

function(cs550_link_each_lab target)
  foreach(number IN LISTS CS550_LABS)
    cs550_first_variant(variant ${number} ${ARGN})
    if(variant)
      cs550_link_lab(${target} ${number} ${variant})
    endif()
  endforeach()
endfunction()

# One mistake is marked once: the other labs are the reference. A students' copy has none and takes
# the student's.
function(cs550_link_other_labs target own_number)
  foreach(number IN LISTS CS550_LABS)
    if(NOT number EQUAL own_number)
      cs550_first_variant(variant ${number} reference assembled stub)
      cs550_link_lab(${target} ${number} ${variant})
    endif()
  endforeach()
endfunction()

# Whether a lab has no reference here, as in a students' copy.
set(CS550_RUNS_ON_STUBS FALSE)
foreach(number IN LISTS CS550_LABS)
  if(NOT "reference" IN_LIST CS550_LAB${number}_VARIANTS)
    set(CS550_RUNS_ON_STUBS TRUE)
  endif()
endforeach()

function(cs550_link_reference_labs target)
  cs550_link_each_lab(${target} reference stub)
endfunction()

function(cs550_link_fast_labs target)
  cs550_link_each_lab(${target} fast reference stub)
endfunction()

function(cs550_link_student_labs target)
  cs550_link_each_lab(${target} assembled reference)
endfunction()

# The table by which a program says whose code it runs: generated from the symbol lists, the same
# for every executable.
set(symbol_lists "")
set(symbol_targets "")
if(CS550_ISOLATE_LABS)
  foreach(number IN LISTS CS550_LABS)
    list(APPEND symbol_lists "${lab_folder}/lab${number}.symbols")
    list(APPEND symbol_targets lab${number}_symbols)
  endforeach()
endif()
set(table_script "${CMAKE_CURRENT_LIST_DIR}/write_lab_table.cmake")
add_custom_command(
  OUTPUT "${lab_folder}/lab_table.cpp"
  COMMAND "${CMAKE_COMMAND}" "-DSYMBOL_LISTS=${symbol_lists}"
          "-DOUTPUT=${lab_folder}/lab_table.cpp" -P "${table_script}"
  DEPENDS ${symbol_lists} "${table_script}"
  VERBATIM)
add_library(cs550_lab_table OBJECT EXCLUDE_FROM_ALL "${lab_folder}/lab_table.cpp")
target_include_directories(cs550_lab_table PRIVATE
                           "${PROJECT_SOURCE_DIR}/framework/autograder/include")
if(symbol_targets)
  add_dependencies(cs550_lab_table ${symbol_targets})
endif()
# Its declarations know the functions by their linker names only.
set_target_properties(cs550_lab_table PROPERTIES INTERPROCEDURAL_OPTIMIZATION OFF)
