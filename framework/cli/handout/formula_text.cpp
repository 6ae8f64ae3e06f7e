#include "cli/handout/formula_text.hpp"

#include <cctype>
#include <map>
#include <sstream>

namespace cs550::cli {
namespace {

using Names = std::map<std::string, std::string, std::less<>>;

/// Commands that become one sign, or nothing.
const Names signs = {
    {"beta", "β"},     {"delta", "δ"},    {"Delta", "Δ"},   {"varepsilon", "ε"},  {"lambda", "λ"},
    {"mu", "μ"},       {"omega", "ω"},    {"tau", "τ"},     {"ell", "ℓ"},         {"sum", " Σ"},
    {"cdot", "·"},     {"times", " × "},  {"oplus", " ⊕ "}, {"pm", "±"},          {"le", " ≤ "},
    {"ge", " ≥ "},     {"in", " ∈ "},     {"to", " → "},    {"leftarrow", " ← "}, {"iff", " ⇔ "},
    {"lVert", "‖"},    {"rVert", "‖"},    {"lfloor", "⌊"},  {"rfloor", "⌋"},      {"bigl", ""},
    {"bigr", ""},      {"qquad", "   "},  {",", " "},       {";", " "},           {"parallel", "∥"},
    {"triangle", "△"}, {"bmod", " mod "}, {"max", " max"},  {"min", " min"},      {"exp", "exp"},
    {"arg", " arg "},  {"\\", "; "}};

const Names superscripts = {{"0", "⁰"}, {"1", "¹"}, {"2", "²"},   {"3", "³"},
                            {"T", "ᵀ"}, {"*", "*"}, {"-1", "⁻¹"}, {"-7", "⁻⁷"}};

std::string found_or(const Names& names, const std::string& name, const std::string& otherwise) {
  const auto found = names.find(name);
  return found == names.end() ? otherwise : found->second;
}

bool is_one_term(const std::string& text) {
  return text.find_first_of(" +-/") == std::string::npos && text.find("·") == std::string::npos;
}

std::string in_brackets(const std::string& text) {
  return is_one_term(text) ? text : '(' + text + ')';
}

std::string fraction(const std::string& above, const std::string& below) {
  if (above == "1" && below == "2") return "½";
  return in_brackets(above) + '/' + in_brackets(below) + ' ';
}

/// Reads a formula from its first character to its last, by recursive descent.
class Formula {
 public:
  explicit Formula(std::string_view source) : source_(source) {}

  /// A closing brace without an opening one is kept.
  std::string text() {
    std::string result = group();
    while (!source_.empty()) {
      result += take();
      result += group();
    }
    return result;
  }

 private:
  std::string group() {
    std::string result;
    while (!source_.empty() && source_.front() != '}') result += item();
    return result;
  }

  char take() {
    const char first = source_.front();
    source_.remove_prefix(1);
    return first;
  }

  bool next_is_letter() const {
    return !source_.empty() && std::isalpha(static_cast<unsigned char>(source_.front())) != 0;
  }

  std::string item() {
    switch (const char c = take()) {
      case '{':
        return rest_of_group();
      case '\\':
        return command();
      case '_':
        return lowered(argument());
      case '^':
        return raised(argument());
      case '&':
        return " ";
      default:
        return {c};
    }
  }

  std::string rest_of_group() {
    std::string inside = group();
    if (!source_.empty()) take();
    return inside;
  }

  std::string argument() {
    while (!source_.empty() && source_.front() == ' ') take();
    return source_.empty() ? "" : item();
  }

  /// A word of letters or a single other character.
  std::string name() {
    std::string letters;
    while (next_is_letter()) letters += take();
    return letters.empty() && !source_.empty() ? std::string{take()} : letters;
  }

  /// The space between a command and its operand only ends the command's name.
  void skip_space_before_operand() {
    const std::size_t next = source_.find_first_not_of(' ');
    if (next == source_.npos) return;
    const char c = source_[next];
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '(') source_.remove_prefix(next);
  }

  std::string command() {
    const std::string command = name();
    skip_space_before_operand();
    if (command == "frac" || command == "tfrac" || command == "dfrac") {
      const std::string above = argument();
      return fraction(above, argument());
    }
    if (command == "text" || command == "mathrm" || command == "operatorname") return argument();
    if (command == "sqrt") return "√" + in_brackets(argument());
    if (command == "widehat") return "unit(" + argument() + ')';
    if (command == "begin") return argument(), "(";
    if (command == "end") return argument(), ")";
    return found_or(signs, command, '\\' + command);
  }

  std::string lowered(const std::string& index) const {
    return '_' + in_brackets(index) + (next_is_letter() ? " " : "");
  }

  static std::string raised(const std::string& exponent) {
    return found_or(superscripts, exponent, '^' + in_brackets(exponent));
  }

  std::string_view source_;
};

/// Single spaces, and none at the ends or inside brackets.
std::string evenly_spaced(const std::string& text) {
  constexpr std::string_view ends = ",;.)";
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) {
    const bool is_close =
        result.empty() || result.back() == '(' || ends.find(word.front()) != ends.npos;
    result += (is_close ? "" : " ") + word;
  }
  return result;
}

}  // namespace

std::string with_plain_formulas(std::string_view markdown) {
  std::string result;
  while (!markdown.empty()) {
    const std::size_t opening = markdown.find('$');
    result += markdown.substr(0, opening);
    const std::size_t closing =
        opening == markdown.npos ? opening : markdown.find('$', opening + 1);
    if (closing == markdown.npos) {
      result += opening == markdown.npos ? "" : markdown.substr(opening);
      break;
    }
    const std::string_view formula = markdown.substr(opening + 1, closing - opening - 1);
    result += evenly_spaced(Formula(formula).text());
    markdown.remove_prefix(closing + 1);
  }
  return result;
}

}  // namespace cs550::cli
