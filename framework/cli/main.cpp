// The program behind ./cs550. The launcher builds it, so that it need not be installed.
#include <exception>
#include <map>
#include <memory>
#include <string>

#include "cli/command_line.hpp"
#include "cli/verb.hpp"
#include "files/output_file.hpp"

namespace {

using namespace cs550;
using namespace cs550::cli;

struct Verb {
  const char* name;
  const char* summary;
  Action (*declare)(CLI::App& app);
};

constexpr Verb verbs[] = {
#define CS550_VERB(name, preset, packages, arguments, summary) {#name, summary, declare_##name},
#include "cli/verbs.def"
};

int run(int argc, char** argv) {
  CLI::App app("A 3D rigid-body physics engine in seven labs", "./cs550");
  app.formatter(std::make_shared<Help>());
  app.require_subcommand(1);
  std::map<const CLI::App*, Action> actions;
  for (const Verb& verb : verbs) {
    CLI::App* part = app.add_subcommand(verb.name, verb.summary);
    actions[part] = verb.declare(*part);
    check_values(*part);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const auto found = app.get_subcommands();
    return answer(app, error, found.empty() ? "VERB" : found.front()->get_name());
  }
  const int exit_code = actions.at(app.get_subcommands().front())();
  files::check_standard_output();
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    print_failure(error);
    return Failed;
  }
}
