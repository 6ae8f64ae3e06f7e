# The framework's own tests: one executable per folder of tests/, `tests_engine`, run on the labs
# that the engine ships with: the fast kernels where there are any, else the reference. A test whose
# name ends in Long or Soak carries that label.
#
# ctest lists the tests when it starts, by running the executable: nothing to keep up to date. In a
# students' copy, where a lab has no reference, a test that needs it is skipped.
set(list_script "${CMAKE_CURRENT_LIST_DIR}/list_own_tests.cmake")

function(cs550_add_own_tests folder)
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp")
  if(NOT sources)
    return()
  endif()
  set(target tests_${folder})
  add_executable(${target} ${sources})
  target_link_libraries(${target} PRIVATE cs550_test_support cs550_warnings GTest::gtest_main
                        ${ARGN})
  cs550_link_fast_labs(${target})
  cs550_discover_own_tests(${target} ${folder})
endfunction()

# gtest_discover_tests keeps only the first of several labels, hence our own.
function(cs550_discover_own_tests target folder)
  set(list_file "${PROJECT_BINARY_DIR}/tests/${target}.cmake")
  file(GENERATE OUTPUT "${list_file}" CONTENT
"set(PROGRAM \"$<TARGET_FILE:${target}>\")
set(FOLDER \"${folder}\")
set(ROOT \"${PROJECT_SOURCE_DIR}\")
set(RUNS_ON_STUBS ${CS550_RUNS_ON_STUBS})
include(\"${list_script}\")
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${list_file}")
endfunction()

foreach(folder framework serialisation engine drawing autograder)
  cs550_add_own_tests(${folder})
endforeach()
cs550_add_own_tests(milestones cs550_milestones)
if(TARGET tests_drawing)
  include("${PROJECT_SOURCE_DIR}/tests/drawing/tests.cmake")
endif()
if(TARGET tests_autograder)
  include("${PROJECT_SOURCE_DIR}/tests/autograder/tests.cmake")
endif()

# Absent in the students' copy.
include("${PROJECT_SOURCE_DIR}/tests/viewer/tests.cmake" OPTIONAL)
include("${PROJECT_SOURCE_DIR}/tests/mutants/tests.cmake" OPTIONAL)

include("${PROJECT_SOURCE_DIR}/tests/cli/tests.cmake" OPTIONAL)

include("${PROJECT_SOURCE_DIR}/tests/docs/tests.cmake" OPTIONAL)

if(EXISTS "${PROJECT_SOURCE_DIR}/tests/fixtures/CMakeLists.txt")
  add_subdirectory("${PROJECT_SOURCE_DIR}/tests/fixtures" "${PROJECT_BINARY_DIR}/fixtures")
endif()

file(GLOB benchmark_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/benchmarks/*.cpp")
if(benchmark_sources AND benchmark_FOUND)
  add_executable(benchmarks EXCLUDE_FROM_ALL ${benchmark_sources})
  target_link_libraries(benchmarks PRIVATE cs550_test_support cs550_warnings
                        benchmark::benchmark_main)
  cs550_link_fast_labs(benchmarks)
endif()
