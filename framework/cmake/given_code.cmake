# The code that is given. It calls lab functions, which stay undefined until an executable brings the
# objects of the labs (link_labs.cmake).
function(cs550_given_library name folders)
  list(TRANSFORM folders REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/framework/\\1/*.cpp" OUTPUT_VARIABLE patterns)
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC cs550_contract ${ARGN} PRIVATE cs550_warnings)
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE cs550_contract ${ARGN})
    message(STATUS "framework/${folders} has no sources yet")
  endif()
endfunction()

cs550_given_library(cs550_engine "engine;engine/*" nlohmann_json::nlohmann_json tinyobjloader::tinyobjloader
                    Qhull::qhullcpp Qhull::qhull_r Threads::Threads)
# Headers of given code are included as "engine/world/stages.hpp", "drawing/palette.hpp".
target_include_directories(cs550_engine PUBLIC "${PROJECT_SOURCE_DIR}/framework")
cs550_given_library(cs550_drawing drawing cs550_engine)
cs550_given_library(cs550_autograder autograder GTest::gtest nlohmann_json::nlohmann_json)
target_include_directories(cs550_autograder PUBLIC
                           "${PROJECT_SOURCE_DIR}/framework/autograder/include")

# The main of every graded executable.
file(GLOB runner_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/autograder/runner/*.cpp")
add_library(cs550_graded_main OBJECT EXCLUDE_FROM_ALL ${runner_sources})
target_link_libraries(cs550_graded_main PRIVATE cs550_autograder cs550_warnings)

# Where meshes and scenes are found unless the environment variable CS550_ASSETS says otherwise.
set_source_files_properties("${PROJECT_SOURCE_DIR}/framework/engine/scenes/assets.cpp" PROPERTIES
  COMPILE_DEFINITIONS "CS550_ASSETS_DIR=\"${PROJECT_SOURCE_DIR}/framework/assets\"")
