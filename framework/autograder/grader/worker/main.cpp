/// Loads a submission and calls its functions for the judge.
///
///   lab_worker [--confine] SUBMISSION... -- LIBRARY...
///
/// SUBMISSION: the compiled code of a lab. LIBRARY: another lab, which the submission may call.
/// --confine: sees nothing but the submission's folder from then on.
#include <dlfcn.h>
#include <cs550/not_implemented.hpp>

#include <algorithm>
#include <cereal/types/string.hpp>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "autograder/grader/message.hpp"
#include "autograder/grader/worker/dispatch.hpp"
#include "autograder/grader/worker/lockdown.hpp"
#include "isolation/channel.hpp"

namespace {

using namespace cs550;
using namespace cs550::grader;
using serialisation::ByteReader;
using serialisation::ByteWriter;

template <class... Values>
std::string message(Reply kind, const Values&... values) {
  ByteWriter writer;
  writer(kind, values...);
  return writer.take();
}

/// Something that makes every further answer impossible.
struct Hopeless : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A function is looked up at its first call: one that is defined nowhere ends the worker then, so that only the tests
/// that call it fail. Labs that call each other are incomplete when the first of them is loaded.
void* load(const std::string& library) {
  void* handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_GLOBAL);
  if (handle == nullptr)
    throw Hopeless(std::string("the submission cannot be loaded: ") + dlerror());
  return handle;
}

/// Reads requests and answers them.
class Worker {
 public:
  explicit Worker(std::vector<void*> labs) : labs_(std::move(labs)) {}

  /// @return the reply; empty if there is none
  std::string serve(const std::string& bytes) {
    ByteReader request(bytes, &known_);
    Request kind{};
    request(kind);
    if (kind == Request::Shape) return learn<ConvexShape>(request);
    if (kind == Request::Mesh) return learn<HalfEdgeMesh>(request);
    std::string name;
    request(name);
    return call(functions().at(name), name, request);
  }

 private:
  template <class Content>
  std::string learn(ByteReader& request) {
    auto content = std::make_shared<Content>();
    request(*content);
    known_.add(content);
    return {};
  }

  void* address_of(const std::string& name) const {
    const char* symbol = functions().at(name).symbol;
    if (symbol == nullptr) return nullptr;
    for (void* lab : labs_) {
      if (void* address = dlsym(lab, symbol)) return address;
    }
    throw Hopeless("the submission does not define " + name);
  }

  std::string call(const Function& function, const std::string& name, ByteReader& arguments) {
    for (const std::string& called : function.calls) address_of(called);
    void* address = address_of(name);
    try {
      return function.serve(address, arguments);
    } catch (const NotImplemented& missing) {
      return message(Reply::NotImplemented, missing.step(), missing.function(),
                     std::string(missing.what()));
    } catch (const std::exception& error) {
      return message(Reply::Threw, std::string(error.what()));
    } catch (...) {
      return message(Reply::Threw, std::string("its type is not derived from std::exception"));
    }
  }

  std::vector<void*> labs_;
  serialisation::ContentRegistry known_;
};

/// @return what to call functions of. Nothing that the submission does can be undone from here on.
std::vector<void*> prepare(std::vector<std::string> arguments) {
  const bool confined = arguments.front() == "--confine";
  if (confined) arguments.erase(arguments.begin());
  const auto end = std::find(arguments.begin(), arguments.end(), "--");
  std::vector<std::filesystem::path> submissions(arguments.begin(), end);
  for (auto library = end + 1; library < arguments.end(); ++library) load(*library);
  functions();
  if (confined && confine_to(submissions.front().parent_path())) {
    for (std::filesystem::path& submission : submissions) submission = "/" / submission.filename();
  }
  forbid_system_calls();
  std::vector<void*> labs;
  labs.reserve(submissions.size());
  for (const std::filesystem::path& submission : submissions) labs.push_back(load(submission));
  return labs;
}

}  // namespace

int main(int argc, char** argv) {
  isolation::Channel channel(worker_channel);
  try {
    Worker worker(prepare({argv + 1, argv + argc}));
    channel.send(message(Reply::Ready));
    for (std::string request; channel.receive(request, {}) == isolation::Channel::Wait::Received;) {
      const std::string reply = worker.serve(request);
      if (!reply.empty()) channel.send(reply);
    }
  } catch (const std::exception& error) {
    channel.send(message(Reply::Refused, std::string(error.what())));
  }
}
