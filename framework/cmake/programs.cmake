# cs550: the program behind ./cs550, linked with the fast kernels or, without them, the reference.
# cs550_student: the same program, linked with the student's labs.
file(GLOB_RECURSE cli_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/cli/*.cpp")
if(NOT CS550_HAS_GRADEBOOK)
  list(REMOVE_ITEM cli_sources "${PROJECT_SOURCE_DIR}/framework/cli/verbs/grade.cpp")
endif()

function(cs550_add_program target output_name)
  add_executable(${target} ${cli_sources})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${output_name})
  target_link_libraries(${target} PRIVATE cs550_engine cs550_drawing cs550_files CLI11::CLI11 fmt::fmt
                        nlohmann_json::nlohmann_json Threads::Threads cs550_warnings)
  target_compile_definitions(${target} PRIVATE CS550_HAS_VIEWER=$<BOOL:${CS550_HAS_VIEWER}>
                             CS550_HAS_GRADEBOOK=$<BOOL:${CS550_HAS_GRADEBOOK}>
                             CS550_VERSION="${PROJECT_VERSION}")
  if(CS550_HAS_GRADEBOOK)
    target_link_libraries(${target} PRIVATE cs550_gradebook)
  endif()
endfunction()

cs550_add_program(cs550_cli cs550)
cs550_link_labs(cs550_cli fast reference stub)

cs550_add_program(cs550_cli_student cs550_student)
cs550_link_labs(cs550_cli_student assembled reference)
set_target_properties(cs550_cli_student PROPERTIES EXCLUDE_FROM_ALL TRUE)
