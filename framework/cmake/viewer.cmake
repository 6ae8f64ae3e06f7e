# cs550_viewer: the program behind ./cs550 view, on the best code that was given.
# cs550_viewer_student: the same on the student's labs. Without their packages neither exists, and
# everything else builds.
set(CS550_HAS_VIEWER FALSE)
if(NOT CS550_VIEWER)
  return()
endif()
if(PkgConfig_FOUND)
  pkg_check_modules(viewer_packages QUIET IMPORTED_TARGET imgui glfw3 epoxy stb)
endif()
find_path(stb_headers stb/stb_image_write.h)
if(NOT viewer_packages_FOUND OR NOT stb_headers)
  message(STATUS "The viewer is left out: it needs libimgui-dev libglfw3-dev libepoxy-dev libstb-dev")
  foreach(target cs550_viewer cs550_viewer_student)
    add_custom_target(${target} VERBATIM COMMAND "${CMAKE_COMMAND}" -E echo
      "The viewer's packages were missing when this folder was configured: ./cs550 doctor --install viewer, then rm -r ${PROJECT_BINARY_DIR}"
      COMMAND "${CMAKE_COMMAND}" -E false)
  endforeach()
  return()
endif()
set(CS550_HAS_VIEWER TRUE)

file(GLOB_RECURSE viewer_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/viewer/*.cpp")
set(viewer_main "${PROJECT_SOURCE_DIR}/framework/viewer/main.cpp")
list(REMOVE_ITEM viewer_sources "${viewer_main}")
add_library(cs550_viewer_parts STATIC EXCLUDE_FROM_ALL ${viewer_sources})
target_include_directories(cs550_viewer_parts PUBLIC "${PROJECT_SOURCE_DIR}/framework")
target_link_libraries(cs550_viewer_parts
  PUBLIC cs550_engine cs550_drawing PkgConfig::viewer_packages cereal::cereal ${CMAKE_DL_LIBS}
  PRIVATE CLI11::CLI11 cs550_warnings)

function(cs550_add_viewer target)
  add_executable(${target} "${viewer_main}")
  target_link_libraries(${target} PRIVATE cs550_viewer_parts cs550_warnings)
endfunction()

cs550_add_viewer(cs550_viewer)
cs550_link_fast_labs(cs550_viewer)

cs550_add_viewer(cs550_viewer_student)
cs550_link_student_labs(cs550_viewer_student)
set_target_properties(cs550_viewer_student PROPERTIES EXCLUDE_FROM_ALL TRUE)
