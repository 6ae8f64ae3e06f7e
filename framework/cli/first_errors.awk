# awk -f first_errors.awk LOG
# The first 40 lines from the first error on of the step that stopped a build, or the last 40 lines of its log if no error
# is named. Paths are relative to the project. Left out are ninja's progress and command lines, CMake's reports of
# success, and errors of labs that count as empty, which come before "FAILED" or after the end of the failed step.
BEGIN { root = ENVIRON["CS550_ROOT"] "/"; most = 40 }
failed && (/^FAILED: / || /^\[[0-9]+\/[0-9]+\]/ || /^ninja: /) { exit }
/^FAILED: / {
  failed = 1
  count = first = 0
  getline  # the command line
  next
}
/^\[[0-9]+\/[0-9]+\]/ || /^ninja: (build|Entering|no work)/ || /^-- / { next }
{
  sub(/^\.\.\/\.\.\//, "")
  while (at = index($0, root)) $0 = substr($0, 1, at - 1) substr($0, at + length(root))
  lines[++count] = $0
  if (/Killed signal terminated program|cc1plus: out of memory|virtual memory exhausted|command: Killed/) no_memory = 1
  if (!first && /[Ee]rror: |undefined reference|multiple definition/) first = count
}
END {
  # The line before the first error may be "In function ...".
  start = first ? first - 1 : count - most + 1
  if (start < 1) start = 1
  for (i = start; i < start + most && i <= count; ++i) print lines[i]
  if (i <= count) print "... and " count - i + 1 " more lines"
  if (no_memory) {
    print "The compiler ran out of memory. Close other programs, or compile one file at a time:"
    print "  CMAKE_BUILD_PARALLEL_LEVEL=1 ./cs550 ..."
  }
}
