# Builds the judge of a lab and grades a folder with it. Run with -DLAB=N -DBUILD=FOLDER -DGRADE_LAB=PROGRAM
# -DFILES=FOLDER -DRECORD=FILE; the environment variable CS550_SUBMISSION names another folder to grade,
# and CS550_ISOLATION another isolation than `auto`.
file(REMOVE "${RECORD}")

# Ends with a message if the code in the folder of a lab differs from Git's last commit, which has the starter. In a
# clone where Git cannot tell, it prints why; without Git's history nothing is checked.
function(check_starter folder)
  file(REAL_PATH "${folder}" folder)
  file(REAL_PATH "${folder}/../.." project)
  foreach(question "ls-files;--others;--exclude-standard" "-c;core.fileMode=false;diff;--relative;--name-only;HEAD")
    # Git may read a clone that another user made, such as one that is mounted in a container.
    execute_process(COMMAND git -c "safe.directory=${project}" ${question}
                            -- ":(glob)**/*.cpp" ":(glob)**/*.hpp" ":(exclude,glob)**/my_tests.cpp"
                    WORKING_DIRECTORY "${folder}" RESULT_VARIABLE result OUTPUT_VARIABLE files ERROR_VARIABLE error)
    if(result EQUAL 0 AND files)
      message(FATAL_ERROR "${folder} differs from the starter, which takes the place of what a submission lacks:\n"
                          "${files}./cs550 lab ${LAB} --reset restores the starter and keeps your files. "
                          "Move files in its subfolders elsewhere.")
    elseif(NOT result EQUAL 0 AND EXISTS "${project}/.git")
      message(WARNING "Cannot check that labs/ has the starters: git failed: ${error}")
      return()
    endif()
  endforeach()
endfunction()

if(DEFINED ENV{CS550_SUBMISSION})
  check_starter("${FILES}")
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
