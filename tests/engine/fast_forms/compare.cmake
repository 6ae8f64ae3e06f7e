# cmake -DFAST=... -DTEACHING=... -DSHOWS=REGEX -P compare.cmake
# Checks that both programs print the same, and something that matches REGEX.
cmake_minimum_required(VERSION 3.25)
foreach(form FAST TEACHING)
  execute_process(COMMAND "${${form}}" OUTPUT_VARIABLE hashes_${form} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT hashes_FAST MATCHES "${SHOWS}")
  message(FATAL_ERROR "there is nothing to compare:\n${hashes_FAST}")
endif()
if(NOT hashes_FAST STREQUAL hashes_TEACHING)
  message(FATAL_ERROR "fast forms:\n${hashes_FAST}\nteaching forms:\n${hashes_TEACHING}")
endif()
