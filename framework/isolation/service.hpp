#pragma once
/// @file service.hpp
/// Calls code that may throw, crash or never return, and always returns a reply.

#include <cereal/types/string.hpp>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "isolation/child.hpp"
#include "serialisation/bytes.hpp"

namespace cs550::isolation {

/// The process in which code runs.
enum class Isolation {
  Here,   ///< in this process: trusted code
  Child,  ///< in a child process with a time limit: a student's code
};

/// The time limit for a reply of an untrusted server.
inline constexpr std::chrono::seconds answer_limit{5};

/// A value, or the reason why it is missing.
template <class Value>
struct Answer {
  Value value;          ///< default-constructed after a failure
  std::string failure;  ///< empty after a success
};

template <class Archive, class Value>
void serialize(Archive& archive, Answer<Value>& answer) {
  archive(answer.value, answer.failure);
}

/// Answers requests. It may keep state between them.
template <class Request, class Reply>
using Server = std::function<Reply(const Request&)>;

/// Calls a server and turns an exception into a failure.
template <class Request, class Reply>
Answer<Reply> guarded(const Server<Request, Reply>& serve, const Request& request) {
  try {
    return {serve(request), ""};
  } catch (const std::bad_alloc&) {
    return {{}, "ran out of memory"};
  } catch (const std::exception& error) {
    return {{}, error.what()};
  } catch (...) {
    return {{}, "threw something that is not a std::exception"};
  }
}

/// A server in this process or in a child. After a child crashes, exits or exceeds the time limit,
/// this request and all later ones fail with a message about the cause.
template <class Request, class Reply>
class Service {
 public:
  /// @param limit time for each reply of a child
  Service(Server<Request, Reply> serve, Isolation isolation,
          std::chrono::milliseconds limit = answer_limit)
      : limit_(limit) {
    if (isolation == Isolation::Here) {
      here_ = std::move(serve);
      return;
    }
    child_ = std::make_unique<Child>([&serve](Channel& channel) {
      std::string message;
      while (channel.receive(message, {}) == Channel::Wait::Received) {
        const auto request = serialisation::from_bytes<Request>(message);
        channel.send(serialisation::to_bytes(guarded(serve, request)));
      }
    });
  }

  /// The server's reply, or the reason why it is missing.
  Answer<Reply> ask(const Request& request) {
    if (here_) return guarded(here_, request);
    if (!child_) return {{}, failure_};
    std::string message;
    const bool sent = child_->channel().send(serialisation::to_bytes(request));
    const Channel::Wait wait =
        sent ? child_->channel().receive(message, limit_) : Channel::Wait::Closed;
    if (wait == Channel::Wait::Received) {
      return serialisation::from_bytes<Answer<Reply>>(message);
    }
    failure_ = child_->end();
    if (wait == Channel::Wait::TooLate) {
      const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(limit_);
      failure_ = "stopped after " + std::to_string(seconds.count()) +
                 " s without an answer (an endless loop?)";
    }
    child_.reset();
    return {{}, failure_};
  }

 private:
  std::chrono::milliseconds limit_;
  Server<Request, Reply> here_;
  std::unique_ptr<Child> child_;
  std::string failure_;
};

}  // namespace cs550::isolation
