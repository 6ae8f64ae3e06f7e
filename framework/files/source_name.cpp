#include "files/source_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace cs550::files {
namespace {

constexpr std::array<std::string_view, 11> extensions{
    ".cpp", ".hpp", ".h", ".hh", ".hxx", ".inl", ".ipp", ".inc", ".tpp", ".tcc", ".def"};

bool is_plain(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string_view("_-./").find(letter) != std::string_view::npos;
}

}  // namespace

bool is_source(const std::filesystem::path& file) {
  const std::string extension = file.extension();
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::string source_extensions() {
  std::string text;
  for (const std::string_view extension : extensions) {
    text += (text.empty() ? "" : ", ") + std::string(extension);
  }
  return text;
}

bool has_plain_name(const std::filesystem::path& file) {
  const std::string name = file.string();
  return !name.starts_with('-') && std::all_of(name.begin(), name.end(), is_plain);
}

std::string plain_name(const std::filesystem::path& file) {
  std::string name = file.string();
  std::replace_if(
      name.begin(), name.end(), [](char letter) { return !is_plain(letter); }, '_');
  if (name.starts_with('-')) name.front() = '_';
  return name;
}

}  // namespace cs550::files
