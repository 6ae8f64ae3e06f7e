#!/bin/sh
# list_lab_functions.sh NM OUTPUT LIBRARY...: writes the contract's functions that the labs' libraries
# define, as CS550_LAB_FUNCTION(lab, name, "mangled name"). Helpers are in namespace cs550::labN.
nm=$1 output=$2
shift 2
for library; do
  lab=${library##*/liblab}
  "$nm" -D --defined-only "$library" |
    sed -n "/_ZN5cs550[0-9]*lab[0-9]/d; s/.* T \(_ZN5cs550[0-9]*\([a-z][a-z_]*\)E.*\)/CS550_LAB_FUNCTION(${lab%%_*}, \2, \"\1\")/p"
done >"$output"
