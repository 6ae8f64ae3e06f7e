# typed=WORD awk -f nearest_word.awk: the one of its input's lines that somebody probably meant, by the rules of
# framework/include/cs550/nearest_word.hpp. The launcher cannot wait for a program in C++.

function least(a, b) { return a < b ? a : b }

function edit_distance(from, to,    row, diagonal, above, i, j) {
  for (j = 0; j <= length(to); ++j) row[j] = j
  for (i = 1; i <= length(from); ++i) {
    diagonal = row[0]
    row[0] = i
    for (j = 1; j <= length(to); ++j) {
      above = row[j]
      row[j] = least(diagonal + (substr(from, i, 1) != substr(to, j, 1)), least(row[j - 1], above) + 1)
      diagonal = above
    }
  }
  return row[length(to)]
}

BEGIN { typed = ENVIRON["typed"]; fewest = length(typed) }
index($0, typed) == 1 { ++beginning; longer = $0 }
length(typed) <= 100 {
  distance = edit_distance(typed, $0)
  if (distance < fewest && 2 * distance <= length($0)) { fewest = distance; nearest = $0 }
}
END { print (beginning == 1 && length(typed) >= 3 ? longer : nearest) }
