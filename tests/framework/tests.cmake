# framework.SummationOrder: results without Eigen's vector code have the bits of those with it.
foreach(form vectorised scalar)
  add_executable(summation_order_${form} "${CMAKE_CURRENT_LIST_DIR}/summation_order/print_bits.cpp")
  target_link_libraries(summation_order_${form} PRIVATE cs550_contract cs550_warnings)
endforeach()
target_compile_definitions(summation_order_scalar PRIVATE EIGEN_DONT_VECTORIZE)
add_dependencies(tests_framework summation_order_vectorised summation_order_scalar)
add_test(NAME framework.SummationOrder
         COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/summation_order/compare_bits.sh" "$<TARGET_FILE:summation_order_vectorised>"
                 "$<TARGET_FILE:summation_order_scalar>")
set_tests_properties(framework.SummationOrder PROPERTIES LABELS framework TIMEOUT 60)
