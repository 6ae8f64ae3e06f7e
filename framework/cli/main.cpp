// The program behind ./cs550. The launcher builds it, so that it need not be installed.
#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <string>

#include "verb.hpp"

namespace {

using namespace cs550::cli;

struct Verb {
  const char* name;
  const char* summary;
  Action (*declare)(CLI::App& app);
};

constexpr Verb verbs[] = {
#define CS550_VERB(name, preset, packages, arguments, summary) {#name, summary, declare_##name},
#define CS550_SCRIPT(...)
#define CS550_PLANNED(...)
#include "verbs.def"
#undef CS550_VERB
#undef CS550_SCRIPT
#undef CS550_PLANNED
};

/// A name as it is typed: `gradescope-zip` for gradescope_zip.
std::string typed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

int run(int argc, char** argv) {
  CLI::App app("A 3D rigid-body physics engine in seven labs", "./cs550");
  app.require_subcommand(1);
  std::map<const CLI::App*, Action> actions;
  for (const Verb& verb : verbs) {
    CLI::App* part = app.add_subcommand(typed(verb.name), verb.summary);
    actions[part] = verb.declare(*part);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? Good : Misused;
  }
  return actions.at(app.get_subcommands().front())();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "cs550: " << error.what() << '\n';
    return Failed;
  }
}
