#include "files/usage_fault.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "cs550/nearest_word.hpp"

namespace cs550::files {

namespace {

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

/// What surrounds a phrase of the library: "--reset" and "--run" for " excludes ".
struct Phrase {
  std::string before;
  std::string after;
};

std::optional<Phrase> split_at(const std::string& words, std::string_view middle) {
  const std::size_t place = words.find(middle);
  if (place == std::string::npos) return std::nullopt;
  return Phrase{words.substr(0, place), words.substr(place + middle.size())};
}

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : " ") + word;
  return list;
}

/// The dashes say nothing about which option was meant.
std::string letters_of(const std::string& option) {
  return option.substr(std::min(option.find_first_not_of('-'), option.size()));
}

/// Whether an option may be suggested for what was typed. Those that replace a student's files need more than
/// some likeness.
bool may_be_meant(const std::string& typed, const std::string& option) {
  const bool replaces_files = option == "reset" || option == "use-solution";
  return !replaces_files || begins_with(option, typed) || edit_distance(typed, option) == 1;
}

std::string no_such_option(const std::string& word, const std::vector<Argument>& arguments) {
  const std::string typed = word.substr(0, word.find('='));
  const std::string letters = letters_of(typed);
  std::vector<std::string> options;
  for (const Argument& argument : arguments) {
    const std::string option = letters_of(argument.name);
    const bool has_letters = begins_with(argument.name, "--");
    if (has_letters && may_be_meant(letters, option)) options.push_back(option);
  }
  const std::string nearest = nearest_word(letters, options);
  return "there is no option " + typed +
         (nearest.empty() ? "." : ". Did you mean --" + nearest + "?");
}

Argument argument_called(const std::string& name, const std::vector<Argument>& arguments) {
  const auto found = std::find_if(arguments.begin(), arguments.end(),
                                  [&](const Argument& argument) { return argument.name == name; });
  return found != arguments.end() ? *found : Argument{name, "", ""};
}

/// "--step needs a value: --step STEP"
std::string absent_value(const Argument& option) {
  const bool is_named = !option.value.empty();
  return option.name + " needs a value" +
         (is_named ? ": " + option.name + ' ' + option.value : ".");
}

/// "N is missing: number of the lab"
std::string absent(const Argument& argument) {
  return argument.name + " is missing" + (argument.meaning.empty() ? "." : ": " + argument.meaning);
}

/// The bounds of "1 to 3" or "[1 - 3]", which depends on the library's version.
std::string bounds(std::string range) {
  if (begins_with(range, "[")) range = range.substr(1, range.size() - 2);
  const std::optional<Phrase> dash = split_at(range, " - ");
  return dash ? dash->before + " to " + dash->after : range;
}

/// "--hint: Value 9 not in range 1 to 3"
std::string out_of_range(const std::string& words) {
  const std::optional<Phrase> name = split_at(words, ": Value ");
  const std::optional<Phrase> value = name ? split_at(name->after, " not in range ") : std::nullopt;
  if (!value) return "";
  return name->before + " needs a whole number from " + bounds(value->after) + ", found " +
         value->before;
}

}  // namespace

std::string usage_fault(const UsageReport& report) {
  const std::string& words = report.words;
  const auto option = std::find_if(report.unused.begin(), report.unused.end(), is_option);
  if (option != report.unused.end()) return no_such_option(*option, report.arguments);
  if (const auto flag = split_at(words, " was given a disallowed flag override")) {
    return "--" + flag->before + " takes no value";
  }
  // The message itself speaks of a lab or a scene.
  for (const std::string_view argument : {"N: ", "SCENE: "}) {
    if (begins_with(words, argument)) return words.substr(argument.size());
  }
  if (const auto name = split_at(words, ": 1 required "); name && ends_with(words, " missing")) {
    return absent_value(argument_called(name->before, report.arguments));
  }
  if (ends_with(words, " is required")) {
    return absent(argument_called(split_at(words, " is required")->before, report.arguments));
  }
  if (const auto name = split_at(words, ": At Most 1 required but received ")) {
    return name->before + " can be given only once";
  }
  if (const auto pair = split_at(words, " excludes ")) {
    return pair->before + " and " + pair->after + " cannot be used together";
  }
  if (const std::string fault = out_of_range(words); !fault.empty()) return fault;
  std::vector<std::string> unexpected = report.unused;
  unexpected.insert(unexpected.end(), report.after_dashes.begin(), report.after_dashes.end());
  if (!unexpected.empty()) {
    return std::string(unexpected.size() == 1 ? "this argument is" : "these arguments are") +
           " not expected: " + joined(unexpected);
  }
  return words;
}

}  // namespace cs550::files
