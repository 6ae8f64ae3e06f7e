# cmake -DBUILD=... -DSCRATCH=... -DEXAMPLE=... -DCXX=... -DGENERATOR=... -P check_install.cmake
# Checks that a separate program finds the installed engine, and that its box comes to rest on the ground.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${SCRATCH}")
foreach(command "--install;${BUILD};--prefix;${SCRATCH}/prefix"
                "-S;${EXAMPLE};-B;${SCRATCH}/build;-G;${GENERATOR};-DCMAKE_CXX_COMPILER=${CXX};-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix"
                "--build;${SCRATCH}/build")
  execute_process(COMMAND "${CMAKE_COMMAND}" ${command} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND "${SCRATCH}/build/drop_a_box" OUTPUT_VARIABLE height COMMAND_ERROR_IS_FATAL ANY)
if(NOT height MATCHES "^0\\.(49|50)[0-9]* m\n$")
  message(FATAL_ERROR "a cube of 1 m should rest at 0.5 m, not at ${height}")
endif()
file(REMOVE_RECURSE "${SCRATCH}")
