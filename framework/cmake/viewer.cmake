# Pages are built without OpenGL and Dear ImGui, so that other programs can show them too.
cs550_given_library(cs550_isolation isolation cereal::cereal)
target_include_directories(cs550_isolation PUBLIC "${PROJECT_SOURCE_DIR}/framework")
cs550_given_library(cs550_pages "pages;pages/*" cs550_scenes cs550_drawing cs550_isolation)
set_target_properties(cs550_isolation cs550_pages PROPERTIES EXCLUDE_FROM_ALL TRUE)

# cs550_viewer is the program behind ./cs550 view, linked with the fastest code.
# cs550_viewer_student is the same with the student's labs. If a package is missing, building either
# fails with the name of the package, and everything else still builds.
set(CS550_HAS_VIEWER FALSE)
set(viewer_absence "")
if(NOT CS550_VIEWER)
  set(viewer_absence "it was switched off when this folder was configured (-DCS550_VIEWER=OFF)")
else()
  set(viewer_missing "")
  foreach(pair imgui:libimgui-dev glfw3:libglfw3-dev epoxy:libepoxy-dev stb:libstb-dev)
    string(REPLACE ":" ";" pair "${pair}")
    list(GET pair 0 module)
    list(GET pair 1 package)
    if(PkgConfig_FOUND)
      pkg_check_modules(viewer_${module} QUIET IMPORTED_TARGET ${module})
    endif()
    if(NOT viewer_${module}_FOUND)
      string(APPEND viewer_missing " ${package}")
    endif()
  endforeach()
  find_path(stb_headers stb/stb_image_write.h)
  if(viewer_stb_FOUND AND NOT stb_headers)
    string(APPEND viewer_missing " libstb-dev")
  endif()
  if(viewer_missing)
    string(CONCAT viewer_absence "it needs${viewer_missing}. On Debian and Ubuntu: "
      "./cs550 doctor --install viewer; elsewhere see README.md. Then configure again, as ./cs550 does by itself")
  endif()
endif()
if(viewer_absence)
  message(STATUS "The viewer is left out: ${viewer_absence}")
  foreach(target cs550_viewer cs550_viewer_student)
    add_custom_target(${target} VERBATIM
      COMMAND "${CMAKE_COMMAND}" -E echo "There is no viewer: ${viewer_absence}"
      COMMAND "${CMAKE_COMMAND}" -E false)
  endforeach()
  return()
endif()
set(CS550_HAS_VIEWER TRUE)

file(GLOB_RECURSE viewer_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/viewer/*.cpp")
set(viewer_main "${PROJECT_SOURCE_DIR}/framework/viewer/main.cpp")
list(REMOVE_ITEM viewer_sources "${viewer_main}")
add_library(cs550_viewer_parts STATIC EXCLUDE_FROM_ALL ${viewer_sources})
target_link_libraries(cs550_viewer_parts
  PUBLIC cs550_pages cs550_files ${CMAKE_DL_LIBS}
    PkgConfig::viewer_imgui PkgConfig::viewer_glfw3 PkgConfig::viewer_epoxy PkgConfig::viewer_stb
  PRIVATE CLI11::CLI11 cs550_warnings)
cs550_unity(cs550_viewer_parts 16)
cs550_optimise_little(cs550_viewer_parts)

function(cs550_add_viewer target)
  add_executable(${target} "${viewer_main}")
  target_link_libraries(${target} PRIVATE cs550_viewer_parts cs550_warnings)
  cs550_optimise_little(${target})
endfunction()

cs550_add_viewer(cs550_viewer)
cs550_link_labs(cs550_viewer fast reference stub)

cs550_add_viewer(cs550_viewer_student)
cs550_link_labs(cs550_viewer_student assembled reference stub)
set_target_properties(cs550_viewer_student PROPERTIES EXCLUDE_FROM_ALL TRUE)
