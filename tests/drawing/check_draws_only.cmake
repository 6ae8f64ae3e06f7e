# cmake -DNM=... -DARCHIVE=... -DSYMBOL_LISTS=a;b -P check_draws_only.cmake
# ARCHIVE needs none of the lab functions that SYMBOL_LISTS name.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND "${NM}" -u "${ARCHIVE}" OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
if(NOT listing MATCHES " U ")
  message(FATAL_ERROR "${NM} lists nothing that ${ARCHIVE} needs: there is nothing to check")
endif()
foreach(list_file IN LISTS SYMBOL_LISTS)
  file(STRINGS "${list_file}" symbols)
  if(NOT symbols)
    message(FATAL_ERROR "${list_file} names no function")
  endif()
  foreach(symbol IN LISTS symbols)
    string(FIND "${listing}" " U ${symbol}\n" place)
    if(NOT place EQUAL -1)
      execute_process(COMMAND c++filt "${symbol}" OUTPUT_VARIABLE name
                      OUTPUT_STRIP_TRAILING_WHITESPACE)
      message(SEND_ERROR "framework/drawing calls ${name}, which students write: it draws what it "
                         "is given, and computes nothing with a student's function")
    endif()
  endforeach()
endforeach()
