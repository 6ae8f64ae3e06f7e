# typed=WORD LC_ALL=C awk -f nearest_word.awk: the one of its input's lines that somebody probably meant, by the rules of
# framework/include/cs550/nearest_word.hpp. The launcher cannot wait for a program in C++.

function least(a, b) { return a < b ? a : b }

function letter(word, i) { return substr(word, i, 1) }

function edit_distance(from, to,    row, i, j) {
  for (j = 0; j <= length(to); ++j) row[0, j] = j
  for (i = 1; i <= length(from); ++i) {
    row[i, 0] = i
    for (j = 1; j <= length(to); ++j) {
      row[i, j] = least(row[i - 1, j - 1] + (letter(from, i) != letter(to, j)), least(row[i, j - 1], row[i - 1, j]) + 1)
      if (i > 1 && j > 1 && letter(from, i) == letter(to, j - 1) && letter(from, i - 1) == letter(to, j))
        row[i, j] = least(row[i, j], row[i - 2, j - 2] + 1)
    }
  }
  return row[length(from), length(to)]
}

# How many letters of a word may differ.
function allowance(word) { return length(word) < 6 ? 1 : int(length(word) / 3) }

BEGIN { typed = ENVIRON["typed"]; fewest = length(typed) }
index($0, typed) == 1 { ++beginning; longer = $0 }
length(typed) <= 100 && length($0) <= 200 {
  distance = edit_distance(typed, $0)
  if (distance < fewest && distance <= allowance($0)) { fewest = distance; nearest = $0 }
}
END { print (beginning == 1 && length(typed) >= 3 && length(typed) <= 100 ? longer : nearest) }
