#include "xml.hpp"

#include <cctype>
#include <set>
#include <stdexcept>
#include <vector>

namespace cs550::test {
namespace {

/// Reads a document and throws a message at the first error.
class Reader {
 public:
  explicit Reader(const std::string& document) : text_(document) {}

  void read() {
    while (place_ < text_.size()) {
      if (peek("</")) {
        read_end_tag();
      } else if (peek("<")) {
        read_start_tag();
      } else {
        read_character();
      }
    }
    if (!open_.empty()) throw std::runtime_error("<" + open_.back() + "> is never closed");
    if (roots_ != 1) throw std::runtime_error(std::to_string(roots_) + " root elements");
  }

 private:
  bool peek(const std::string& what) const { return text_.compare(place_, what.size(), what) == 0; }

  void expect(const std::string& what) {
    if (!peek(what)) {
      throw std::runtime_error("expected " + what + " before: " + text_.substr(place_, 40));
    }
    place_ += what.size();
  }

  void skip_spaces() {
    while (place_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[place_])) != 0) {
      ++place_;
    }
  }

  std::string read_name() {
    const std::size_t start = place_;
    while (place_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[place_])) != 0 ||
                                     text_[place_] == '-' || text_[place_] == ':')) {
      ++place_;
    }
    if (place_ == start) throw std::runtime_error("no name before: " + text_.substr(start, 40));
    return text_.substr(start, place_ - start);
  }

  void read_start_tag() {
    expect("<");
    const std::string name = read_name();
    if (open_.empty()) ++roots_;
    std::set<std::string> attributes;
    for (skip_spaces(); !peek(">") && !peek("/>"); skip_spaces()) {
      const std::string attribute = read_name();
      if (!attributes.insert(attribute).second) {
        throw std::runtime_error("two attributes " + attribute);
      }
      expect("=\"");
      while (!peek("\"")) read_character();
      expect("\"");
    }
    if (peek("/>")) {
      expect("/>");
    } else {
      expect(">");
      open_.push_back(name);
    }
  }

  void read_end_tag() {
    expect("</");
    const std::string name = read_name();
    if (open_.empty() || open_.back() != name) {
      throw std::runtime_error("</" + name + "> closes what is not open");
    }
    open_.pop_back();
    expect(">");
  }

  void read_character() {
    if (place_ >= text_.size()) throw std::runtime_error("the text ends within an element");
    const auto letter = static_cast<unsigned char>(text_[place_]);
    if (letter == '<') throw std::runtime_error("bare < in text");
    if (letter < 0x20 && std::isspace(letter) == 0) throw std::runtime_error("control character");
    if (letter != '&') {
      ++place_;
      return;
    }
    for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}) {
      if (peek(entity)) return expect(entity);
    }
    throw std::runtime_error("bare & before: " + text_.substr(place_, 40));
  }

  const std::string& text_;
  std::size_t place_ = 0;
  std::vector<std::string> open_;
  int roots_ = 0;
};

}  // namespace

std::string xml_fault(const std::string& document) {
  try {
    Reader(document).read();
    return "";
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
}

int count(const std::string& document, const std::string& text) {
  int times = 0;
  for (std::size_t at = document.find(text); at != std::string::npos;
       at = document.find(text, at + 1)) {
    ++times;
  }
  return times;
}

}  // namespace cs550::test
