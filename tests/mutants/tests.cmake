# mutant.LabN: the wrong solutions of labN.json lose their points, see run_mutants.py.
foreach(number IN LISTS CS550_LABS)
  if(TARGET lab${number}_reference AND EXISTS "${CMAKE_CURRENT_LIST_DIR}/lab${number}.json")
    add_test(NAME mutant.Lab${number}
             COMMAND python3 "${CMAKE_CURRENT_LIST_DIR}/run_mutants.py"
                     --build "${PROJECT_BINARY_DIR}" --lab ${number})
    set_tests_properties(mutant.Lab${number} PROPERTIES LABELS "mutant;lab${number}"
                         PROCESSORS 2 RESOURCE_LOCK build_folder TIMEOUT 3600)
  endif()
endforeach()
