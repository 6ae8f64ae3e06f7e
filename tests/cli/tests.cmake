# Tests of the program behind ./cs550: of its parts, and of the whole, which needs a repository to
# work on.
cs550_add_own_tests(cli nlohmann_json::nlohmann_json Threads::Threads)
target_compile_definitions(tests_cli PRIVATE
  CS550_FAKE_LAB="$<TARGET_FILE:fake_lab>"
  CS550_FAKE_SANITIZED_LAB="$<TARGET_FILE:fake_sanitized_lab>")
add_dependencies(tests_cli fake_lab fake_sanitized_lab)
target_sources(tests_cli PRIVATE "${PROJECT_SOURCE_DIR}/framework/cli/crash_report.cpp"
                                 "${PROJECT_SOURCE_DIR}/framework/cli/formula_text.cpp"
                                 "${PROJECT_SOURCE_DIR}/framework/cli/graded_run.cpp"
                                 "${PROJECT_SOURCE_DIR}/framework/cli/process.cpp"
                                 "${PROJECT_SOURCE_DIR}/framework/cli/project.cpp"
                                 "${PROJECT_SOURCE_DIR}/framework/cli/terminal.cpp"
                                 "${PROJECT_SOURCE_DIR}/framework/cli/verdict.cpp")

if(EXISTS "${PROJECT_SOURCE_DIR}/.git" AND EXISTS "${PROJECT_SOURCE_DIR}/solutions")
  add_test(NAME cli.students_copy
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/students_copy_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/students_copy"
                   "${CMAKE_CXX_COMPILER_LAUNCHER}")
  set_tests_properties(cli.students_copy PROPERTIES LABELS "starter;long" TIMEOUT 900)
  add_test(NAME cli.usage
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/usage_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/usage")
  set_tests_properties(cli.usage PROPERTIES LABELS cli TIMEOUT 60)
endif()
