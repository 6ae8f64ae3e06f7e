# Tests of link-time substitution and of the runner of graded tests.
set(scripts "${CMAKE_CURRENT_LIST_DIR}")

# Fake labs, run as programs by tests_autograder and tests_cli: one with a test for every outcome, and
# one with a mistake that only the sanitizers detect.
function(cs550_add_fake_lab name)
  add_executable(${name} "${scripts}/fake_lab/${name}.cpp")
  target_link_libraries(${name} PRIVATE cs550_graded_main cs550_test_support cs550_warnings)
  cs550_link_labs(${name} reference stub)
endfunction()
cs550_add_fake_lab(fake_lab)
cs550_add_fake_lab(fake_sanitized_lab)
target_link_libraries(fake_sanitized_lab PRIVATE cs550_sanitizers)
target_compile_options(fake_sanitized_lab PRIVATE -g1)  # its reports name lines

set(isolated_labs "")
if(CS550_ISOLATE_LABS)
  foreach(number IN LISTS CS550_LABS)
    string(APPEND isolated_labs "${CS550_LAB${number}_NAME} ")
  endforeach()
endif()
target_sources(tests_autograder PRIVATE "${lab_functions}"
               "${PROJECT_SOURCE_DIR}/framework/autograder/grader/place.cpp")
target_compile_definitions(tests_autograder PRIVATE
  CS550_FAKE_LAB="$<TARGET_FILE:fake_lab>"
  CS550_HEADERS="${PROJECT_SOURCE_DIR}/framework/include/cs550"
  CS550_ISOLATED_LABS="${isolated_labs}"
  CS550_LAB_FUNCTIONS="${lab_functions}")
add_dependencies(tests_autograder fake_lab)

add_test(NAME autograder.manifest_with_wrong_sums
         COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:fake_lab>"
                 "-DUPDATE=${PROJECT_SOURCE_DIR}/framework/cmake/compare_manifest.cmake"
                 "-DMANIFEST=${result_folder}/fake_manifest.json"
                 -P "${scripts}/check_manifest_update.cmake")
set_tests_properties(autograder.manifest_with_wrong_sums PROPERTIES LABELS autograder TIMEOUT 60)

# Two fake labs with helpers of the same name. The first lacks a function.
if(CS550_ISOLATE_LABS)
  cs550_add_lab_code(101 one "${scripts}/isolation/lab101_one.cpp")
  cs550_add_lab_code(101 fallback "${scripts}/isolation/lab101_fallback.cpp")
  cs550_add_lab_code(102 other "${scripts}/isolation/lab102_other.cpp")
  target_sources(tests_autograder PRIVATE "${scripts}/isolation/isolation_test.cpp")
  target_link_libraries(tests_autograder PRIVATE lab101_one_code lab101_fallback_code lab102_other_code)
endif()

# A test builds the targets that are not part of `all`, so that a broken lab file fails only here.
function(cs550_test_builds number)
  set(name starter.Lab${number}.builds)
  add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --target ${ARGN})
  set_tests_properties(${name} PROPERTIES FIXTURES_SETUP starter_lab${number} TIMEOUT 600
                       RESOURCE_LOCK build_folder LABELS "starter;lab${number}")
endfunction()

function(cs550_test_starter number)
  set(name starter.Lab${number}.fails_every_test)
  add_test(NAME ${name}
           COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:lab${number}_stub>"
                   "-DRESULTS=${result_folder}/stub/Lab${number}.json"
                   -P "${scripts}/check_starter.cmake"
           WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED starter_lab${number} TIMEOUT 60
                       LABELS "starter;lab${number}")
endfunction()

function(cs550_test_whose number variant whose)
  set(name whose.Lab${number}.${variant})
  add_test(NAME ${name}
           COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:lab${number}_${variant}>"
                   -DLAB=${number} -DWHOSE=${whose}
                   "-DREPLACED=${PROJECT_SOURCE_DIR}/solutions/${CS550_LAB${number}_NAME}/fast/replaced.hpp"
                   -P "${scripts}/check_whose.cmake")
  set_tests_properties(${name} PROPERTIES LABELS "autograder;lab${number}" TIMEOUT 60)
  if(whose STREQUAL "student")
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED starter_lab${number}
                         LABELS "starter;lab${number}")
  endif()
endfunction()

# One lab represents all.
function(cs550_test_partial_copy without target)
  add_test(NAME autograder.builds_without_${without}
           COMMAND "${CMAKE_COMMAND}" "-DROOT=${PROJECT_SOURCE_DIR}"
                   "-DCOPY=${PROJECT_BINARY_DIR}/without_${without}" -DWITHOUT=${without}
                   -DTARGET=${target} "-DCXX=${CMAKE_CXX_COMPILER}" "-DGENERATOR=${CMAKE_GENERATOR}"
                   "-DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
                   -P "${scripts}/check_partial_copy.cmake")
  set_tests_properties(autograder.builds_without_${without} PROPERTIES LABELS "autograder;long"
                       TIMEOUT 900)
endfunction()

