# A picture of a failing test must not depend on the code that fails.
if(CS550_ISOLATE_LABS)
  add_test(NAME drawing.CallsNoLabFunction
           COMMAND "${CMAKE_COMMAND}" "-DNM=${CMAKE_NM}" "-DARCHIVE=$<TARGET_FILE:cs550_drawing>"
                   "-DLAB_FUNCTIONS=${lab_functions}"
                   -P "${CMAKE_CURRENT_LIST_DIR}/check_draws_only.cmake")
  set_tests_properties(drawing.CallsNoLabFunction PROPERTIES LABELS drawing TIMEOUT 60)
endif()
