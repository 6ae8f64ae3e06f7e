# Milestones: what each lab adds to the assembled engine, compared with recorded runs of the
# reference in framework/assets/trajectories/.
#   milestones           on the reference; the target update_trajectories regenerates the records
#   milestones_student   on all the student's labs together
#   milestones_sanitized, milestones_debugged   the same, compiled with the sanitizers, or for gdb
cs550_given_library(cs550_milestones milestones cs550_scenes fmt::fmt)
target_include_directories(cs550_milestones PUBLIC "${PROJECT_SOURCE_DIR}/framework")

function(cs550_add_milestone_program target)
  add_executable(${target} "${PROJECT_SOURCE_DIR}/framework/milestones/program/main.cpp")
  target_link_libraries(${target} PRIVATE cs550_milestones cs550_files CLI11::CLI11 cs550_warnings)
endfunction()

cs550_add_milestone_program(milestones)
cs550_link_labs(milestones reference stub)
add_custom_target(update_trajectories COMMAND milestones --update)

foreach(variant student sanitized debugged)
  cs550_add_milestone_program(milestones_${variant})
  set_target_properties(milestones_${variant} PROPERTIES EXCLUDE_FROM_ALL TRUE)
endforeach()
cs550_link_labs(milestones_student assembled reference stub)
cs550_link_labs(milestones_sanitized sanitized reference stub)
target_link_libraries(milestones_sanitized PRIVATE cs550_sanitizers)
cs550_link_labs(milestones_debugged debugged reference stub)

# The reference must stay within half of the tolerances of its record. Otherwise the record is stale,
# because students need the other half.
foreach(number IN LISTS CS550_LABS)
  file(GLOB records CONFIGURE_DEPENDS
       "${PROJECT_SOURCE_DIR}/framework/assets/trajectories/lab${number}_*")
  if(NOT records)
    continue()
  endif()
  if(TARGET lab${number}_reference_code)
    add_test(NAME milestone.Lab${number} COMMAND milestones --lab ${number} --share 0.5)
    set_tests_properties(milestone.Lab${number} PROPERTIES LABELS "lab${number};milestone"
                         TIMEOUT 120)
  endif()
  add_test(NAME assembled.Lab${number} COMMAND milestones_student --lab ${number})
  set_tests_properties(assembled.Lab${number} PROPERTIES LABELS "lab${number};student"
                       TIMEOUT 120)
endforeach()
