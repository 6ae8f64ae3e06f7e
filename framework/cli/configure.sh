# Part of the launcher `cs550`: when CMake has to configure a build again, and whether this machine is fit for it.

# Whether version $1, such as 3.25.1, is $2 or later.
at_least() { [ "$(printf '%s\n' "$1" "$2" | sort -t . -k 1,1n -k 2,2n | head -n 1)" = "$2" ]; }

# What is too old for the project: CMake, and compiler $1. A distribution keeps the versions of its year.
outdated() {
  version=$(cmake --version 2>/dev/null | sed -n '1s/^[^0-9]*//p')
  at_least "${version:-3.25}" 3.25 || echo "cmake $version: 3.25 or later is needed"
  name=g++ least=12
  ! $1 --version 2>/dev/null | grep -q clang || name=clang++ least=14
  version=$($1 -dumpversion 2>/dev/null)
  at_least "${version:-$least}" $least || echo "$1 $version: $name $least or later is needed"
}
newer_systems="Debian 12, Debian 13 and Ubuntu 24.04 have newer versions."

# What a configured build depends on beside the files that CMake watches, one a line. CMake keeps what the first three
# were when it was configured from nothing.
surroundings() {
  printf '%s\n' "root $CS550_ROOT" "compiler ${CXX-}" \
    "variables $(grep -o '"[A-Z][A-Z0-9_]*":' CMakePresets.json | cksum)" \
    "presets $(cksum <CMakePresets.json)" "warnings ${CS550_WERROR-}" "launcher ${CMAKE_CXX_COMPILER_LAUNCHER-}"
  missing all apt-get | sed 's/ .*//; s/^/missing /'
}

# Whether folder $1, with surroundings $2, must be configured from nothing, which deletes its objects: if it never was
# until the end, or if CMake would keep what no longer is so, such as the library of a package that was removed.
must_start_afresh() {
  [ -e "$1/build.ninja" ] || return 0
  [ "$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$1/CMakeCache.txt" 2>/dev/null)" = "$CS550_ROOT" ] || return 0
  [ -e "$1/.configured" ] || return 1  # configured by CMake alone
  [ "$(sed 3q "$1/.configured")" = "$(printf '%s\n' "$2" | sed 3q)" ] || return 0
  printf '%s\n' "$2" | grep '^missing ' | grep -qvxFf "$1/.configured"
}

# configure PRESET FOLDER SURROUNDINGS. CMake itself reads the launcher only when it starts from nothing.
configure() {
  compiler=${CXX:-c++}
  case $1 in clang | fuzz) compiler=clang++ ;; esac
  old=$(outdated "$compiler")
  [ -z "$old" ] || fail "too old for CS550:" "$(echo "$old" | sed '2s/^/  /')" "$newer_systems"
  fresh=
  ! must_start_afresh "$2" "$3" || fresh=--fresh
  logged "Configuring '$1'" "$2.configure.log" \
    cmake --preset "$1" $fresh "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-}" ||
    log_failed "$2.configure.log" "configuring '$1' failed"
  printf '%s\n' "$3" >"$2/.configured"
}

# The variable that allows as many jobs as there is memory for, if ninja would start more (up to two more than there are
# processors). The largest batches of files need 1 GB (framework/cmake/languages.cmake), most of them less.
limited_jobs() {
  [ -z "${CMAKE_BUILD_PARALLEL_LEVEL-}" ] || return 0
  jobs=$(awk '/^MemAvailable:/ { print int($2 / 750000) + ($2 < 750000) }' /proc/meminfo 2>/dev/null)
  [ -z "$jobs" ] || [ "$jobs" -ge $(($(processors) + 2)) ] || echo "CMAKE_BUILD_PARALLEL_LEVEL=$jobs"
}
