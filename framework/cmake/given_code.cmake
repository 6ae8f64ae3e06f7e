# Compiles the files of a target in batches: most of the time that a file takes is spent on headers.
function(cs550_unity target files_in_batch)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${CS550_UNITY}
                        UNITY_BUILD_BATCH_SIZE ${files_in_batch})
endfunction()

# For code that no step of a world runs, in a release build: without link-time optimisation, which would compile it again
# for each program, and without -O3, which takes twice the time and makes g++ warn of strings without a reason.
function(cs550_optimise_little target)
  if(CS550_LTO)
    target_compile_options(${target} PRIVATE -fno-lto -O1)
  endif()
endfunction()

# The given code. It calls lab functions, which are undefined until an executable links the code of
# the labs (lab_code.cmake).
function(cs550_given_library name folders)
  list(TRANSFORM folders REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/framework/\\1/*.cpp" OUTPUT_VARIABLE patterns)
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC cs550_contract ${ARGN} PRIVATE cs550_warnings)
  # Students step through their own code and the tests. Line numbers of the rest take a tenth of its compilation.
  target_compile_options(${name} PRIVATE $<$<BOOL:${CS550_STUDENTS_COPY}>:-g0>)
  cs550_unity(${name} 16)
  if(NOT name STREQUAL "cs550_engine")
    cs550_optimise_little(${name})
  endif()
endfunction()

# Without Qhull::qhullcpp, whose qh_fprintf() would replace that of qhull_r and end the process instead of
# printing a message.
set(engine_folders contacts islands pairs parts shapes threads world)
list(TRANSFORM engine_folders PREPEND engine/)
cs550_given_library(cs550_engine "engine;${engine_folders}" Qhull::qhull_r TBB::tbb Threads::Threads)
target_compile_definitions(cs550_engine PRIVATE CS550_HAS_TBB=1)  # the browser's engine has one thread
# Files of meshes and of scenes: libraries of their own, since the tests of few labs read meshes, and of no lab scenes.
# Students would wait for the parsers.
cs550_given_library(cs550_mesh_files engine/mesh_files cs550_engine nlohmann_json::nlohmann_json
                    tinyobjloader::tinyobjloader)
cs550_given_library(cs550_scenes engine/scenes cs550_mesh_files)
# They become part of the installed shared library.
set(engine_libraries cs550_engine cs550_mesh_files cs550_scenes)
set_target_properties(${engine_libraries} PROPERTIES POSITION_INDEPENDENT_CODE ON)
foreach(library IN LISTS engine_libraries)
  target_compile_options(${library} PRIVATE -fno-semantic-interposition)
endforeach()
list(TRANSFORM engine_libraries REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE engine_objects)
# Object files of their own: a lab's fast kernels, or a judge of the grader, may replace them.
set(replaced body_sweeps contacts/contact_passes contacts/rolling_resistance world/substeps)
list(TRANSFORM replaced REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/framework/engine/\\1.cpp")
set_source_files_properties(${replaced} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# Headers of given code are included as "engine/world/stages.hpp", "drawing/palette.hpp".
target_include_directories(cs550_engine PUBLIC "${PROJECT_SOURCE_DIR}/framework")
cs550_given_library(cs550_files files)
target_include_directories(cs550_files PUBLIC "${PROJECT_SOURCE_DIR}/framework")
cs550_given_library(cs550_drawing drawing cs550_engine fmt::fmt)
cs550_given_library(cs550_autograder autograder GTest::gtest nlohmann_json::nlohmann_json)
target_include_directories(cs550_autograder PUBLIC
                           "${PROJECT_SOURCE_DIR}/framework/autograder/include")

# The folder of meshes and scenes, unless the environment variable CS550_ASSETS names another.
set_source_files_properties("${PROJECT_SOURCE_DIR}/framework/engine/scenes/assets.cpp" PROPERTIES
  COMPILE_DEFINITIONS "CS550_ASSETS_DIR=\"${PROJECT_SOURCE_DIR}/framework/assets\"")
