# tests/labN_topic/manifest.json lists a lab's graded tests with their points and steps. It is
# generated from the tests by the target `update_manifests` and committed, so that listing the tests
# never runs a student's code.
set(CS550_VISIBLE_POINTS 48)
set(CS550_HIDDEN_POINTS 12)
set(CS550_MOST_LONG_POINTS 10)

# Sets CS550_LABn_TESTS and, for each test, CS550_LABn_<test>_LABELS and _TIMEOUT. In a students' copy
# the hidden tests are left out.
function(cs550_read_manifest number)
  set(lab CS550_LAB${number})
  set(folder "${PROJECT_SOURCE_DIR}/tests/${${lab}_NAME}")
  set(file "${folder}/manifest.json")
  file(GLOB found CONFIGURE_DEPENDS "${file}")
  if(NOT found)
    message(STATUS "Lab ${number} has no manifest yet: cmake --build ${PROJECT_BINARY_DIR} "
                   "--target update_manifests")
    return()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(GLOB hidden_sources "${folder}/hidden/*.cpp")
  file(READ "${file}" manifest)
  string(JSON count LENGTH "${manifest}" tests)
  math(EXPR last "${count} - 1")
  set(visible_points 0)
  set(hidden_points 0)
  set(long_points 0)
  set(tests "")
  foreach(index RANGE ${last})
    foreach(key name points hidden long)
      string(JSON ${key} GET "${manifest}" tests ${index} ${key})
    endforeach()
    if(hidden AND NOT hidden_sources)
      continue()
    endif()
    list(APPEND tests ${name})
    set(labels "")
    set(timeout 60)
    if(hidden)
      list(APPEND labels hidden)
      math(EXPR hidden_points "${hidden_points} + ${points}")
    else()
      math(EXPR visible_points "${visible_points} + ${points}")
    endif()
    if(long)
      list(APPEND labels long)
      set(timeout 300)
      math(EXPR long_points "${long_points} + ${points}")
    endif()
    set(${lab}_${name}_LABELS "${labels}" PARENT_SCOPE)
    set(${lab}_${name}_TIMEOUT ${timeout} PARENT_SCOPE)
  endforeach()
  set(${lab}_TESTS "${tests}" PARENT_SCOPE)

  cs550_check_points("${file}" "visible" ${visible_points} EQUAL ${CS550_VISIBLE_POINTS})
  if(hidden_sources)
    cs550_check_points("${file}" "hidden" ${hidden_points} EQUAL ${CS550_HIDDEN_POINTS})
  endif()
  cs550_check_points("${file}" "long" ${long_points} LESS_EQUAL ${CS550_MOST_LONG_POINTS})
endfunction()

function(cs550_check_points file kind points comparison wanted)
  if(NOT points ${comparison} wanted)
    string(REPLACE "LESS_EQUAL" "at most " comparison "${comparison}")
    string(REPLACE "EQUAL" "" comparison "${comparison}")
    set(severity STATUS)
    set(advice "")
    if(CS550_STRICT_MANIFESTS)
      set(severity FATAL_ERROR)
      set(advice ". To build while points change: cmake --preset test -DCS550_STRICT_MANIFESTS=OFF")
    endif()
    message(${severity} "${file}: ${kind} tests sum to ${points} points, "
                        "should be ${comparison}${wanted}${advice}")
  endif()
endfunction()

# Adds the lab to update_manifests, and a ctest test that the committed file is up to date. The tests
# are listed by a program that links the reference.
function(cs550_add_manifest_update number)
  cs550_first_variant(variant ${number} reference stub)
  set(manifest "${PROJECT_SOURCE_DIR}/tests/${CS550_LAB${number}_NAME}/manifest.json")
  set(command "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:lab${number}_${variant}>"
              "-DMANIFEST=${manifest}" "-DBUILD=${PROJECT_BINARY_DIR}"
              -DSTRICT=${CS550_STRICT_MANIFESTS}
              -P "${PROJECT_SOURCE_DIR}/framework/cmake/compare_manifest.cmake")
  add_custom_target(update_manifest_lab${number} COMMAND ${command} update
                    DEPENDS lab${number}_${variant} VERBATIM)
  add_dependencies(update_manifests update_manifest_lab${number})
  # A students' copy lists the visible tests only.
  if(variant STREQUAL "reference" AND NOT EXISTS "${PROJECT_SOURCE_DIR}/.starters")
    add_test(NAME manifest.Lab${number} COMMAND ${command} check)
    set_tests_properties(manifest.Lab${number} PROPERTIES LABELS "lab${number};manifest")
  endif()
endfunction()
