# A world that runs on the fast forms of labs 1 and 7 must be in the same state, bit by bit, as one that
# runs on the teaching forms. The fast form of lab 4 may choose another one of several equal axes.
if(TARGET lab7_fast_code AND TARGET lab7_reference_code)
  foreach(form fast teaching)
    add_executable(scene_hashes_${form} tests/engine/fast_forms/scene_hashes.cpp)
    target_link_libraries(scene_hashes_${form} PRIVATE cs550_scenes cs550_warnings)
  endforeach()
  cs550_link_labs(scene_hashes_fast fast reference stub)
  foreach(number IN LISTS CS550_LABS)
    set(variants fast reference)
    if(number MATCHES "^(1|7)$")
      set(variants reference)
    endif()
    cs550_link_lab(scene_hashes_teaching ${number} ${variants})
  endforeach()
  add_test(NAME engine.FastFormsLeaveTheBitsOfTheTeachingForms
           COMMAND "${CMAKE_COMMAND}" "-DFAST=$<TARGET_FILE:scene_hashes_fast>"
                   "-DTEACHING=$<TARGET_FILE:scene_hashes_teaching>"
                   -P "${CMAKE_CURRENT_LIST_DIR}/fast_forms/compare.cmake")
  set_tests_properties(engine.FastFormsLeaveTheBitsOfTheTeachingForms PROPERTIES
                       LABELS long TIMEOUT 600)
endif()
