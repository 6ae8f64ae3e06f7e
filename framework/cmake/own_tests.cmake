# The framework's own tests: one executable per folder of tests/, such as `tests_engine`. They run on
# the fast kernels or, without these, on the reference. A test has the label of its folder. If its
# name ends in Long or Soak, it has the label long or soak instead, because gtest_discover_tests()
# supports only one label.
#
# In a students' copy, tests that need a missing reference are skipped.
include(GoogleTest)
include(browser)
set(skip_unwritten "")
foreach(number IN LISTS CS550_LABS)
  if(NOT TARGET lab${number}_reference_code)
    set(skip_unwritten SKIP_REGULAR_EXPRESSION "not implemented: L[0-9]")
  endif()
endforeach()

function(cs550_add_own_tests folder)
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp")
  if(NOT sources)
    return()
  endif()
  set(target tests_${folder})
  add_executable(${target} ${sources})
  target_link_libraries(${target} PRIVATE cs550_test_support cs550_scenes cs550_warnings GTest::gtest_main
                        ${ARGN})
  cs550_link_labs(${target} fast reference stub)
  cs550_unity(${target} 6)
  cs550_discover_tests(${target} ${folder} "-*Long:*Long/*:*Soak:*Soak/*" "${folder}" 120 0)
  cs550_discover_tests(${target} ${folder} "*Long:*Long/*" long 600 10)
  cs550_discover_tests(${target} ${folder} "*Soak:*Soak/*" soak 7200 10)
endfunction()

# ctest runs the executable to list its tests. The limits that a user has set for scenes do not hold for them.
# `cost`: about how many seconds a test takes. The first time that tests run, ctest knows only these costs. It
# begins with the highest: a long test that began last would run alone.
function(cs550_discover_tests target folder filter label timeout cost)
  set(limits BODIES HULL_POINTS TOTAL_POINTS PAIRS MEMORY_MB)
  list(TRANSFORM limits REPLACE "(.+)" "CS550_MAX_\\1=unset:")
  list(JOIN limits "\\;" limits)  # a list as one value of PROPERTIES
  gtest_discover_tests(${target} TEST_PREFIX "${folder}." TEST_FILTER "${filter}" NO_PRETTY_VALUES
    DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    PROPERTIES LABELS ${label} TIMEOUT ${timeout} COST ${cost} ENVIRONMENT_MODIFICATION "${limits}" ${skip_unwritten})
endfunction()

foreach(folder framework serialisation engine drawing autograder)
  cs550_add_own_tests(${folder})
endforeach()
cs550_add_own_tests(milestones cs550_milestones)
cs550_add_own_tests(soak nlohmann_json::nlohmann_json fmt::fmt)

# Further tests of each folder. Some of the files are not in the students' copy.
foreach(folder framework engine drawing autograder gradebook install viewer mutants cli docs benchmarks fuzz)
  include("${PROJECT_SOURCE_DIR}/tests/${folder}/tests.cmake" OPTIONAL)
endforeach()

if(EXISTS "${PROJECT_SOURCE_DIR}/tests/fixtures/CMakeLists.txt")
  add_subdirectory("${PROJECT_SOURCE_DIR}/tests/fixtures" "${PROJECT_BINARY_DIR}/fixtures")
endif()
