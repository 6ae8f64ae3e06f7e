# The instructor's grader, in the folder framework/autograder/grader/. No submission shares a process with
# the tests:
#   grade_lab     grades one lab of one submission
#   labN_judge    the graded tests of lab N; its functions of that lab ask a worker
#   labN_own_tests    runs a student's own tests of lab N
#   milestones_judge    the milestones; its functions of all labs ask a worker
#   lab_worker    loads a submission and calls its functions
# `judges` builds them all. They are not part of `all`.
set(grader_folder "${PROJECT_SOURCE_DIR}/framework/autograder/grader")
if(NOT EXISTS "${grader_folder}" OR NOT CS550_ISOLATE_LABS OR NOT TARGET lab1_reference_code)
  return()
endif()
pkg_check_modules(seccomp QUIET IMPORTED_TARGET libseccomp)
if(NOT seccomp_FOUND)
  message(STATUS "The grader is left out: it needs libseccomp-dev (./cs550 doctor --install grade)")
  return()
endif()
add_custom_target(judges)
add_custom_target(mistakes)

# The given code, for submissions to call. Where it calls a lab, it calls the submission.
add_library(cs550_given SHARED EXCLUDE_FROM_ALL ${engine_objects})
target_link_libraries(cs550_given PUBLIC cs550_contract PRIVATE cs550_mesh_files)
set_target_properties(cs550_given PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${lab_folder}")

# Processes, the channel, and the judge's end of it.
file(GLOB sources CONFIGURE_DEPENDS "${grader_folder}/*.cpp" "${grader_folder}/judge/*.cpp")
list(FILTER sources EXCLUDE REGEX "/start\\.cpp$")
add_library(cs550_grader STATIC EXCLUDE_FROM_ALL ${sources})
target_include_directories(cs550_grader PUBLIC "${PROJECT_SOURCE_DIR}/framework")
target_link_libraries(cs550_grader PUBLIC cs550_contract cs550_isolation cs550_autograder cs550_files cereal::cereal
                      nlohmann_json::nlohmann_json GTest::gtest PRIVATE cs550_warnings)

file(GLOB sources CONFIGURE_DEPENDS "${grader_folder}/worker/*.cpp")
add_executable(lab_worker EXCLUDE_FROM_ALL ${sources} "${lab_functions}")
target_include_directories(lab_worker PRIVATE "${lab_folder}" "${PROJECT_SOURCE_DIR}/framework")
# Lab functions stay undefined until libraries of labs are loaded. Submissions may use fmt, with which a student's own
# build is linked.
target_link_options(lab_worker PRIVATE -Wl,--no-as-needed -Wl,--allow-shlib-undefined)
target_link_libraries(lab_worker PRIVATE cs550_given cs550_isolation cs550_warnings cereal::cereal fmt::fmt
                      PkgConfig::seccomp ${CMAKE_DL_LIBS})

# The same options as for a student's own build.
separate_arguments(debug_flags UNIX_COMMAND "${CMAKE_CXX_FLAGS_DEBUG}")
set(lab_options -std=c++20 ${debug_flags} -fPIC -ffp-contract=off -DEIGEN_MAX_ALIGN_BYTES=16
    -DEIGEN_MPL2_ONLY -isystem ${EIGEN3_INCLUDE_DIRS} -Wall -Wextra -Werror=missing-declarations)
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|i.86")
  list(APPEND lab_options -DEIGEN_DONT_VECTORIZE)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC quotes lines of the file that #line names, and counts their columns: it could be a hidden test.
  list(APPEND lab_options -fno-gnu-unique -fno-diagnostics-show-caret -fdiagnostics-column-unit=byte)
  set(compiler_name "g++ ${CMAKE_CXX_COMPILER_VERSION}")
else()
  list(APPEND lab_options -Werror=missing-prototypes)
  set(compiler_name "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
endif()

# The header that the labs of students are compiled with (lab_code.cmake), precompiled with the options of a
# submission. Without it, three quarters of the time of grading are spent on reading Eigen again. Its
# paths are relative, since submissions are compiled in another folder.
set(precompiled_folder "${lab_folder}/precompiled")
file(CONFIGURE OUTPUT "${precompiled_folder}/lab.hpp"
     CONTENT "#include <cs550/math.hpp>\n#include <vector>\n#include \"common_expressions.hpp\"\n")
configure_file("${PROJECT_SOURCE_DIR}/framework/autograder/common_expressions.hpp"
               "${precompiled_folder}/common_expressions.hpp" COPYONLY)
file(CREATE_LINK "${PROJECT_SOURCE_DIR}/framework/include" "${lab_folder}/contract" SYMBOLIC)
set(precompiled_header "${precompiled_folder}/lab.hpp.gch")
file(GLOB contract CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/include/cs550/*.hpp")
add_custom_command(OUTPUT "${precompiled_header}"
  COMMAND "${CMAKE_CXX_COMPILER}" ${lab_options} -Icontract -x c++-header precompiled/lab.hpp
          -o "${precompiled_header}"
  DEPENDS "${precompiled_folder}/lab.hpp" "${precompiled_folder}/common_expressions.hpp" ${contract}
  WORKING_DIRECTORY "${lab_folder}" VERBATIM)
add_custom_target(precompiled_contract DEPENDS "${precompiled_header}")

list(JOIN lab_options " " lab_options)
file(GLOB sources CONFIGURE_DEPENDS "${grader_folder}/grade_lab/*.cpp")
add_executable(grade_lab EXCLUDE_FROM_ALL ${sources})
add_dependencies(grade_lab precompiled_contract)
target_link_libraries(grade_lab PRIVATE cs550_grader CLI11::CLI11 cs550_warnings)
target_compile_definitions(grade_lab PRIVATE
  CS550_COMPILER="${CMAKE_CXX_COMPILER}"
  CS550_COMPILER_NAME="${compiler_name}"
  CS550_LAB_OPTIONS="${lab_options}"
  CS550_CONTRACT_HEADERS="${PROJECT_SOURCE_DIR}/framework/include"
  CS550_LAB_FOLDER="${lab_folder}"
  CS550_PRECOMPILED="${precompiled_folder}"
  CS550_MISTAKES="${PROJECT_BINARY_DIR}/mistakes"
  CS550_WORKER_PROGRAM="$<TARGET_FILE:lab_worker>"
  CS550_ENGINE_LIBRARY="$<TARGET_FILE:cs550_given>"
  CS550_TRAJECTORIES="${PROJECT_SOURCE_DIR}/framework/assets/trajectories"
  CS550_GRADED_TESTS="${PROJECT_SOURCE_DIR}/tests")
add_dependencies(judges grade_lab)

add_library(cs550_judge_start OBJECT EXCLUDE_FROM_ALL "${grader_folder}/judge/start.cpp")
target_link_libraries(cs550_judge_start PUBLIC cs550_grader PRIVATE cs550_warnings)
target_compile_definitions(cs550_judge_start PRIVATE
  CS550_LAB_FOLDER="${lab_folder}"
  CS550_WORKER_PROGRAM="$<TARGET_FILE:lab_worker>"
  CS550_ENGINE_LIBRARY="$<TARGET_FILE:cs550_given>")

function(cs550_add_judge number)
  set(remote "${grader_folder}/remote/lab${number}")
  file(GLOB sources CONFIGURE_DEPENDS "${remote}.cpp" "${remote}_*.cpp")
  if(NOT TARGET lab${number}_reference OR NOT sources)
    message(STATUS "Lab ${number} has no judge: ${remote}.cpp is missing")
    return()
  endif()
  cs550_add_lab_code(${number} remote ${sources})
  target_link_libraries(lab${number}_remote_code PRIVATE cs550_warnings cereal::cereal)
  target_include_directories(lab${number}_remote_code PRIVATE "${PROJECT_SOURCE_DIR}/framework")
  add_executable(lab${number}_judge EXCLUDE_FROM_ALL)
  target_link_libraries(lab${number}_judge PRIVATE lab${number}_tests cs550_graded_main cs550_judge_start)
  cs550_link_lab(lab${number}_judge ${number} remote)
  foreach(other IN LISTS CS550_LABS)
    if(NOT other EQUAL number)
      cs550_link_lab(lab${number}_judge ${other} reference)
    endif()
  endforeach()
  # The worker loads the other labs by name.
  add_dependencies(lab${number}_judge lab_worker)
  add_dependencies(judges lab${number}_judge)
  # The starter, which a submission is linked with. The judge does not depend on it: labs/ may be what is
  # graded (judged.LabN), and not compile.
  if(TARGET lab${number}_stub_code)
    add_dependencies(judges lab${number}_stub_code)
  endif()
endfunction()

# Students' own tests are loaded at run time, and use GoogleTest and the given code of the program.
function(cs550_add_own_test_program number)
  if(NOT TARGET lab${number}_remote_code)
    return()
  endif()
  set(target lab${number}_own_tests)
  add_executable(${target} EXCLUDE_FROM_ALL "${grader_folder}/own_tests/main.cpp" "${grader_folder}/worker/lockdown.cpp")
  target_link_libraries(${target} PRIVATE cs550_grader cs550_given cs550_warnings PkgConfig::seccomp ${CMAKE_DL_LIBS})
  target_link_options(${target} PRIVATE -Wl,--whole-archive "$<TARGET_FILE:GTest::gtest>" -Wl,--no-whole-archive)
  cs550_link_lab(${target} ${number} remote)
  foreach(other IN LISTS CS550_LABS)
    if(NOT other EQUAL number)
      cs550_link_lab(${target} ${other} reference)
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES ENABLE_EXPORTS TRUE)
  add_dependencies(judges ${target})

  # Each known mistake as a library of the lab. A name tells nothing about the mistake.
  set(made "${PROJECT_BINARY_DIR}/mistakes/lab${number}/made")
  add_custom_command(OUTPUT "${made}"
    COMMAND python3 "${PROJECT_SOURCE_DIR}/tests/mutants/build_libraries.py" --build "${PROJECT_BINARY_DIR}" --lab ${number}
    DEPENDS lab${number}_reference "${PROJECT_SOURCE_DIR}/tests/mutants/lab${number}.json"
            "${PROJECT_SOURCE_DIR}/tests/mutants/build_libraries.py"
            "${PROJECT_SOURCE_DIR}/tests/mutants/run_mutants.py" USES_TERMINAL VERBATIM)
  add_custom_target(mistakes_lab${number} DEPENDS "${made}")
  add_dependencies(mistakes mistakes_lab${number})
endfunction()

# The starter takes the place of a lab that does not compile.
function(cs550_add_milestones_judge)
  file(GLOB sources CONFIGURE_DEPENDS "${grader_folder}/milestones/*.cpp")
  add_executable(milestones_judge EXCLUDE_FROM_ALL ${sources})
  target_link_libraries(milestones_judge PRIVATE cs550_milestones cs550_graded_main cs550_judge_start cs550_engine
                        cs550_warnings)
  foreach(number IN LISTS CS550_LABS)
    cs550_link_lab(milestones_judge ${number} remote reference)  # the reference if the lab has no judge
    if(TARGET lab${number}_stub_code)
      add_dependencies(milestones_judge lab${number}_stub_code)
    endif()
  endforeach()
  add_dependencies(milestones_judge lab_worker)
  add_dependencies(judges milestones_judge)
endfunction()

# judged.LabN grades labs/labN_topic/, or the folder that the environment variable CS550_SUBMISSION names, and
# each student.LabN.Name reads its verdict from the record. That cannot be the record of an earlier run: it is
# removed first, and without a new one no test runs.
function(cs550_register_judged_tests number)
  set(record "${result_folder}/judged/lab${number}.json")
  add_test(NAME judged.Lab${number}
           COMMAND "${CMAKE_COMMAND}" -DLAB=${number} "-DBUILD=${PROJECT_BINARY_DIR}" "-DRECORD=${record}"
                   "-DGRADE_LAB=$<TARGET_FILE:grade_lab>"
                   "-DFILES=${PROJECT_SOURCE_DIR}/labs/${CS550_LAB${number}_NAME}"
                   -P "${grader_folder}/ctest/judge_lab.cmake"
           WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")  # CS550_SUBMISSION is typed there
  set_tests_properties(judged.Lab${number} PROPERTIES FIXTURES_SETUP judged_lab${number} TIMEOUT 7200
                       RESOURCE_LOCK build_folder LABELS "lab${number};student")
  foreach(test IN LISTS CS550_LAB${number}_TESTS)
    set(name student.Lab${number}.${test})
    add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DRECORD=${record}" -DWANTED=Lab${number}.${test}
             -P "${grader_folder}/ctest/judged_verdict.cmake")
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED judged_lab${number} TIMEOUT 60
                         LABELS "lab${number};student;${CS550_LAB${number}_${test}_LABELS}")
  endforeach()
endfunction()

foreach(number IN LISTS CS550_LABS)
  cs550_add_judge(${number})
  cs550_add_own_test_program(${number})
endforeach()
cs550_add_milestones_judge()
