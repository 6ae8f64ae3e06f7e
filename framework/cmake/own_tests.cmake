# The framework's own tests: one executable per folder of tests/, `tests_engine`, run on the
# reference labs. A test whose name ends in Long or Soak carries that label.
include(GoogleTest)

function(cs550_add_own_tests folder)
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp")
  if(NOT sources)
    return()
  endif()
  set(target tests_${folder})
  add_executable(${target} ${sources})
  target_link_libraries(${target} PRIVATE cs550_test_support cs550_warnings GTest::gtest_main
                        ${ARGN})
  cs550_link_reference_labs(${target})
  cs550_discover_own_tests(${target} ${folder} "-*Long:*Soak" 120 "")
  cs550_discover_own_tests(${target} ${folder} "*Long" 600 "long")
  cs550_discover_own_tests(${target} ${folder} "*Soak" 3600 "soak")
endfunction()

function(cs550_discover_own_tests target folder filter timeout label)
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    TEST_PREFIX "${folder}." TEST_FILTER "${filter}" TEST_LIST ${target}_tests_${label}
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    PROPERTIES LABELS "${folder}$<$<NOT:$<STREQUAL:${label},>>:;${label}>" TIMEOUT ${timeout})
endfunction()

foreach(folder framework engine)
  cs550_add_own_tests(${folder})
endforeach()
