# Tests of the installed engine. With sanitizers, its users would have to link their libraries too.
if(TARGET cs550_package AND NOT CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize")
  add_test(NAME install.DropABox
           COMMAND "${CMAKE_COMMAND}" "-DBUILD=${PROJECT_BINARY_DIR}" "-DSCRATCH=${PROJECT_BINARY_DIR}/install_test"
                   "-DEXAMPLE=${CMAKE_CURRENT_LIST_DIR}/drop_a_box" "-DCXX=${CMAKE_CXX_COMPILER}"
                   "-DGENERATOR=${CMAKE_GENERATOR}" -P "${CMAKE_CURRENT_LIST_DIR}/check_install.cmake")
  set_tests_properties(install.DropABox PROPERTIES LABELS install TIMEOUT 300)
endif()
