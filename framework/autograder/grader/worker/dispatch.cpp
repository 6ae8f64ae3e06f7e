#include "autograder/grader/worker/dispatch.hpp"

#include <string_view>

#include "autograder/grader/message.hpp"
#include "cs550/clipping.hpp"
#include "cs550/constraint_solver.hpp"
#include "cs550/integration.hpp"
#include "cs550/naive_solver.hpp"
#include "cs550/separating_axis.hpp"
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

/// Its type is all that is used of the function.
template <auto function>
std::pair<const std::string, LabFunction> entry(const char* symbol) {
  return {std::string(name_of<function>()),
          LabFunction{symbol, server(static_cast<decltype(function)>(nullptr))}};
}

}  // namespace

const std::map<std::string, LabFunction>& lab_functions() {
  static const std::map<std::string, LabFunction> functions{
#define CS550_LAB_FUNCTION(lab, function, symbol) entry<function>(symbol),
#include "lab_functions.inc"
#undef CS550_LAB_FUNCTION
  };
  return functions;
}

}  // namespace cs550::grader
