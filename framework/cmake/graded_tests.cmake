# For each lab with tests: one executable per variant of its code,
#   labN_student  labN_sanitized  labN_debugged  labN_reference  labN_fast  labN_stub
# and one ctest test per graded test of the reference and of `fast`, `reference.Lab3.Name`, from the lab's
# manifest.json. student_tests.cmake adds those of the student's code.
# The student's and the stub are not part of `all`, so that a broken lab file blocks nothing else.
include(manifests)

set(result_folder "${PROJECT_BINARY_DIR}/results")
add_custom_target(update_manifests)

# Helpers shared by tests, and the libraries used as oracles. cs550_test_support adds the recorded meshes.
file(GLOB helper_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/helpers/*.cpp")
set(support_sources ${helper_sources})
list(FILTER support_sources INCLUDE REGEX "/(fixtures|recorded_meshes)\\.cpp$")
list(REMOVE_ITEM helper_sources ${support_sources})
add_library(cs550_test_helpers STATIC ${helper_sources})
target_link_libraries(cs550_test_helpers PRIVATE cs550_warnings fmt::fmt
  PUBLIC cs550_engine cs550_drawing cs550_autograder GTest::gtest PkgConfig::ccd cereal::cereal)
cs550_unity(cs550_test_helpers 16)
cs550_optimise_little(cs550_test_helpers)
add_library(cs550_test_support STATIC ${support_sources})
target_link_libraries(cs550_test_support PUBLIC cs550_test_helpers cs550_mesh_files PRIVATE cs550_warnings)
cs550_unity(cs550_test_support 16)
cs550_optimise_little(cs550_test_support)
# The labs whose tests need no recorded mesh.
set(labs_without_meshes 1 6 7)
target_include_directories(cs550_test_helpers PUBLIC "${PROJECT_SOURCE_DIR}/tests")
target_compile_definitions(cs550_test_helpers
  PRIVATE CS550_PICTURES_DIR="${PROJECT_SOURCE_DIR}/build/results/pictures"
  PUBLIC CS550_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/fixtures"
         CS550_ASSETS="${PROJECT_SOURCE_DIR}/framework/assets")

# The functions of every lab, from the reference or, without one, the stub.
set(lab_functions "${lab_folder}/lab_functions.inc")
set(contract_code "")
if(CS550_ISOLATE_LABS)
  foreach(number IN LISTS CS550_LABS)
    cs550_first_variant(variant ${number} reference stub)
    list(APPEND contract_code lab${number}_${variant}_code)
  endforeach()
endif()
list(TRANSFORM contract_code REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE contract_libraries)
add_custom_command(OUTPUT "${lab_functions}"
  COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/list_lab_functions.sh" "${CMAKE_NM}" "${lab_functions}" ${contract_libraries}
  DEPENDS ${contract_code} "${CMAKE_CURRENT_LIST_DIR}/list_lab_functions.sh" VERBATIM)

# The main of every graded executable.
file(GLOB runner_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/autograder/runner/*.cpp")
add_library(cs550_graded_main OBJECT EXCLUDE_FROM_ALL ${runner_sources} "${lab_functions}")
target_include_directories(cs550_graded_main PRIVATE "${lab_folder}")
target_link_libraries(cs550_graded_main PUBLIC cs550_autograder cs550_files ${CMAKE_DL_LIBS} PRIVATE cs550_warnings)
cs550_unity(cs550_graded_main 16)

# labN_my_tests: tests that the student has written, labs/labN_topic/my_tests.cpp, on the student's own code.
function(cs550_add_my_tests number)
  file(GLOB source CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/labs/${CS550_LAB${number}_NAME}/my_tests.cpp")
  if(NOT source OR NOT TARGET lab${number}_student_code)
    return()
  endif()
  add_executable(lab${number}_my_tests EXCLUDE_FROM_ALL "${source}")
  target_link_libraries(lab${number}_my_tests PRIVATE cs550_scenes GTest::gtest_main)
  cs550_link_lab(lab${number}_my_tests ${number} student)
  foreach(other IN LISTS CS550_LABS)
    if(NOT other EQUAL number)
      cs550_link_lab(lab${number}_my_tests ${other} reference assembled stub)
    endif()
  endforeach()
endfunction()

function(cs550_add_graded_lab number)
  set(folder "${PROJECT_SOURCE_DIR}/tests/${CS550_LAB${number}_NAME}")
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp" "${folder}/hidden/*.cpp")
  if(NOT sources)
    message(STATUS "Lab ${number} has no graded tests yet")
    return()
  endif()
  # Compiled once and linked with every variant.
  add_library(lab${number}_tests OBJECT EXCLUDE_FROM_ALL ${sources})
  set(helpers cs550_test_support)
  if(number IN_LIST labs_without_meshes)
    set(helpers cs550_test_helpers)
  endif()
  target_link_libraries(lab${number}_tests PUBLIC ${helpers} PRIVATE cs550_warnings)
  # Two batches for two cores.
  list(LENGTH sources half)
  math(EXPR half "(${half} + 1) / 2")
  cs550_unity(lab${number}_tests ${half})

  cs550_read_manifest(${number})
  foreach(variant student sanitized debugged reference fast stub)
    if(TARGET lab${number}_${variant}_code)
      cs550_add_graded_executable(${number} ${variant})
      if(variant MATCHES "^(reference|fast)$")
        cs550_register_graded_tests(${number} ${variant})
      endif()
    endif()
  endforeach()
  cs550_add_manifest_update(${number})
endfunction()

# The other labs are the reference, so that a mistake is marked only once. A students' copy has no
# reference and links the student's other labs.
function(cs550_add_graded_executable number variant)
  set(target lab${number}_${variant})
  add_executable(${target})
  target_link_libraries(${target} PRIVATE lab${number}_tests cs550_graded_main)
  cs550_link_lab(${target} ${number} ${variant})
  foreach(other IN LISTS CS550_LABS)
    if(NOT other EQUAL number)
      cs550_link_lab(${target} ${other} reference assembled stub)
    endif()
  endforeach()
  if(variant STREQUAL "sanitized")
    target_link_libraries(${target} PRIVATE cs550_sanitizers)
  endif()
  if(variant MATCHES "^(student|sanitized|debugged|stub)$")
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endif()
endfunction()

# Tests are registered from the manifest, not discovered. So ctest knows them before the program is
# built, and never runs a student's code to list them. Exit code 77: blocked by an earlier lab.
function(cs550_register_graded_tests number variant)
  foreach(test IN LISTS CS550_LAB${number}_TESTS)
    set(name "${variant}.Lab${number}.${test}")
    add_test(NAME ${name} COMMAND lab${number}_${variant} "--gtest_filter=Lab${number}.${test}"
             --results "${result_folder}/${variant}/Lab${number}.${test}.json"
             WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77
      LABELS "lab${number};${variant};${CS550_LAB${number}_${test}_LABELS}"
      TIMEOUT ${CS550_LAB${number}_${test}_TIMEOUT})
  endforeach()
endfunction()

foreach(number IN LISTS CS550_LABS)
  cs550_add_graded_lab(${number})
  cs550_add_my_tests(${number})
endforeach()
