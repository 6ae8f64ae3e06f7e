# A lab is found by its number and topic. Its code has up to seven variants, each a library
# labN_<variant>_code:
#   student    labs/labN_topic/*.cpp
#   sanitized  the same files, compiled with the sanitizers
#   debugged   the same files, compiled for gdb
#   assembled  the same files; one that does not compile counts as empty
#   stub       .starters/labN_topic/*.cpp in a students' copy, else labs/labN_topic/*.cpp
#   reference  solutions/labN_topic/*.cpp
#   fast       solutions/labN_topic/fast/*.cpp: faster forms of some functions of the reference
#
#   cs550_lab(number topic)                    declares a lab; CS550_LABS lists those that have code
#   cs550_link_lab(target number variant...)   links the first of the variants that exists
#   cs550_link_labs(target variant...)         the same for every lab
#
# A function comes from the first library that defines it: from `fast`, else the reference; in a
# students' copy from the student's code, else the stub.
#
# These are shared libraries. Each uses its own helpers (-Bsymbolic) and exports only namespace cs550,
# so helpers of different labs may have the same name. The file from which a function was loaded proves
# whose it is (whose_code.hpp). Link-time optimisation needs object files, and the linker of macOS is
# different. In these cases the objects are linked, without isolation.
if(APPLE OR CS550_LTO)
  set(CS550_ISOLATE_LABS FALSE)
else()
  set(CS550_ISOLATE_LABS TRUE)
endif()
set(CS550_LABS "")
set(lab_folder "${PROJECT_BINARY_DIR}/labs")
set(lab_exports "${lab_folder}/exports.map")
file(CONFIGURE OUTPUT "${lab_exports}" CONTENT "{ global: _ZN5cs550*; _ZNK5cs550*; local: *; };\n")

set(lab_headers <cs550/math.hpp> <vector>
                "${PROJECT_SOURCE_DIR}/framework/autograder/common_expressions.hpp")
cs550_precompiled_headers(precompiled_for_labs HEADERS ${lab_headers}
  LIBRARIES cs550_contract cs550_isolable cs550_student_warnings)
cs550_precompiled_headers(precompiled_for_sanitized_labs HEADERS ${lab_headers}
  LIBRARIES cs550_contract cs550_isolable cs550_student_warnings cs550_sanitizers)
# The compiler accepts a precompiled header only with the same options.
if(CS550_PCH AND CS550_ISOLATE_LABS)
  set_target_properties(precompiled_for_labs precompiled_for_sanitized_labs PROPERTIES
                        POSITION_INDEPENDENT_CODE ON)
endif()

macro(cs550_lab number topic)
  set(CS550_LAB${number}_NAME lab${number}_${topic})
  cs550_add_lab(${number} lab${number}_${topic})
  if(TARGET lab${number}_stub_code OR TARGET lab${number}_reference_code)
    list(APPEND CS550_LABS ${number})
  else()
    message(STATUS "Lab ${number} (${topic}) has no code yet: skipped")
  endif()
endmacro()

