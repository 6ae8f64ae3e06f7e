# Checks that the project can be configured without the viewer, and that building the viewer reports why it is missing.
# Variables: SOURCE, the project; SCRATCH, a folder to write to; COMPILER.
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")

function(expect_left_out name says)
  set(folder "${SCRATCH}/${name}")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${folder}" -G Ninja "-DCMAKE_CXX_COMPILER=${COMPILER}" ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${name}: cannot be configured\n${output}")
  endif()
  foreach(target cs550_viewer cs550_viewer_student)
    execute_process(COMMAND "${CMAKE_COMMAND}" --build "${folder}" --target ${target}
      RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    string(FIND "${output}" "${says}" place)
    if(result EQUAL 0 OR place EQUAL -1)
      message(FATAL_ERROR "${name}: ${target} should fail and say: ${says}\n${output}")
    endif()
  endforeach()
endfunction()

expect_left_out(switched_off "-DCS550_VIEWER=OFF" -DCS550_VIEWER=OFF)

file(WRITE "${SCRATCH}/pkg-config" "#!/bin/sh
case \"$*\" in *imgui* | *epoxy*) exit 1 ;; esac
exec pkg-config \"$@\"
")
file(CHMOD "${SCRATCH}/pkg-config" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
expect_left_out(missing_packages "There is no viewer: it needs libimgui-dev libepoxy-dev."
  "-DPKG_CONFIG_EXECUTABLE=${SCRATCH}/pkg-config")
file(REMOVE_RECURSE "${SCRATCH}")
