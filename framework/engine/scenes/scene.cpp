#include "cs550/scene.hpp"

#include <algorithm>
#include <fstream>

#include "cs550/assets.hpp"
#include "cs550/not_implemented.hpp"
#include "engine/scenes/nearest_word.hpp"
#include "engine/scenes/scene_bodies.hpp"
#include "engine/scenes/scene_generators.hpp"
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

Scene read_scene(const nlohmann::json& document, const fs::path& file) {
  SceneReader root(document, "");
  int schema = schema_version;
  root.need("schema", schema, schema_version, schema_version);

  Scene scene;
  scene.name = file.stem().string();
  scene.title = scene.name;
  root.read("title", scene.title);
  root.read("description", scene.description);
  root.read("h", scene.h, Range::Positive);
  root.read("steps", scene.steps, 1, 1000000);
  root.read("max_penetration", scene.max_penetration, Range::NotNegative);
  if (root.has("world")) scene.settings = read_settings(root.object("world"));

  SceneShapes shapes(file.parent_path());
  if (root.has("shapes")) shapes.define(root.object("shapes"));
  for (const auto& [body, path] : root.list("bodies")) {
    add_bodies(scene, {read_body({*body, path}, shapes)});
  }
  for (const auto& [generator, path] : root.list("generators")) {
    add_bodies(scene, generate_bodies({*generator, path}, shapes));
  }
  root.refuse_other_keys();
  if (scene.bodies.empty()) {
    throw SceneFault("", "expected at least one body in \"bodies\" or \"generators\"");
  }
  return scene;
}

fs::path scenes_folder() { return assets_folder() / "scenes"; }

std::string list_of(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace

SceneResult load_scene(const fs::path& file) {
  const std::string where = file.string() + ": ";
  std::ifstream stream(file);
  if (!stream || fs::is_directory(file)) return {{}, where + "cannot be read"};
  try {
    return {read_scene(nlohmann::json::parse(stream), file), ""};
  } catch (const SceneFault& fault) {
    return {{}, where + fault.what()};
  } catch (const nlohmann::json::exception& error) {
    return {{}, where + "this is not JSON: " + error.what()};
  } catch (const NotImplemented& missing) {
    return {{}, where + "its shapes cannot be made yet: " + missing.what()};
  }
}

SceneResult find_scene(const std::string& name_or_path) {
  const fs::path shipped = scenes_folder() / (name_or_path + ".json");
  if (fs::exists(shipped)) return load_scene(shipped);
  if (fs::is_regular_file(name_or_path)) return load_scene(name_or_path);

  const std::vector<std::string> names = shipped_scenes();
  const std::string nearest = nearest_word(name_or_path, names);
  return {{},
          "there is no scene \"" + name_or_path + "\"" +
              (nearest.empty() ? "" : " (did you mean \"" + nearest + "\"?)") +
              "; give the path of a scene file or one of: " + list_of(names)};
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
