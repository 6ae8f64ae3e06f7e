# Merges a lab's OBJECTS into OUTPUT, which exports the functions named in SYMBOLS and nothing else.
# Its code lies in a section cs550_<variant>_lab<N>: the linker then defines __start_ and __stop_
# symbols around it, by which a program tells whose function it is about to call.
#
# A lab that lacks a function is an error, or, given a FALLBACK (an isolated stub), replaced by it.
cmake_minimum_required(VERSION 3.25)

function(missing_functions result)
  file(STRINGS "${SYMBOLS}" promised)
  execute_process(COMMAND "${NM}" -g --defined-only ${OBJECTS} OUTPUT_VARIABLE listing ERROR_QUIET)
  set(missing "")
  foreach(symbol IN LISTS promised)
    if(NOT listing MATCHES " T ${symbol}\n")
      list(APPEND missing ${symbol})
    endif()
  endforeach()
  set(${result} "${missing}" PARENT_SCOPE)
endfunction()

# Names of functions as a header writes them, one to a line.
function(make_readable names result)
  string(REPLACE "Eigen::Matrix<float, 3, 1, 2, 3, 1>" "Vec3" names "${names}")
  string(REPLACE ", 18446744073709551615ul>" ">" names "${names}")  # a span of any length
  string(REPLACE ";" "\n  " names "${names}")
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

function(demangle symbols result)
  execute_process(COMMAND c++filt ${symbols} OUTPUT_VARIABLE names ERROR_QUIET)
  string(STRIP "${names}" names)
  string(REPLACE "\n" ";" names "${names}")
  make_readable("${names}" names)
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

# What the linker says of objects that do not fit together: mostly the functions that two of them define.
function(explain_conflict message result)
  string(REGEX MATCHALL "multiple definition of `[^']+'" twice "${message}")
  if(NOT twice)
    set(${result} "has files that do not fit together:\n${message}" PARENT_SCOPE)
    return()
  endif()
  list(TRANSFORM twice REPLACE "multiple definition of `([^']+)'" "\\1")
  list(REMOVE_DUPLICATES twice)
  make_readable("${twice}" names)
  set(${result} "defines in more than one of its .cpp files:\n  ${names}" PARENT_SCOPE)
endfunction()

# Puts the objects together; `result` becomes what is wrong with that.
function(merge_objects output result)
  cmake_path(REMOVE_EXTENSION output LAST_ONLY OUTPUT_VARIABLE stem)
  file(WRITE "${stem}.ld" "SECTIONS { cs550_${VARIANT}_lab${LAB} : { *(.text .text.*) } }\n")
  # Groups must become ordinary sections first: a plain -r link would drop this lab's copy of an
  # inline function in favour of another lab's.
  execute_process(COMMAND "${LINKER}" -r --force-group-allocation -T "${stem}.ld" -o "${output}"
                          ${OBJECTS} RESULT_VARIABLE code ERROR_VARIABLE message)
  if(code)
    explain_conflict("${message}" conflict)
    set(${result} "${conflict}" PARENT_SCOPE)
  endif()
endfunction()

list(GET SOURCES 0 source)
cmake_path(GET source PARENT_PATH folder)
cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${ROOT}")

set(wrong "")
missing_functions(missing)
if(missing)
  demangle("${missing}" names)
  set(wrong "does not define, exactly as its header declares it:\n  ${names}")
else()
  merge_objects("${OUTPUT}.merged" wrong)
endif()

if(NOT wrong)
  execute_process(COMMAND "${OBJCOPY}" "--keep-global-symbols=${SYMBOLS}"
                          "${OUTPUT}.merged" "${OUTPUT}" COMMAND_ERROR_IS_FATAL ANY)
elseif(FALLBACK)
  message(NOTICE "Lab ${LAB}: ${folder} is not complete or does not compile; "
                 "its starter is linked in its place.")
  file(COPY_FILE "${FALLBACK}" "${OUTPUT}")
else()
  message(FATAL_ERROR "${folder} ${wrong}")
endif()
file(REMOVE "${OUTPUT}.merged")
