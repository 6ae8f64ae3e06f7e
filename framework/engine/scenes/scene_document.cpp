#include "engine/scenes/scene_document.hpp"

#include <set>
#include <string>
#include <vector>

#include "cs550/excerpt.hpp"
#include "engine/scenes/scene_reader.hpp"

namespace cs550 {
namespace {

using Json = nlohmann::json;

/// A generator's body's orientation's axis is at depth 6. Recursive code (printing an excerpt) is safe
/// well beyond this.
constexpr std::size_t most_levels = 32;

/// Follows the parser through the text: which value it is at, and which keys each open object has.
class Position {
 public:
  void open(bool is_list) {
    levels_.push_back({is_list, 0, {}, {}});
    if (levels_.size() > most_levels) {
      throw SceneFault(path(), "expected at most " + std::to_string(most_levels) +
                                   " levels of lists and objects, found more; a scene needs 6");
    }
  }

  void enter(const std::string& key) {
    Level& object = levels_.back();
    const bool is_new = object.keys.insert(key).second;
    object.key = key;
    if (!is_new) {
      throw SceneFault(path(), "expected each key once, found \"" + excerpt(key) +
                                   "\" a second time in this object; remove one of the two");
    }
  }

  void close() {
    levels_.pop_back();
    finish_value();
  }

  void finish_value() {
    if (!levels_.empty() && levels_.back().is_list) ++levels_.back().index;
  }

  /// The value that is being read, as a JSON pointer.
  std::string path() const {
    std::string path;
    for (const Level& level : levels_) {
      if (level.is_list || !level.key.empty()) {
        path += "/" + (level.is_list ? std::to_string(level.index) : excerpt(level.key));
      }
    }
    return path;
  }

 private:
  struct Level {
    bool is_list;
    int index;
    std::string key;
    std::set<std::string> keys;
  };
  std::vector<Level> levels_;
};

}  // namespace

Json parse_scene_document(std::istream& text) {
  Position position;
  const auto follow = [&](int, Json::parse_event_t event, const Json& value) {
    switch (event) {
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        position.open(event == Json::parse_event_t::array_start);
        break;
      case Json::parse_event_t::object_end:
      case Json::parse_event_t::array_end:
        position.close();
        break;
      case Json::parse_event_t::key:
        position.enter(value.get<std::string>());
        break;
      case Json::parse_event_t::value:
        position.finish_value();
        break;
    }
    return true;
  };
  try {
    return Json::parse(text, follow);
  } catch (const Json::out_of_range&) {
    throw SceneFault(position.path(), "expected a number below 1e308, found one that is larger");
  }
}

}  // namespace cs550
