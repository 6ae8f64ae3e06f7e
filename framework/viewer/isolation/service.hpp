#pragma once
/// @file service.hpp
/// Asks code for answers, whether or not it can be trusted to give any.

#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>

#include "viewer/content.hpp"
#include "viewer/isolation/child.hpp"
#include "viewer/isolation/wire.hpp"

namespace cs550::viewer {

/// Where code runs.
enum class Isolation {
  Here,   ///< in this process: code that is known to be sound
  Child,  ///< in a process of its own, with a time limit: a student's
};

/// How long an answer may take from code that is not trusted.
inline constexpr std::chrono::seconds answer_limit{5};

/// What answers requests; it may keep state from one to the next.
template <class Request, class Reply>
using Server = std::function<Reply(const Request&)>;

/// Calls a server, and turns what it throws into a sentence.
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

/// A server, here or in a child process. One that crashes, ends or takes too long answers with a
/// sentence about it, and so it does to every later request.
template <class Request, class Reply>
class Service {
 public:
  /// @param limit for each answer of a child
  Service(Server<Request, Reply> serve, Isolation isolation,
          std::chrono::milliseconds limit = answer_limit)
      : limit_(limit) {
    if (isolation == Isolation::Here) {
      here_ = std::move(serve);
      return;
    }
    child_ = std::make_unique<Child>([&serve](const Channel& channel) {
      std::string message;
      while (channel.receive(message, {}) == Channel::Wait::Received) {
        const Answer<Reply> answer = guarded(serve, from_bytes<Request>(message));
        channel.send(to_bytes(answer));
      }
    });
  }

  /// The answer, or what happened instead.
  Answer<Reply> ask(const Request& request) {
    if (here_) return guarded(here_, request);
    if (!child_) return {{}, failure_};
    std::string message;
    const bool sent = child_->channel().send(to_bytes(request));
    const Channel::Wait wait =
        sent ? child_->channel().receive(message, limit_) : Channel::Wait::Closed;
    if (wait == Channel::Wait::Received) return from_bytes<Answer<Reply>>(message);
    failure_ = child_->end();
    if (wait == Channel::Wait::TooLate) {
      const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(limit_);
      failure_ =
          "no answer in " + std::to_string(seconds.count()) + " s: stopped (an endless loop?)";
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

}  // namespace cs550::viewer
