# With the label `mutant`:
#   mutant.LabN   known mistakes lose points, see run_mutants.py
#   order.LabN    the steps can be written in the order of labN.json, see check_order.py
#   earlier.LabN  earlier_labs.json is up to date, see record_earlier_labs.py
function(cs550_add_mutant_test name script number)
  add_test(NAME ${name}.Lab${number}
           COMMAND python3 "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${script}"
                   --build "${PROJECT_BINARY_DIR}" --lab ${number})
  set_tests_properties(${name}.Lab${number} PROPERTIES LABELS "mutant;lab${number}"
                       PROCESSORS 2 RESOURCE_LOCK build_folder TIMEOUT 3600)
endfunction()

foreach(number IN LISTS CS550_LABS)
  if(TARGET lab${number}_reference AND EXISTS "${CMAKE_CURRENT_LIST_DIR}/lab${number}.json")
    cs550_add_mutant_test(mutant run_mutants.py ${number})
    cs550_add_mutant_test(order check_order.py ${number})
    if(CS550_ISOLATE_LABS)
      cs550_add_mutant_test(earlier record_earlier_labs.py ${number})
    endif()
  endif()
endforeach()
