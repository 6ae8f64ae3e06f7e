# A lab is found by its number and topic. Up to six variants of its code exist:
#   student    labs/labN_topic/*.cpp
#   sanitized  the same files, watched by the sanitizers
#   assembled  the same files; where one does not compile or a function lacks, a pristine stub
#   stub       .starters/labN_topic/*.cpp in a students' copy, else labs/labN_topic/*.cpp
#   reference  solutions/labN_topic/*.cpp
#   fast       the reference, where solutions/labN_topic/fast/*.cpp replaces the files of the same name
# Each becomes one object file that exports nothing but the functions of the contract, so that two
# labs with helpers of the same name cannot mix, and whose code can be told from any other's.
#
#   cs550_lab(number topic)              declares the lab and the variants whose sources exist
#   cs550_has_variant(var number variant)
#   cs550_lab_objects(var number variant)     what an executable adds to its sources
# CS550_LABS lists the numbers of the labs that exist.

include(isolation_tools)
set(isolation_scripts "${CMAKE_CURRENT_LIST_DIR}")
set(lab_folder "${PROJECT_BINARY_DIR}/labs")

set(lab_headers <cs550/math.hpp> <vector> "${CMAKE_CURRENT_LIST_DIR}/common_expressions.hpp")
cs550_precompiled_headers(precompiled_for_labs HEADERS ${lab_headers}
  LIBRARIES cs550_contract cs550_isolable cs550_student_warnings)
cs550_precompiled_headers(precompiled_for_sanitized_labs HEADERS ${lab_headers}
  LIBRARIES cs550_contract cs550_isolable cs550_student_warnings cs550_sanitizers)

macro(cs550_lab number topic)
  cs550_find_lab(${number} ${topic})
  if(CS550_LAB${number}_VARIANTS)
    list(APPEND CS550_LABS ${number})
    cs550_add_lab_objects(${number})
  else()
    message(STATUS "Lab ${number} (${topic}) has no code yet: skipped")
  endif()
endmacro()

# Sets CS550_LABn_TOPIC, _NAME, _VARIANTS and for each variant _<variant>_SOURCES.
macro(cs550_find_lab number topic)
  set(lab CS550_LAB${number})
  set(${lab}_TOPIC ${topic})
  set(${lab}_NAME lab${number}_${topic})
  set(${lab}_VARIANTS "")
  set(solution "${PROJECT_SOURCE_DIR}/solutions/${${lab}_NAME}")
  file(GLOB ${lab}_student_SOURCES CONFIGURE_DEPENDS
       "${PROJECT_SOURCE_DIR}/labs/${${lab}_NAME}/*.cpp")
  file(GLOB ${lab}_stub_SOURCES CONFIGURE_DEPENDS
       "${PROJECT_SOURCE_DIR}/.starters/${${lab}_NAME}/*.cpp")
  if(NOT ${lab}_stub_SOURCES)
    set(${lab}_stub_SOURCES "${${lab}_student_SOURCES}")
  endif()
  file(GLOB ${lab}_reference_SOURCES CONFIGURE_DEPENDS "${solution}/*.cpp")
  cs550_find_fast_sources(${lab}_fast_SOURCES "${solution}" "${${lab}_reference_SOURCES}")
  set(${lab}_sanitized_SOURCES "${${lab}_student_SOURCES}")
  set(${lab}_assembled_SOURCES "${${lab}_student_SOURCES}")
  foreach(variant student sanitized assembled stub reference fast)
    if(${lab}_${variant}_SOURCES)
      list(APPEND ${lab}_VARIANTS ${variant})
    endif()
  endforeach()
endmacro()

# Empty where there is nothing faster than the reference.
function(cs550_find_fast_sources result solution reference_sources)
  file(GLOB sources CONFIGURE_DEPENDS "${solution}/fast/*.cpp")
  if(sources)
    foreach(file IN LISTS reference_sources)
      cmake_path(GET file FILENAME name)
      if(NOT EXISTS "${solution}/fast/${name}")
        list(APPEND sources "${file}")
      endif()
    endforeach()
  endif()
  set(${result} "${sources}" PARENT_SCOPE)
endfunction()

function(cs550_has_variant result number variant)
  if("${variant}" IN_LIST CS550_LAB${number}_VARIANTS)
    set(${result} TRUE PARENT_SCOPE)
  else()
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()

# The assembled engine falls back on the stub, where that is other files than the student's.
function(cs550_has_fallback result number variant)
  set(lab CS550_LAB${number})
  if(variant STREQUAL "assembled" AND CS550_ISOLATE_LABS
     AND NOT "${${lab}_stub_SOURCES}" STREQUAL "${${lab}_student_SOURCES}")
    set(${result} TRUE PARENT_SCOPE)
  else()
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()

