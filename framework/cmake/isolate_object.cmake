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

function(demangle symbols result)
  execute_process(COMMAND c++filt ${symbols} OUTPUT_VARIABLE names ERROR_QUIET)
  string(STRIP "${names}" names)
  string(REPLACE "Eigen::Matrix<float, 3, 1, 2, 3, 1>" "Vec3" names "${names}")
  string(REPLACE "\n" "\n  " names "${names}")
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

# Puts the objects together; `result` becomes what is wrong: two may define the same function.
function(merge_objects output result)
  cmake_path(REMOVE_EXTENSION output LAST_ONLY OUTPUT_VARIABLE stem)
  file(WRITE "${stem}.ld" "SECTIONS { cs550_${VARIANT}_lab${LAB} : { *(.text .text.*) } }\n")
  # Groups must become ordinary sections first: a plain -r link would drop this lab's copy of an
  # inline function in favour of another lab's.
  execute_process(COMMAND "${LINKER}" -r --force-group-allocation -T "${stem}.ld" -o "${output}"
                          ${OBJECTS} RESULT_VARIABLE code ERROR_VARIABLE message)
  if(code)
    set(${result} "${message}" PARENT_SCOPE)
  endif()
endfunction()

list(GET SOURCES 0 source)
cmake_path(GET source PARENT_PATH folder)
cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${ROOT}")

set(wrong "")
missing_functions(missing)
if(missing)
  demangle("${missing}" names)
  set(wrong "${folder} does not define, exactly as its header declares it:\n  ${names}")
else()
  merge_objects("${OUTPUT}.merged" trouble)
  if(trouble)
    set(wrong "The files of ${folder} cannot be linked together:\n${trouble}")
  endif()
endif()

if(NOT wrong)
  execute_process(COMMAND "${OBJCOPY}" "--keep-global-symbols=${SYMBOLS}"
                          "${OUTPUT}.merged" "${OUTPUT}" COMMAND_ERROR_IS_FATAL ANY)
elseif(FALLBACK)
  message(NOTICE "Lab ${LAB}: ${folder} is not complete or does not compile; "
                 "its starter is linked in its place.")
  file(COPY_FILE "${FALLBACK}" "${OUTPUT}")
else()
  message(FATAL_ERROR "${wrong}")
endif()
file(REMOVE "${OUTPUT}.merged")
