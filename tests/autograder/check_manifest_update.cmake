# cmake -DPROGRAM=... -DUPDATE=compare_manifest.cmake -DMANIFEST=... -P check_manifest_update.cmake
# The points of PROGRAM's tests have wrong sums: its manifest is written only if that is allowed.
cmake_minimum_required(VERSION 3.25)
function(update strict result message)
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=${PROGRAM}" "-DMANIFEST=${MANIFEST}" -DBUILD=.
                          -DSTRICT=${strict} -P "${UPDATE}" update
                  RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE error)
  set(${result} ${code} PARENT_SCOPE)
  set(${message} "${error}" PARENT_SCOPE)
endfunction()

file(REMOVE "${MANIFEST}")
update(ON result message)
if(result EQUAL 0 OR EXISTS "${MANIFEST}")
  message(SEND_ERROR "a manifest with wrong sums was written")
endif()
string(REGEX REPLACE "[ \n]+" " " message "${message}")
if(NOT message MATCHES "visible tests sum to [0-9]+ points, should be 48\\.")
  message(SEND_ERROR "no sum is named: ${message}")
endif()

update(OFF result message)
if(NOT result EQUAL 0 OR NOT EXISTS "${MANIFEST}")
  message(SEND_ERROR "a manifest whose sums are allowed to be wrong was not written: ${message}")
endif()
