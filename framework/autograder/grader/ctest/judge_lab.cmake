# Builds the judge of a lab and grades a folder with it. Run with -DLAB=N -DBUILD=FOLDER -DGRADE_LAB=PROGRAM
# -DFILES=FOLDER -DRECORD=FILE; the environment variable CS550_SUBMISSION names another folder to grade,
# and CS550_ISOLATION another isolation than `auto`.
file(REMOVE "${RECORD}")
if(DEFINED ENV{CS550_SUBMISSION})
  set(FILES "$ENV{CS550_SUBMISSION}")
endif()

set(isolation auto)
if(DEFINED ENV{CS550_ISOLATION})
  set(isolation "$ENV{CS550_ISOLATION}")
endif()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" --build "${BUILD}" --target grade_lab lab${LAB}_judge)
# The starter is linked with what is graded. It may be what is graded, and not compile: that is a verdict.
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" --target lab${LAB}_stub_code
                OUTPUT_QUIET ERROR_QUIET)
run("${GRADE_LAB}" ${LAB} --submission "${FILES}" --work "${BUILD}/judged/lab${LAB}" --results "${RECORD}"
    --isolation "${isolation}")
message("The record is ${RECORD}")
