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
#include <cstdint>
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

/// How many of the wanted threads the machine can run at once: at least one.
int useful_threads(int wanted);

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
    const Call call = [](const void* object, std::size_t first, std::size_t last) {
      (*static_cast<const Work*>(object))(first, last);
    };
    run({++loops_, call, &work, count, block});
  }

 private:
  using Call = void (*)(const void* work, std::size_t first, std::size_t last);

  struct Loop {
    std::uint32_t number = 0;  ///< from 1
    Call call = nullptr;
    const void* work = nullptr;
    std::size_t count = 0;
    std::size_t block = 0;
  };

  /// The present loop. The main thread writes it, and a worker fetches one cache line to read it.
  class alignas(cache_line) Notice {
   public:
    void publish(const Loop& loop);
    void end_step() { over_.store(true, std::memory_order_release); }

    bool step_has_ended() const { return over_.load(std::memory_order_relaxed); }
    /// Of the present loop, or 0.
    std::uint32_t number() const { return number_.load(std::memory_order_acquire); }
    /// @returns false if that loop is no longer the present one
    bool read(std::uint32_t number, Loop& loop) const;

   private:
    std::atomic<bool> over_ = false;
    std::atomic<std::uint32_t> number_ = 0;  ///< 0 while the following change
    std::atomic<Call> call_ = nullptr;
    std::atomic<const void*> work_ = nullptr;
    std::atomic<std::size_t> count_ = 0;
    std::atomic<std::size_t> block_ = 0;
  };

  /// The blocks with which a thread begins each loop.
  class alignas(cache_line) Share {
   public:
    /// Takes the next block of the share.
    /// @param count of its blocks in this loop
    /// @returns false if all are taken. Those of a loop that is over are.
    bool take(std::uint32_t loop, std::uint32_t count, std::uint32_t& block);
    void finish(std::uint32_t blocks) { finished_.fetch_add(blocks, std::memory_order_release); }
    /// Blocks of all loops.
    std::uint32_t finished() const { return finished_.load(std::memory_order_acquire); }

   private:
    std::atomic<std::uint64_t> taken_ =
        0;  ///< number of a loop, and how many of its blocks are taken
    std::atomic<std::uint32_t> finished_ = 0;
  };

  /// The numbers of a share, and how many blocks they are.
  struct Range {
    std::size_t first = 0;
    std::size_t last = 0;
    std::uint32_t blocks = 0;
  };

  struct Failure {
    std::mutex mutex;
    std::size_t block = 0;
    std::exception_ptr exception;
  };

  void run_isolated(const std::function<void()>& step);
  void run(const Loop& loop);
  void run_worker(int member);
  Range share_of(const Loop& loop, int member) const;
  void do_share(const Loop& loop, int member);
  void call_block(const Loop& loop, std::size_t first, std::size_t last);

  int size_;
  Failure failure_;
  Notice notice_;
  std::array<Share, most_threads> shares_;
  // Of the main thread alone:
  alignas(cache_line) std::uint32_t loops_ = 0;
  std::array<std::uint32_t, most_threads> begun_{};  ///< blocks of each share, in all loops
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
