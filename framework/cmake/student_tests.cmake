# The ctest tests of the student's code, student.LabN.Name. Where there is a judge, in an instructor's copy, the
# verdicts are those of the judge (grader.cmake). In a students' copy the tests run in the student's program.
function(cs550_add_student_tests number)
  cs550_read_manifest(${number})
  if(TARGET lab${number}_judge)
    cs550_register_judged_tests(${number})
  elseif(TARGET lab${number}_student)
    cs550_register_graded_tests(${number} student)
  endif()
endfunction()

foreach(number IN LISTS CS550_LABS)
  cs550_add_student_tests(${number})
endforeach()
