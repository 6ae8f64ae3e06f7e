#include "autograder/grader/worker/dispatch.hpp"

#include <string_view>

#include "autograder/grader/message.hpp"
#include "autograder/grader/substeps_archive.hpp"
#include "cs550/clipping.hpp"
#include "cs550/constraint_solver.hpp"
#include "cs550/integration.hpp"
#include "cs550/naive_solver.hpp"
#include "cs550/separating_axis.hpp"
#include "engine/world/stages.hpp"
#include "serialisation/arguments.hpp"

namespace cs550::grader {
namespace {

template <class R, class... P>
Server server(R (*)(P...)) {
  return [](void* address, serialisation::ByteReader& reader) {
    serialisation::Arguments<P...> arguments;
    reader(arguments);
    serialisation::ByteWriter writer;
    writer(Reply::Returned,
           serialisation::answer(reinterpret_cast<R (*)(P...)>(address), arguments));
    return writer.take();
  };
}

using Entry = std::pair<const std::string, Function>;

/// Its type is all that is used of the function.
template <auto function>
Entry lab_function(const char* symbol) {
  const Server serve = server(static_cast<decltype(function)>(nullptr));
  return {std::string(name_of<function>()), Function{symbol, {}, serve}};
}

std::string serve_substeps(void* /*given*/, serialisation::ByteReader& reader) {
  WorldState world;
  ContactStep step;
  int count = 0;
  archive_substeps_input(reader, world);
  reader(step, count);
  world.pairs.summaries.resize(world.pairs.size());  // a stage that is not written yet clears them
  run_substeps(world, step, count);
  serialisation::ByteWriter writer;
  writer(Reply::Returned, world.unwritten.any());
  archive_substeps_output(writer, world);
  return writer.take();
}

}  // namespace

const std::map<std::string, Function>& functions() {
  static const std::map<std::string, Function> functions{
#define CS550_LAB_FUNCTION(lab, function, symbol) lab_function<function>(symbol),
#include "lab_functions.inc"
#undef CS550_LAB_FUNCTION
      {"run_substeps",
       {nullptr,
        {"prepare_contacts", "warm_start", "solve_contacts", "apply_restitution"},
        serve_substeps}},
  };
  return functions;
}

}  // namespace cs550::grader