function(cs550_add_lab number name)
  set(solution "${PROJECT_SOURCE_DIR}/solutions/${name}")
  file(GLOB student CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/labs/${name}/*.cpp")
  list(FILTER student EXCLUDE REGEX "/my_tests\\.cpp$")  # tests of the student's own (graded_tests.cmake)
  file(GLOB stub CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/.starters/${name}/*.cpp")
  file(GLOB reference CONFIGURE_DEPENDS "${solution}/*.cpp")
  file(GLOB fast CONFIGURE_DEPENDS "${solution}/fast/*.cpp")
  if(NOT stub)
    set(stub "${student}")
  endif()

  foreach(variant student assembled)
    cs550_add_lab_code(${number} ${variant} ${student})
    cs550_compile_as_student(${number} ${variant} precompiled_for_labs)
  endforeach()
  cs550_add_lab_code(${number} sanitized ${student})
  cs550_compile_as_student(${number} sanitized precompiled_for_sanitized_labs cs550_sanitizers)
  cs550_add_lab_code(${number} debugged ${student})
  if(TARGET lab${number}_debugged_code)
    target_link_libraries(lab${number}_debugged_code PRIVATE cs550_student_warnings)
    target_compile_options(lab${number}_debugged_code PRIVATE -O0 -g)
  endif()
  cs550_add_lab_code(${number} stub ${stub})
  cs550_add_lab_code(${number} reference ${reference})
  cs550_add_lab_code(${number} fast ${fast})
  if(TARGET lab${number}_fast_code)
    target_include_directories(lab${number}_fast_code PRIVATE "${PROJECT_SOURCE_DIR}/framework")
    # Without optimisation, vector code in small functions is a hundred times slower.
    target_compile_options(lab${number}_fast_code PRIVATE -O3 -fno-math-errno)
  endif()
  set(given_variants reference fast)
  if(CS550_STUDENTS_COPY)
    cs550_compile_as_student(${number} stub precompiled_for_labs)
  else()
    list(APPEND given_variants stub)
  endif()
  foreach(variant IN LISTS given_variants)
    if(TARGET lab${number}_${variant}_code)
      target_link_libraries(lab${number}_${variant}_code PRIVATE cs550_warnings)
      target_compile_options(lab${number}_${variant}_code PRIVATE -Wmissing-declarations)
    endif()
  endforeach()

  if(CS550_STUDENTS_COPY)
    if(student AND CS550_ISOLATE_LABS)
      cs550_tolerate_mistakes(lab${number}_assembled_code)
    endif()
    # Messages name the files that students edit, wherever the starters are. The last mapping wins.
    set(as_edited_file "-ffile-prefix-map=${PROJECT_SOURCE_DIR}/.starters/=labs/"
                       "-ffile-prefix-map=${way_to_root}/.starters/=labs/")
    set_source_files_properties(${stub} PROPERTIES COMPILE_OPTIONS "${as_edited_file}")
  endif()
  # If objects are linked, another definition can replace this one only if this one is weak.
  if(fast AND NOT CS550_ISOLATE_LABS)
    target_compile_options(lab${number}_reference_code PRIVATE "SHELL:-include \"${solution}/fast/replaced.hpp\"")
  endif()
endfunction()

function(cs550_add_lab_code number variant)
  if(NOT ARGN)
    return()
  endif()
  set(target lab${number}_${variant}_code)
  if(CS550_ISOLATE_LABS)
    add_library(${target} SHARED EXCLUDE_FROM_ALL ${ARGN})
    target_link_options(${target} PRIVATE -Wl,-Bsymbolic "-Wl,--version-script=${lab_exports}")
    set_target_properties(${target} PROPERTIES OUTPUT_NAME lab${number}_${variant} LINK_DEPENDS "${lab_exports}"
                          LIBRARY_OUTPUT_DIRECTORY "${lab_folder}")
  else()
    add_library(${target} OBJECT EXCLUDE_FROM_ALL ${ARGN})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)  # for the installed library
  endif()
  # Labs call functions of the engine, which is linked into the executable after them.
  target_link_libraries(${target} PRIVATE cs550_contract cs550_isolable 
    INTERFACE $<BUILD_INTERFACE:cs550_engine>)
endfunction()

function(cs550_compile_as_student number variant precompiled)
  if(TARGET lab${number}_${variant}_code)
    target_link_libraries(lab${number}_${variant}_code PRIVATE cs550_student_warnings ${ARGN})
    cs550_precompile(lab${number}_${variant}_code ${precompiled})
  endif()
endfunction()

# A lab that does not compile is treated as empty, and the first of several definitions is used, so
# that one lab cannot block the others.
function(cs550_tolerate_mistakes target)
  set(launcher sh "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/empty_object_on_error.sh" ${CMAKE_CXX_COMPILER_LAUNCHER})
  set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${launcher}")
  target_link_options(${target} PRIVATE -Wl,-z,muldefs)
endfunction()

# The first of the requested variants that the lab has.
function(cs550_first_variant result number)
  foreach(variant IN LISTS ARGN)
    if(TARGET lab${number}_${variant}_code)
      set(${result} ${variant} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "lab ${number} has no code among: ${ARGN}")
endfunction()

function(cs550_link_lab target number)
  cs550_first_variant(variant ${number} ${ARGN})
  target_link_libraries(${target} PRIVATE lab${number}_${variant}_code)
  if(variant STREQUAL "fast")
    target_link_libraries(${target} PRIVATE lab${number}_reference_code)
  elseif(variant MATCHES "^(student|sanitized|debugged|assembled)$" AND CS550_STUDENTS_COPY AND CS550_ISOLATE_LABS)
    target_link_libraries(${target} PRIVATE lab${number}_stub_code)
    # One file of another lab may call a helper in a file that does not compile. Only a test that needs it fails.
    target_link_options(${target} PRIVATE -Wl,--allow-shlib-undefined)
  endif()
  if(CS550_ISOLATE_LABS)
    target_link_options(${target} PRIVATE -Wl,--no-as-needed)  # a lab may be called only by another lab
  endif()
endfunction()

function(cs550_link_labs target)
  foreach(number IN LISTS CS550_LABS)
    cs550_link_lab(${target} ${number} ${ARGN})
  endforeach()
endfunction()
