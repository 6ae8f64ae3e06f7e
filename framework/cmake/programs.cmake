# cs550: the program behind the command of that name, on the best code that was given.
# cs550_student: the same program on the student's labs. engine_student builds those labs alone.
file(GLOB cli_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/cli/*.cpp")

function(cs550_add_program target output_name)
  add_executable(${target} ${cli_sources})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${output_name})
  target_link_libraries(${target} PRIVATE cs550_engine cs550_drawing CLI11::CLI11
                        nlohmann_json::nlohmann_json Threads::Threads cs550_warnings)
  target_compile_definitions(${target} PRIVATE CS550_HAS_VIEWER=$<BOOL:${CS550_HAS_VIEWER}>)
endfunction()

if(cli_sources)
  cs550_add_program(cs550_cli cs550)
  cs550_link_fast_labs(cs550_cli)

  cs550_add_program(cs550_cli_student cs550_student)
  cs550_link_student_labs(cs550_cli_student)
  set_target_properties(cs550_cli_student PROPERTIES EXCLUDE_FROM_ALL TRUE)
else()
  message(STATUS "framework/cli has no sources yet")
endif()

add_custom_target(engine_student DEPENDS cs550_engine)
foreach(number IN LISTS CS550_LABS)
  if(TARGET lab${number}_assembled_object)
    add_dependencies(engine_student lab${number}_assembled_object)
  endif()
endforeach()
