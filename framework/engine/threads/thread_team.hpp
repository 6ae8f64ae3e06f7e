#pragma once
/// @file thread_team.hpp
/// The threads that share the loops of a step.
///
/// A step has several short loops, so the worker threads start once per step, not once per loop, and
/// wait actively for the loops of the main thread, which runs the step. Nothing relies on their start:
/// the main thread processes the blocks that no worker has taken.

#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace cs550 {

inline constexpr int most_threads = 16;

/// Data that different threads write must not share a cache line.
inline constexpr std::size_t cache_line = 64;

/// A wait for another thread, which lets others run after many calls.
class ActiveWait {
 public:
  void pause();

 private:
  int pauses_ = 0;
};

class ThreadTeam {
 public:
  explicit ThreadTeam(int size) : size_(size) {}
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return size_; }

  /// Runs a step on the calling thread, the main thread of the team, with size() − 1 workers of oneTBB.
  void run(const std::function<void()>& step);

  /// Calls `work(first, last)` for consecutive blocks that make up the numbers from 0 to count − 1. Each
  /// thread begins with a share of its own, the same for loops of equal count, and then takes blocks of
  /// the others. If calls throw, the exception of the first block leaves this function once all are done.
  template <class Work>
  void for_blocks(std::size_t count, std::size_t block, const Work& work) {
    Loop loop;
    loop.call = [](const void* object, std::size_t first, std::size_t last) {
      (*static_cast<const Work*>(object))(first, last);
    };
    loop.work = &work;
    loop.block = block;
    run(loop, count);
  }

 private:
  struct alignas(cache_line) Share {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };

  struct Loop {
    void (*call)(const void* work, std::size_t first, std::size_t last) = nullptr;
    const void* work = nullptr;
    std::size_t block = 0;
    std::array<Share, most_threads> shares;
    std::mutex mutex;
    std::size_t failed_block = 0;
    std::exception_ptr failure;

    void call_block(std::size_t first, std::size_t last);
  };

  void run(Loop& loop, std::size_t count);
  void do_blocks(Loop& loop, int member) const;
  void run_worker(int member);

  int size_;
  alignas(cache_line) std::atomic<Loop*> loop_ = nullptr;
  std::atomic<bool> over_ = false;                   ///< the step has ended
  alignas(cache_line) std::atomic<int> inside_ = 0;  ///< workers that may read the loop
};

/// ThreadTeam::for_blocks(), or one call if there is no team or only one block.
template <class Work>
void for_blocks(ThreadTeam* team, std::size_t count, std::size_t block, const Work& work) {
  if (team != nullptr && count > block) {
    team->for_blocks(count, block, work);
  } else if (count > 0) {
    work(std::size_t(0), count);
  }
}

}  // namespace cs550
