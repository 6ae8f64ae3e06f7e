# Tests of ./cs550 grade: of its parts, and of the verb on a fake of the program that grades a lab.
if(NOT CS550_HAS_GRADEBOOK)
  return()
endif()
cs550_add_own_tests(gradebook cs550_gradebook)
target_compile_definitions(tests_gradebook PRIVATE CS550_ROOT="${PROJECT_SOURCE_DIR}")
if(NOT CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize")
  add_test(NAME gradebook.verb
           COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/grade_test.py"
                   "$<TARGET_FILE:cs550_grade>" "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/grade_test")
  set_tests_properties(gradebook.verb PROPERTIES LABELS gradebook COST 40 TIMEOUT 300)
  add_test(NAME gradebook.slurm
           COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/slurm_test.sh" "$<TARGET_FILE:cs550_grade>" "${PROJECT_SOURCE_DIR}"
                   "${PROJECT_BINARY_DIR}/slurm_test")
  set_tests_properties(gradebook.slurm PROPERTIES LABELS slurm SKIP_RETURN_CODE 77 TIMEOUT 300)
  # Builds the project once more, with the judge of a lab.
  if(TARGET lab3_judge)
    add_test(NAME gradebook.gradescope
             COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/gradescope_test.sh" "$<TARGET_FILE:cs550_grade>" "${PROJECT_SOURCE_DIR}"
                     "${PROJECT_BINARY_DIR}/gradescope_test" "${CMAKE_CXX_COMPILER_LAUNCHER}")
    set_tests_properties(gradebook.gradescope PROPERTIES LABELS attack TIMEOUT 3600)
  endif()
  # Builds two labs of a students' copy.
  if(EXISTS "${PROJECT_SOURCE_DIR}/.git" AND EXISTS "${PROJECT_SOURCE_DIR}/solutions")
    add_test(NAME gradebook.classroom
             COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/classroom_test.py" "$<TARGET_FILE:cs550_cli>"
                     "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/classroom_test")
    set_tests_properties(gradebook.classroom PROPERTIES LABELS attack TIMEOUT 3600)
  endif()
  # Git cannot tell then whether labs/ has the starters: the tests also run where somebody works on them.
  set_tests_properties(gradebook.verb gradebook.slurm PROPERTIES
                       ENVIRONMENT "GIT_CEILING_DIRECTORIES=${PROJECT_SOURCE_DIR}")
  if(CS550_HAS_BROWSER)
    add_test(NAME gradebook.page
             COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/page_test.py"
                     "$<TARGET_FILE:cs550_grade>" "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/page_test")
    set_tests_properties(gradebook.page PROPERTIES LABELS gradebook TIMEOUT 300
                         ENVIRONMENT "GIT_CEILING_DIRECTORIES=${PROJECT_SOURCE_DIR}")
  endif()
endif()
