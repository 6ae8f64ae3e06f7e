# Writes the functions of namespace cs550 that OBJECTS define, one mangled name a line, to OUTPUT.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND "${NM}" -g --defined-only ${OBJECTS} OUTPUT_VARIABLE listing
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[0-9a-f]+ T _ZN5cs550[^\n]*" symbols "${listing}")
list(TRANSFORM symbols REPLACE ".* T " "")
list(SORT symbols)
list(JOIN symbols "\n" symbols)
file(WRITE "${OUTPUT}" "${symbols}\n")
