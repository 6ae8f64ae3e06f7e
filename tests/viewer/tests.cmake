add_test(NAME viewer.IsLeftOutWhereItCannotBeBuilt
  COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DSCRATCH=${PROJECT_BINARY_DIR}/left_out"
  "-DCOMPILER=${CMAKE_CXX_COMPILER}" -P "${PROJECT_SOURCE_DIR}/tests/viewer/left_out_test.cmake")
set_tests_properties(viewer.IsLeftOutWhereItCannotBeBuilt PROPERTIES LABELS viewer)

# Tests that run the viewer. Builds with sanitizers leave them out, because the OpenGL driver leaks.
if(CMAKE_CXX_FLAGS_DEBUG MATCHES "fsanitize" OR NOT CS550_HAS_VIEWER)
  return()
endif()
cs550_add_own_tests(viewer cs550_viewer_parts)
target_compile_definitions(tests_viewer PRIVATE
  CS550_VIEWER_REFERENCES="${PROJECT_SOURCE_DIR}/tests/viewer/references"
  CS550_VIEWER_PROGRAM="$<TARGET_FILE:cs550_viewer>")

add_dependencies(tests_viewer cs550_viewer)

# The viewer on the starters, as a student sees it on the first day. It needs labs/.
foreach(number IN LISTS CS550_LABS)
  if(NOT TARGET lab${number}_stub_code)
    return()
  endif()
endforeach()
cs550_add_viewer(viewer_on_starters)
foreach(number IN LISTS CS550_LABS)
  cs550_link_lab(viewer_on_starters ${number} stub)
endforeach()
add_dependencies(tests_viewer viewer_on_starters)
target_compile_definitions(tests_viewer PRIVATE
  CS550_VIEWER_ON_STARTERS="$<TARGET_FILE:viewer_on_starters>")

# The page of a running scene on the starters, without a picture
add_executable(tests_starters "${PROJECT_SOURCE_DIR}/tests/viewer/starters/world_page_test.cpp")
target_link_libraries(tests_starters PRIVATE cs550_pages cs550_warnings GTest::gtest_main)
cs550_link_labs(tests_starters stub)
cs550_discover_tests(tests_starters viewer "*" viewer 120 0)
