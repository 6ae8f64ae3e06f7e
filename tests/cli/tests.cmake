# Tests of the program behind ./cs550: its parts, and the complete program on a repository of its own.
cs550_add_own_tests(cli nlohmann_json::nlohmann_json fmt::fmt Threads::Threads)
target_compile_definitions(tests_cli PRIVATE
  CS550_FAKE_LAB="$<TARGET_FILE:fake_lab>"
  CS550_FAKE_SANITIZED_LAB="$<TARGET_FILE:fake_sanitized_lab>")
add_dependencies(tests_cli fake_lab fake_sanitized_lab)
set(cli "${PROJECT_SOURCE_DIR}/framework/cli")
target_link_libraries(tests_cli PRIVATE cs550_files)
target_sources(tests_cli PRIVATE
  "${cli}/grading/crash_report.cpp" "${cli}/grading/graded_run.cpp" "${cli}/grading/graded_tests.cpp"
  "${cli}/grading/known_causes.cpp" "${cli}/grading/lab_report.cpp" "${cli}/grading/long_tests.cpp"
  "${cli}/grading/memory_signs.cpp" "${cli}/handout/formula_text.cpp" "${cli}/handout/handout.cpp"
  "${cli}/system/build_log.cpp" "${cli}/system/draft_folder.cpp" "${cli}/system/files.cpp"
  "${cli}/system/process.cpp" "${cli}/system/project.cpp" "${cli}/system/terminal.cpp")

if(EXISTS "${PROJECT_SOURCE_DIR}/.git" AND EXISTS "${PROJECT_SOURCE_DIR}/solutions")
  add_test(NAME cli.students_copy
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/students_copy_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/students_copy"
                   "${CMAKE_CXX_COMPILER_LAUNCHER}")
  set_tests_properties(cli.students_copy PROPERTIES LABELS "starter;long" COST 30 TIMEOUT 900)
  add_test(NAME cli.course_update
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/course_update_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/course_update")
  set_tests_properties(cli.course_update PROPERTIES LABELS cli COST 24 TIMEOUT 120)
  add_test(NAME cli.use_solution
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/use_solution_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/use_solution")
  set_tests_properties(cli.use_solution PROPERTIES LABELS cli TIMEOUT 60)
  add_test(NAME cli.results
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/results_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/results_of_labs")
  set_tests_properties(cli.results PROPERTIES LABELS cli COST 70 TIMEOUT 300)
  add_test(NAME cli.devcontainer
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/devcontainer_test.sh" "${PROJECT_SOURCE_DIR}")
  set_tests_properties(cli.devcontainer PROPERTIES LABELS cli TIMEOUT 60)
  add_test(NAME cli.usage
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/usage_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/usage")
  add_test(NAME cli.launcher
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/launcher_test.sh" "${PROJECT_SOURCE_DIR}"
                   "${PROJECT_BINARY_DIR}/launcher")
  add_test(NAME cli.output
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/output_test.sh" "$<TARGET_FILE:cs550_demo>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/output")
  add_test(NAME cli.demo
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/demo_test.sh" "$<TARGET_FILE:cs550_demo>"
                   "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/demo_options")
  add_test(NAME cli.submit
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/submit_test.sh" "$<TARGET_FILE:cs550_cli>"
                   "${PROJECT_BINARY_DIR}/submit")
  add_test(NAME cli.rough
           COMMAND bash "${CMAKE_CURRENT_LIST_DIR}/rough_test.sh" "${PROJECT_SOURCE_DIR}"
                   "${PROJECT_BINARY_DIR}/rough")
  set_tests_properties(cli.rough PROPERTIES LABELS rough TIMEOUT 3600)
  set_tests_properties(cli.usage cli.launcher cli.output cli.demo cli.submit PROPERTIES LABELS cli TIMEOUT 60)
endif()
