#include "cs550/scene.hpp"

#include <algorithm>
#include <fstream>
#include <optional>

#include "cs550/assets.hpp"
#include "cs550/excerpt.hpp"
#include "cs550/nearest_word.hpp"
#include "cs550/not_implemented.hpp"
#include "engine/scenes/scene_bodies.hpp"
#include "engine/scenes/scene_cost.hpp"
#include "engine/scenes/scene_document.hpp"
#include "engine/scenes/scene_generators.hpp"
#include "engine/scenes/scene_limits.hpp"
#include "engine/scenes/scene_settings.hpp"

namespace cs550 {
namespace {

namespace fs = std::filesystem;

constexpr int schema_version = 1;

void add_bodies(Scene& scene, std::vector<NamedBody> bodies) {
  for (NamedBody& body : bodies) {
    scene.bodies.push_back(std::move(body.def));
    scene.body_names.push_back(std::move(body.name));
  }
}

const std::string body_example =
    R"({"shape": {"kind": "box", "half_extents": [0.5, 0.5, 0.5]}, "position": [0, 0, 1]})";
const char* generator_example =
    R"({"kind": "stack", "count": 3, "body": {"shape": {"kind": "box", "half_extents": [1, 1, 1]}}})";

Scene read_scene(const nlohmann::json& document, const fs::path& file, SceneCost& cost) {
  SceneReader root(document, "", R"({"schema": 1, "bodies": [)" + body_example + "]}");
  int schema = schema_version;
  root.need("schema", schema, schema_version, schema_version);

  Scene scene;
  scene.name = excerpt(file.stem().string(), 200);  // it is printed
  scene.title = scene.name;
  root.read("title", scene.title);
  root.read("description", scene.description);
  root.read("h", scene.h, 1e-6, 1.0);
  root.read("steps", scene.steps, 1, 1000000);
  root.read("max_penetration", scene.max_penetration, Range::NotNegative);
  if (root.has("world")) {
    scene.settings = read_settings(root.object("world", R"({"gravity": [0, 0, -9.81]})"));
  }

  SceneShapes shapes(file.parent_path(), cost);
  if (root.has("shapes")) {
    shapes.define(
        root.object("shapes", R"({"brick": {"kind": "box", "half_extents": [0.2, 0.1, 0.05]}})"));
  }
  const auto bodies = root.objects("bodies", body_example);
  cost.add_bodies(static_cast<std::int64_t>(bodies.size()), "/bodies");
  std::vector<std::string> paths;
  for (const SceneReader& body : bodies) {
    add_bodies(scene, {read_body(body, shapes)});
    paths.push_back(body.path());
  }
  for (const SceneReader& generator : root.objects("generators", generator_example)) {
    add_bodies(scene, generate_bodies(generator, shapes, cost));
    paths.resize(scene.bodies.size(), generator.path());
  }
  root.refuse_other_keys();
  if (scene.bodies.empty()) {
    throw SceneFault("",
                     "expected at least one body in \"bodies\" or \"generators\"; for example "
                     "\"bodies\": [" +
                         body_example + "]");
  }
  refuse_beyond_float(scene, paths);
  cost.add_pairs(scene);
  return scene;
}

fs::path scenes_folder() { return assets_folder() / "scenes"; }

/// The file of a shipped scene, by its name, or of any scene, by its path; none if it is absent.
std::optional<fs::path> scene_file(const std::string& name_or_path) {
  std::error_code no_such_file;
  const fs::path shipped = scenes_folder() / (name_or_path + ".json");
  const bool is_name = !fs::path(name_or_path).has_parent_path();
  if (is_name && fs::exists(shipped, no_such_file)) return shipped;
  if (fs::is_regular_file(name_or_path, no_such_file)) return name_or_path;
  return std::nullopt;
}

/// The words with commas, in lines that fit into a terminal.
std::string list_of(const std::vector<std::string>& words) {
  constexpr std::size_t longest = 78;
  std::string list;
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty() && line.size() + word.size() + 2 > longest) {
      list += "\n  " + line;
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word + (&word == &words.back() ? "" : ",");
  }
  return list + "\n  " + line;
}

std::string list_of_shipped(const std::vector<std::string>& names) {
  if (names.empty()) {
    return "\nGive the path of a scene file. None is in " + excerpt(scenes_folder().string(), 300) +
           "; CS550_ASSETS chooses another folder.";
  }
  return "\nGive the path of a scene file or one of:" + list_of(names);
}

}  // namespace

SceneResult load_scene(const fs::path& file, const SceneLimits& limits) {
  if (!limits.fault.empty()) return {{}, limits.fault};
  constexpr std::size_t longest = 300;
  const std::string where = (file.empty() ? "\"\"" : excerpt(file.string(), longest)) + ": ";
  std::error_code unreadable;
  std::ifstream stream(file);
  if (!stream || fs::is_directory(file, unreadable)) {
    return {{}, where + "cannot be read; expected a scene file"};
  }
  try {
    SceneCost cost(limits);
    cost.add_file(file, "");
    return {read_scene(parse_scene_document(stream), file, cost), ""};
  } catch (const SceneFault& fault) {
    return {{}, where + fault.what()};
  } catch (const nlohmann::json::exception& error) {
    const std::string_view reason = error.what();  // after the parser's own number for it
    return {{},
            where + "this is not JSON: " + excerpt(reason.substr(reason.find("] ") + 2), longest)};
  } catch (const NotImplemented& missing) {
    return {{}, where + "its shapes cannot be made yet: " + missing.what(), missing.step()};
  }
}

std::string fault_of_scene_name(const std::string& name_or_path) {
  if (scene_file(name_or_path)) return {};
  const std::vector<std::string> names = shipped_scenes();
  const std::string nearest = nearest_word(name_or_path, names);
  return "there is no scene \"" + excerpt(name_or_path) + "\"" +
         (nearest.empty() ? "" : " (did you mean \"" + excerpt(nearest) + "\"?)") +
         list_of_shipped(names);
}

SceneResult find_scene(const std::string& name_or_path) {
  if (const std::optional<fs::path> file = scene_file(name_or_path)) return load_scene(*file);
  return {{}, fault_of_scene_name(name_or_path)};
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(scenes_folder(), unreadable)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

World make_world(const Scene& scene) {
  World world(scene.settings);
  for (const BodyDef& body : scene.bodies) world.add_body(body);
  return world;
}

}  // namespace cs550
