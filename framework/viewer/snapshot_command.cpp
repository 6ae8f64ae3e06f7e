#include "viewer/snapshot_command.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace cs550::viewer {

namespace {

/// A word as a shell reads it.
std::string in_shell(const std::string& word) {
  const bool is_plain =
      !word.empty() && word.find_first_not_of(
                           "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                           "%+,-./:=@_") == std::string::npos;
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

/// What was typed. The launcher replaced the name of a failing test by the path of its picture.
std::vector<std::string> typed_words(const Options& options) {
  std::vector<std::string> words = options.arguments;
  std::replace(words.begin(), words.end(), options.failure.string(),
               options.failure.stem().string());
  return words;
}

std::string name_of_picture(const Options& options) {
  if (!options.failure.empty()) return options.failure.stem().string() + ".png";
  if (options.lab != 0) return "lab" + std::to_string(options.lab) + ".png";
  return std::filesystem::path(options.scene).stem().string() + ".png";
}

}  // namespace

std::string snapshot_command(const Options& options) {
  constexpr std::size_t longest = 78;  // of 80 columns, two are for " \" at the end
  std::vector<std::string> words = typed_words(options);
  words.insert(words.end(), {"--snapshot", name_of_picture(options)});
  std::string text;
  std::string line = "./cs550 view";
  for (const std::string& word : words) {
    const std::string next = in_shell(word);
    if (line.size() + 1 + next.size() > longest) {
      text += line + " \\\n";
      line = "   ";
    }
    line += ' ' + next;
  }
  return text + line;
}

}  // namespace cs550::viewer