function(cs550_add_lab_objects number)
  foreach(variant IN LISTS CS550_LAB${number}_VARIANTS)
    cs550_compile_lab(${number} ${variant})
  endforeach()
  if(CS550_ISOLATE_LABS)
    cs550_list_contract_symbols(${number})
    foreach(variant IN LISTS CS550_LAB${number}_VARIANTS)
      cs550_isolate_lab(${number} ${variant})
    endforeach()
  endif()
endfunction()

function(cs550_compile_lab number variant)
  set(target lab${number}_${variant}_code)
  add_library(${target} OBJECT EXCLUDE_FROM_ALL ${CS550_LAB${number}_${variant}_SOURCES})
  target_link_libraries(${target} PRIVATE cs550_contract cs550_isolable)
  if(variant STREQUAL "sanitized")
    target_link_libraries(${target} PRIVATE cs550_student_warnings cs550_sanitizers)
    cs550_precompile(${target} precompiled_for_sanitized_labs)
  elseif(variant MATCHES "^(student|assembled)$")
    target_link_libraries(${target} PRIVATE cs550_student_warnings)
    cs550_precompile(${target} precompiled_for_labs)
  else()
    target_link_libraries(${target} PRIVATE cs550_warnings)
    target_compile_options(${target} PRIVATE -Wmissing-declarations)
  endif()
  if(variant STREQUAL "stub")
    # It speaks of the files that are to be edited, wherever they were kept. The last mapping wins.
    set(as_edited_file "-ffile-prefix-map=${PROJECT_SOURCE_DIR}/.starters/=labs/"
                       "-ffile-prefix-map=${way_to_root}/.starters/=labs/")
    set_source_files_properties(${CS550_LAB${number}_stub_SOURCES} PROPERTIES
                                COMPILE_OPTIONS "${as_edited_file}")
  endif()
  cs550_has_fallback(has_fallback ${number} ${variant})
  if(has_fallback)
    set(launcher sh "${isolation_scripts}/empty_object_on_error.sh" ${CMAKE_CXX_COMPILER_LAUNCHER})
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${launcher}")
  endif()
endfunction()

# A precompiled header counts among a target's objects.
function(cs550_object_files result target)
  set(${result} "$<FILTER:$<TARGET_OBJECTS:${target}>,INCLUDE,\\.o$>" PARENT_SCOPE)
endfunction()

# labs/labN.symbols: the functions that the lab defines, by the reference or else the stub.
function(cs550_list_contract_symbols number)
  cs550_has_variant(has_reference ${number} reference)
  if(has_reference)
    set(authority lab${number}_reference_code)
  else()
    set(authority lab${number}_stub_code)
  endif()
  cs550_object_files(objects ${authority})
  add_custom_command(
    OUTPUT "${lab_folder}/lab${number}.symbols"
    COMMAND "${CMAKE_COMMAND}" "-DNM=${CMAKE_NM}" "-DOBJECTS=${objects}"
            "-DOUTPUT=${lab_folder}/lab${number}.symbols"
            -P "${isolation_scripts}/list_contract_symbols.cmake"
    DEPENDS "${objects}" "${isolation_scripts}/list_contract_symbols.cmake"
    COMMENT "Listing the functions of lab ${number}"
    VERBATIM)
  add_custom_target(lab${number}_symbols DEPENDS "${lab_folder}/lab${number}.symbols")
  add_dependencies(lab${number}_symbols ${authority})
endfunction()

function(cs550_isolate_lab number variant)
  set(output "${lab_folder}/lab${number}_${variant}.o")
  set(fallback "")
  cs550_has_fallback(has_fallback ${number} ${variant})
  if(has_fallback)
    set(fallback "${lab_folder}/lab${number}_stub.o")
  endif()
  set(script "${isolation_scripts}/isolate_object.cmake")
  cs550_object_files(objects lab${number}_${variant}_code)
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DLINKER=${CS550_BFD_LINKER}" "-DOBJCOPY=${CMAKE_OBJCOPY}"
            "-DNM=${CMAKE_NM}" "-DLAB=${number}" "-DVARIANT=${variant}"
            "-DSOURCES=${CS550_LAB${number}_${variant}_SOURCES}" "-DROOT=${PROJECT_SOURCE_DIR}"
            "-DOBJECTS=${objects}" "-DSYMBOLS=${lab_folder}/lab${number}.symbols"
            "-DFALLBACK=${fallback}" "-DOUTPUT=${output}" -P "${script}"
    DEPENDS "${objects}" "${lab_folder}/lab${number}.symbols"
            "${script}" ${fallback}
    COMMENT "Isolating lab ${number} (${variant})"
    VERBATIM)
  # One owner of the rule, whatever the number of executables that link the file.
  add_custom_target(lab${number}_${variant}_object DEPENDS "${output}")
  add_dependencies(lab${number}_${variant}_object lab${number}_symbols
                   lab${number}_${variant}_code)
  if(has_fallback)
    add_dependencies(lab${number}_${variant}_object lab${number}_stub_object)
  endif()
endfunction()
