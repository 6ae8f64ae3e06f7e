# For each lab with tests: one executable per variant of its code,
#   labN_student  labN_sanitized  labN_reference  labN_fast  labN_stub
# and one ctest test per graded test and variant, `student.Lab3.Name`, from the lab's manifest.json.
# The student's and the stub are not part of `all`: a broken lab file stops nothing else. For
# `sanitized`, as for the stub, there are no ctest tests.
include(manifests)

set(result_folder "${PROJECT_BINARY_DIR}/results")
set(CS550_GRADED_VARIANTS student sanitized reference fast stub)
add_custom_target(update_manifests)

# Helpers that tests share, and the libraries that serve as oracles.
file(GLOB support_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/helpers/*.cpp")
if(support_sources)
  add_library(cs550_test_support STATIC ${support_sources})
  set(scope PUBLIC)
  target_link_libraries(cs550_test_support PRIVATE cs550_warnings)
  target_compile_definitions(cs550_test_support PRIVATE
    CS550_PICTURES_DIR="${PROJECT_SOURCE_DIR}/build/results/pictures")
else()
  add_library(cs550_test_support INTERFACE)
  set(scope INTERFACE)
endif()
target_include_directories(cs550_test_support ${scope} "${PROJECT_SOURCE_DIR}/tests")
target_compile_definitions(cs550_test_support ${scope}
                           CS550_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/fixtures"
                           CS550_ASSETS="${PROJECT_SOURCE_DIR}/framework/assets")
target_link_libraries(cs550_test_support ${scope} cs550_engine cs550_drawing cs550_autograder
                      GTest::gtest PkgConfig::ccd cereal::cereal)

cs550_precompiled_headers(precompiled_for_tests
  LIBRARIES cs550_test_support cs550_warnings
  HEADERS <cs550/math.hpp> <cs550/graded_test.hpp>)

function(cs550_add_graded_lab number)
  set(folder "${PROJECT_SOURCE_DIR}/tests/${CS550_LAB${number}_NAME}")
  file(GLOB visible CONFIGURE_DEPENDS "${folder}/*.cpp")
  file(GLOB hidden CONFIGURE_DEPENDS "${folder}/hidden/*.cpp")
  if(NOT visible AND NOT hidden)
    message(STATUS "Lab ${number} has no graded tests yet")
    return()
  endif()

  # Compiled once, linked with every variant.
  add_library(lab${number}_tests OBJECT EXCLUDE_FROM_ALL ${visible} ${hidden})
  target_link_libraries(lab${number}_tests PRIVATE cs550_test_support cs550_warnings)
  cs550_precompile(lab${number}_tests precompiled_for_tests)

  cs550_read_manifest(${number})
  foreach(variant IN LISTS CS550_GRADED_VARIANTS)
    if(variant IN_LIST CS550_LAB${number}_VARIANTS)
      cs550_add_graded_executable(${number} ${variant})
      if(NOT variant MATCHES "^(sanitized|stub)$")
        cs550_register_graded_tests(${number} ${variant})
      endif()
    endif()
  endforeach()
  cs550_add_manifest_update(${number})
endfunction()

function(cs550_add_graded_executable number variant)
  set(target lab${number}_${variant})
  add_executable(${target} $<TARGET_OBJECTS:lab${number}_tests>
                           $<TARGET_OBJECTS:cs550_graded_main>
                           $<TARGET_OBJECTS:cs550_lab_table>)
  target_link_libraries(${target} PRIVATE cs550_test_support)
  cs550_link_lab(${target} ${number} ${variant})
  cs550_link_other_labs(${target} ${number})
  if(variant STREQUAL "sanitized")
    target_link_libraries(${target} PRIVATE cs550_sanitizers)
  endif()
  if(variant MATCHES "^(student|sanitized|stub)$")
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endif()
endfunction()

# Exit code 77: blocked by an earlier lab, neither passed nor failed.
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
endforeach()
