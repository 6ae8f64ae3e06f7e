#!/bin/sh
# list_lab_functions.sh NM OUTPUT LIBRARY...: writes the contract's functions that the labs' libraries
# define, as rows of lab_functions() in whose_code.cpp. Helpers are in namespace cs550::labN.
nm=$1 output=$2
shift 2
for library; do
  lab=${library##*/liblab}
  "$nm" -D --defined-only "$library" |
    sed -n "/_ZN5cs550[0-9]*lab[0-9]/d; s/.* T \(_ZN5cs550.*\)/    {${lab%%_*}, \"\1\"},/p"
done >"$output"
