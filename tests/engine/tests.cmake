# A world that runs on the fast forms of labs 1, 5 and 7 must be in the same state, bit by bit, as one that
# runs on the teaching forms. The fast form of lab 4 may choose another one of several equal axes.
function(cs550_compare_forms program name label shows)
  foreach(form fast teaching)
    add_executable(${program}_${form} tests/engine/fast_forms/${program}.cpp)
    target_link_libraries(${program}_${form} PRIVATE cs550_test_support cs550_scenes cs550_warnings)
  endforeach()
  cs550_link_labs(${program}_fast fast reference stub)
  foreach(number IN LISTS CS550_LABS)
    set(variants fast reference)
    if(number MATCHES "^(1|5|7)$")
      set(variants reference)
    endif()
    cs550_link_lab(${program}_teaching ${number} ${variants})
  endforeach()
  add_test(NAME engine.${name}
           COMMAND "${CMAKE_COMMAND}" "-DFAST=$<TARGET_FILE:${program}_fast>"
                   "-DTEACHING=$<TARGET_FILE:${program}_teaching>" "-DSHOWS=${shows}"
                   -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fast_forms/compare.cmake")
  set_tests_properties(engine.${name} PROPERTIES LABELS ${label} COST 5 TIMEOUT 600)
endfunction()

if(TARGET lab7_fast_code AND TARGET lab7_reference_code)
  cs550_compare_forms(scene_hashes FastFormsLeaveTheBitsOfTheTeachingForms long
                      "wall, game: [0-9a-f]+")
  cs550_compare_forms(manifold_hashes FastManifoldsHaveTheBitsOfTheTeachingForm engine
                      "corners in planes: [0-9a-f]+, [1-9][0-9]+ points")
  cs550_compare_forms(thread_hashes ThreadsLeaveTheBitsOfOne long "bouncing: [0-9a-f]+")
endif()
