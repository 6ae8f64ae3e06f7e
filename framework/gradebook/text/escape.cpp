#include "gradebook/text/escape.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "files/markup.hpp"

namespace cs550::gradebook {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// The length of the valid UTF-8 character at the start of the text; 0 if there is none.
/// Overlong forms, surrogates and anything above U+10FFFF are invalid (RFC 3629).
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  if (byte(0) < 0x80) return 1;
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xF0 && byte(1) < 0x90);
  const bool beyond = (byte(0) == 0xED && byte(1) > 0x9F) || (byte(0) == 0xF4 && byte(1) > 0x8F);
  return overlong || beyond ? 0 : length;
}

/// The length of the terminal's escape sequence at the start of the text (ECMA-48): ESC [ ...
/// letter, or ESC ] ... up to BEL or ESC \.
std::size_t escape_length(std::string_view text) {
  if (text.size() < 2) return 1;
  if (text[1] == '[') {
    const auto end =
        std::find_if(text.begin() + 2, text.end(), [](char c) { return c >= '@' && c <= '~'; });
    return static_cast<std::size_t>(end - text.begin()) + (end != text.end() ? 1 : 0);
  }
  if (text[1] == ']') {
    const std::size_t end = text.find_first_of("\a\033", 2);
    if (end == std::string_view::npos) return text.size();
    return text.substr(end).starts_with("\033\\") ? end + 2 : end + 1;
  }
  return 2;
}

/// Control characters (C0, C1, DEL), the marks that reverse the direction of text, and U+FFFE and U+FFFF,
/// which no XML document may contain.
bool is_invisible(std::string_view character) {
  if (character.size() == 1) {
    return (character[0] >= 0 && character[0] < ' ') || character[0] == '\x7F';
  }
  const bool is_c1 = character[0] == '\xC2' && static_cast<std::uint8_t>(character[1]) < 0xA0;
  const bool is_direction = (character >= "\xE2\x80\xAA" && character <= "\xE2\x80\xAE") ||
                            (character >= "\xE2\x81\xA6" && character <= "\xE2\x81\xA9");
  const bool is_noncharacter = character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
  return is_c1 || is_direction || is_noncharacter;
}

}  // namespace

std::string plain_text(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    std::size_t length = character_length(text);
    if (text[0] == '\033') {
      length = escape_length(text);
    } else if (length == 0) {
      plain += replacement;
      length = 1;
    } else if (text[0] == '\n' || text[0] == '\t' || !is_invisible(text.substr(0, length))) {
      plain += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return plain;
}

std::string plain_line(std::string_view text) {
  std::string line = plain_text(text);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line;
}

std::string shortened(std::string_view text, std::size_t most) {
  std::string plain = plain_text(text);
  if (plain.size() <= most) return plain;
  while (most > 0 && (plain[most] & 0xC0) == 0x80) --most;
  return plain.substr(0, most) + "\n… (cut)";
}

std::string html(std::string_view text) { return files::escape_markup(plain_text(text)); }

std::string csv(std::string_view field) {
  std::string text = plain_line(field);
  const std::size_t start = text.find_first_not_of(' ');
  if (start != std::string::npos &&
      std::string_view("=+-@").find(text[start]) != std::string::npos) {
    text.insert(0, 1, '\'');
  }
  if (text.find_first_of("\",;") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string in_shell(const std::string& word) {
  const bool is_plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("%+,-./:=@_").find(c) != std::string_view::npos;
  });
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string markdown(std::string_view text) {
  std::string result;
  for (const char c : plain_line(text)) {
    if (std::string_view("\\`*_{}[]()<>#+-!|&~=:@$").find(c) != std::string_view::npos)
      result += '\\';
    result += c;
  }
  return result;
}

std::string markdown_block(std::string_view text) {
  const std::string plain = plain_text(text);
  std::size_t fence = 3;
  for (std::size_t i = 0; i < plain.size();) {
    const std::size_t end = std::min(plain.find_first_not_of('`', i), plain.size());
    fence = std::max(fence, end - i + 1);
    i = end + 1;
  }
  const std::string line(fence, '`');
  return line + "text\n" + plain + (plain.ends_with('\n') ? "" : "\n") + line + '\n';
}

}  // namespace cs550::gradebook
