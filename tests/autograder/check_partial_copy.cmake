# Checks that a COPY of ROOT WITHOUT one of its folders can be configured, and that TARGET builds.
# -DROOT=... -DCOPY=... -DWITHOUT=labs|solutions -DTARGET=... -DCXX=... -DLAUNCHER=... -DGENERATOR=...
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${COPY}")
foreach(part CMakeLists.txt framework labs solutions tests)
  if(NOT part STREQUAL WITHOUT AND EXISTS "${ROOT}/${part}")
    file(COPY "${ROOT}/${part}" DESTINATION "${COPY}")
  endif()
endforeach()
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${COPY}" -B "${COPY}/build" -G "${GENERATOR}"
                        "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${COPY}/build"
                        --target ${TARGET}
                COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE "${COPY}")
