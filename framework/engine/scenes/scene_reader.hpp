#pragma once
/// @file scene_reader.hpp
/// Reads values out of a JSON document and says precisely what is wrong with one.

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cs550/excerpt.hpp"
#include "cs550/math.hpp"
#include "engine/number_range.hpp"

namespace cs550 {

/// A value that is not what the schema asks for: its JSON path, what was expected, an example.
class SceneFault : public std::runtime_error {
 public:
  SceneFault(const std::string& path, const std::string& complaint)
      : std::runtime_error((path.empty() ? "/" : path) + ": " + complaint) {}
};

/// The names of an enumeration's values.
template <class Enum>
using Names = std::vector<std::pair<std::string, Enum>>;

/// One object of the document. It remembers which keys were asked for, so that the others can be
/// refused; for the same reason there is no list of keys beside the code that reads them.
///
/// In every read the variable's value on entry is the default, and the example in messages.
class SceneReader {
 public:
  using Json = nlohmann::json;

  /// @param path of the value, as a JSON pointer ("/bodies/3")
  /// @param example of such an object, for the message. Throws SceneFault unless the value is one.
  SceneReader(const Json& value, std::string path, const std::string& example);

  const std::string& path() const { return path_; }
  /// Whether the key is there; asks for it.
  bool has(const std::string& key);
  /// Throws unless the key is there.
  void require(const std::string& key, const std::string& example);

  void read(const std::string& key, Real& value, Range range = Range::Any);
  void read(const std::string& key, Real& value, double least, double most);
  void read(const std::string& key, int& value, int least, int most);
  void read(const std::string& key, std::uint32_t& value);
  void read(const std::string& key, bool& value);
  void read(const std::string& key, std::string& value);
  void read(const std::string& key, Vec3& value, Range range = Range::Any);
  /// A list of so many whole numbers.
  void read(const std::string& key, std::vector<int>& values, int least, int most);
  /// One of several names.
  template <class Enum>
  void read(const std::string& key, Enum& value, const Names<Enum>& names) {
    std::vector<std::string> words;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      words.push_back(names[i].first);
      if (names[i].second == value) chosen = i;
    }
    value = names[read_word(key, words, chosen)].second;
  }

  /// The same, where there is no default.
  template <class Value, class... Arguments>
  void need(const std::string& key, Value& value, const Arguments&... arguments) {
    if (!has(key)) require(key, example(value, arguments...));
    read(key, value, arguments...);
  }

  /// The object under a key. @pre has(key)
  SceneReader object(const std::string& key, const std::string& example);
  /// The values of the list under a key with their paths; none if there is no such key.
  std::vector<std::pair<const Json*, std::string>> list(const std::string& key,
                                                        const std::string& example);
  /// The same of a list of objects.
  /// @param example of one object
  std::vector<SceneReader> objects(const std::string& key, const std::string& example);
  /// A value as it is written in the file, cut short.
  static std::string excerpt(const Json& value);
  /// Whether a value is a number within the bounds of Range::Any.
  static bool is_number(const Json& value);
  /// Whether a string stands under a key. @pre has(key)
  bool is_string(const std::string& key) const { return value_.at(key).is_string(); }
  std::vector<std::string> keys() const;
  const Json& json(const std::string& key) const { return value_.at(key); }

  std::string path_of(const std::string& key) const { return path_ + "/" + cs550::excerpt(key); }

  /// Throws for the first key that nobody asked for, and names the nearest that somebody did.
  void refuse_other_keys() const;

  /// Throws a SceneFault about the value of a key.
  [[noreturn]] void refuse(const std::string& key, const std::string& expected,
                           const std::string& example) const;

 private:
  template <class Value, class... Arguments>
  static std::string example(const Value& value, const Arguments&...) {
    return show(value);
  }
  template <class Enum>
  static std::string example(const Enum&, const Names<Enum>& names) {
    return show(names.front().first);
  }
  static std::string show(Real value);
  static std::string show(int value);
  static std::string show(std::uint32_t value);
  static std::string show(const std::string& value);
  static std::string show(const Vec3& value);
  static std::string show(const std::vector<int>& values);

  std::size_t read_word(const std::string& key, const std::vector<std::string>& words,
                        std::size_t default_word);

  const Json& value_;
  std::string path_;
  std::vector<std::string> asked_;
};

}  // namespace cs550