# In a students' copy the result depends on which labs compile, so only the starter is tested there.
foreach(number IN LISTS CS550_LABS)
  set(unbuilt "")
  if(TARGET lab${number}_stub)
    list(APPEND unbuilt lab${number}_stub)
    cs550_test_starter(${number})
  endif()
  if(CS550_ISOLATE_LABS AND TARGET lab${number}_reference)
    foreach(variant student reference fast)
      if(TARGET lab${number}_${variant})
        cs550_test_whose(${number} ${variant} ${variant})
      endif()
    endforeach()
    if(TARGET lab${number}_student)
      list(APPEND unbuilt lab${number}_student)
    endif()
    if(number EQUAL 1)  # one lab represents all: it needs headers precompiled for the sanitizers
      list(APPEND unbuilt lab1_sanitized lab1_debugged)
    endif()
  endif()
  if(unbuilt)
    cs550_test_builds(${number} ${unbuilt})
  endif()
endforeach()
if(CS550_ISOLATE_LABS AND TARGET lab1_reference AND TARGET lab1_student)
  cs550_test_whose(1 sanitized student)
  cs550_test_whose(1 debugged student)
  cs550_test_partial_copy(labs lab1_reference_code)
  cs550_test_partial_copy(solutions lab1_assembled_code)
endif()

# The instructor's grader, where it can be built. attacks/attacks.json lists what is tried.
if(TARGET grade_lab)
  function(cs550_test_grader name labels)
    add_test(NAME grader.${name} COMMAND python3 ${ARGN} --build "${PROJECT_BINARY_DIR}")
    set_tests_properties(grader.${name} PROPERTIES LABELS "${labels}" TIMEOUT 1200)
  endfunction()

  set(graders grade_lab lab3_judge lab3_stub_code)
  if(CS550_HAS_GRADEBOOK)
    list(APPEND graders cs550_grade)
  endif()
  add_test(NAME grader.builds COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --target ${graders})
  set_tests_properties(grader.builds PROPERTIES FIXTURES_SETUP grader TIMEOUT 900
                       RESOURCE_LOCK build_folder LABELS autograder COST 80)
  cs550_test_grader(survives_some_attacks autograder "${scripts}/attacks/run_attacks.py" --short)
  cs550_test_grader(ends_on_request autograder "${scripts}/attacks/check_termination.py")
  # Its temporary folder lies in one that only we can enter.
  cs550_test_grader(ends_on_request_without_bubblewrap autograder "${scripts}/attacks/check_termination.py"
                    --isolation plain)
  cs550_test_grader(takes_no_failure_of_the_machine_for_a_mark autograder
                    "${scripts}/attacks/check_machine_failures.py")
  cs550_test_grader(gives_ctest_its_verdicts autograder "${scripts}/attacks/check_ctest_verdicts.py")
  # Git cannot tell then whether labs/ has the starters: the test also runs where somebody works on them.
  set_tests_properties(grader.gives_ctest_its_verdicts PROPERTIES RESOURCE_LOCK build_folder
                       ENVIRONMENT "GIT_CEILING_DIRECTORIES=${PROJECT_SOURCE_DIR}")
  set_tests_properties(grader.survives_some_attacks grader.ends_on_request
                       grader.ends_on_request_without_bubblewrap
                       grader.takes_no_failure_of_the_machine_for_a_mark grader.gives_ctest_its_verdicts PROPERTIES
                       FIXTURES_REQUIRED grader)

  # ctest --preset labN builds the judge with the flags of `student`, of which there are several. The folder may come from
  # a project that was moved or copied, whose sources CMake would look for.
  set(precompiles "${PROJECT_BINARY_DIR}/precompiles")
  if(EXISTS "${precompiles}/CMakeCache.txt")
    file(STRINGS "${precompiles}/CMakeCache.txt" home REGEX "^CMAKE_HOME_DIRECTORY:")
    if(NOT home STREQUAL "CMAKE_HOME_DIRECTORY:INTERNAL=${PROJECT_SOURCE_DIR}")
      file(REMOVE_RECURSE "${precompiles}")
    endif()
  endif()
  add_test(NAME grader.precompiles_as_students_compile
           COMMAND "${CMAKE_CTEST_COMMAND}" --build-and-test "${PROJECT_SOURCE_DIR}"
                   "${precompiles}" --build-generator "${CMAKE_GENERATOR}" --build-noclean
                   --build-target precompiled_contract
                   --build-options -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1"
                                   "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
                                   "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}")
  set_tests_properties(grader.precompiles_as_students_compile PROPERTIES LABELS autograder TIMEOUT 300)

  # These expect that `judges` and `mistakes` are built.
  foreach(isolation bubblewrap plain)
    cs550_test_grader(survives_attacks.${isolation} attack "${scripts}/attacks/run_attacks.py"
                      --isolation ${isolation})
  endforeach()
  foreach(isolation bubblewrap plain)
    cs550_test_grader(judges_own_tests.${isolation} attack "${scripts}/attacks/check_own_tests.py"
                      --isolation ${isolation})
  endforeach()
  cs550_test_grader(runs_milestones attack "${scripts}/attacks/check_milestones.py")
  foreach(number IN LISTS CS550_LABS)
    if(TARGET lab${number}_judge)
      cs550_test_grader(same_marks.Lab${number} attack "${scripts}/attacks/same_marks.py" --lab ${number})
      cs550_test_grader(same_marks_of_mutants.Lab${number} mutant "${scripts}/attacks/same_marks.py"
                        --lab ${number} --mutants "*")
      set_tests_properties(grader.same_marks_of_mutants.Lab${number} PROPERTIES
                           RESOURCE_LOCK build_folder PROCESSORS 2 TIMEOUT 7200)
    endif()
  endforeach()
endif()
