# cs550: the program behind ./cs550. It needs neither the engine nor a lab. Students wait for its compilation,
# not for its speed.
file(GLOB command_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/cli/*.cpp"
     "${PROJECT_SOURCE_DIR}/framework/cli/verbs/*.cpp")
file(GLOB service_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/cli/grading/*.cpp"
     "${PROJECT_SOURCE_DIR}/framework/cli/handout/*.cpp" "${PROJECT_SOURCE_DIR}/framework/cli/system/*.cpp")
add_executable(cs550_cli ${command_sources} ${service_sources})
target_link_libraries(cs550_cli PRIVATE cs550_files CLI11::CLI11 fmt::fmt nlohmann_json::nlohmann_json
                      Threads::Threads cs550_warnings)
target_compile_definitions(cs550_cli PRIVATE CS550_VERSION="${PROJECT_VERSION}")
target_compile_options(cs550_cli PRIVATE -O0 -g0)
set_target_properties(cs550_cli PROPERTIES OUTPUT_NAME cs550)
# Two batches for two cores. Only the commands include CLI11, the most expensive header.
cs550_unity(cs550_cli 0)
set_target_properties(cs550_cli PROPERTIES UNITY_BUILD_MODE GROUP)
set_source_files_properties(${command_sources} PROPERTIES UNITY_GROUP commands)
set_source_files_properties(${service_sources} PROPERTIES UNITY_GROUP services)

# cs550_demo: the program behind ./cs550 demo, linked with the fast kernels or, without them, the reference.
# cs550_demo_student: the same program, linked with the student's labs.
file(GLOB demo_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/cli/demo/*.cpp"
     "${PROJECT_SOURCE_DIR}/framework/cli/command_line.cpp" "${PROJECT_SOURCE_DIR}/framework/cli/system/*.cpp")

function(cs550_add_demo target)
  add_executable(${target} ${demo_sources})
  target_link_libraries(${target} PRIVATE cs550_scenes cs550_files CLI11::CLI11 fmt::fmt cs550_warnings)
  target_compile_definitions(${target} PRIVATE CS550_HAS_VIEWER=$<BOOL:${CS550_HAS_VIEWER}>)
  cs550_unity(${target} 16)
  cs550_optimise_little(${target})
endfunction()

cs550_add_demo(cs550_demo)
cs550_link_labs(cs550_demo fast reference stub)

cs550_add_demo(cs550_demo_student)
cs550_link_labs(cs550_demo_student assembled reference stub)
set_target_properties(cs550_demo_student PROPERTIES EXCLUDE_FROM_ALL TRUE)
