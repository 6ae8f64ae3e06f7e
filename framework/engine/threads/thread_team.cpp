#include "engine/threads/thread_team.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#if CS550_HAS_TBB
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

namespace cs550 {

/// The pause instruction of x86 would be kinder to a thread on the same core. But with it the next loop begins
/// 0.7 µs later on a virtual machine.
void ActiveWait::pause() {
  constexpr int patience = 20'000;
  if (pauses_ == patience) return std::this_thread::yield();
  ++pauses_;
}

/// Whoever reads a new value of one member then finds that the number is not the former one.
void ThreadTeam::Notice::publish(const Loop& loop) {
  number_.store(0, std::memory_order_relaxed);
  call_.store(loop.call, std::memory_order_release);
  work_.store(loop.work, std::memory_order_release);
  count_.store(loop.count, std::memory_order_release);
  block_.store(loop.block, std::memory_order_release);
  number_.store(loop.number, std::memory_order_release);
}

bool ThreadTeam::Notice::read(std::uint32_t number, Loop& loop) const {
  loop = {number, call_.load(std::memory_order_acquire), work_.load(std::memory_order_acquire),
          count_.load(std::memory_order_acquire), block_.load(std::memory_order_acquire)};
  return number_.load(std::memory_order_relaxed) == number;
}

bool ThreadTeam::Share::take(std::uint32_t loop, std::uint32_t count, std::uint32_t& block) {
  constexpr int half = 32;
  std::uint64_t taken = taken_.load(std::memory_order_relaxed);
  std::uint64_t next = 0;
  do {
    const auto last_loop = static_cast<std::uint32_t>(taken >> half);
    block = last_loop == loop ? static_cast<std::uint32_t>(taken) : 0;
    if (last_loop > loop || block >= count) return false;
    next = static_cast<std::uint64_t>(loop) << half | (block + 1);
  } while (!taken_.compare_exchange_weak(taken, next, std::memory_order_relaxed));
  return true;
}

ThreadTeam::Range ThreadTeam::share_of(const Loop& loop, int member) const {
  const auto size = static_cast<std::size_t>(size_);
  const auto i = static_cast<std::size_t>(member);
  // Rounded up, so that the main thread has a block of each loop.
  const std::size_t first = (loop.count * i + size - 1) / size;
  const std::size_t last = (loop.count * (i + 1) + size - 1) / size;
  return {first, last, static_cast<std::uint32_t>((last - first + loop.block - 1) / loop.block)};
}

void ThreadTeam::call_block(const Loop& loop, std::size_t first, std::size_t last) {
  try {
    loop.call(loop.work, first, last);
  } catch (...) {
    const std::lock_guard lock(failure_.mutex);
    if (failure_.exception && failure_.block < first) return;
    failure_.block = first;
    failure_.exception = std::current_exception();
  }
}

void ThreadTeam::do_share(const Loop& loop, int member) {
  const Range range = share_of(loop, member);
  Share& share = shares_[static_cast<std::size_t>(member)];
  std::uint32_t block = 0;
  std::uint32_t done = 0;
  for (; share.take(loop.number, range.blocks, block); ++done) {
    const std::size_t first = range.first + block * loop.block;
    call_block(loop, first, std::min(first + loop.block, range.last));
  }
  if (done > 0) share.finish(done);
}

void ThreadTeam::run(const Loop& loop) {
  notice_.publish(loop);
  for (int member = 0; member < size_; ++member) do_share(loop, member);
  for (int member = 0; member < size_; ++member) {
    const auto i = static_cast<std::size_t>(member);
    begun_[i] += share_of(loop, member).blocks;
    ActiveWait wait;
    while (shares_[i].finished() != begun_[i]) wait.pause();
  }
  if (failure_.exception) std::rethrow_exception(std::exchange(failure_.exception, nullptr));
}

/// A worker leaves the only block of another thread to that thread, which has begun with it. To look at its share
/// would take the cache line from it.
void ThreadTeam::run_worker(int member) {
  std::uint32_t last_loop = 0;
  ActiveWait wait;
  while (!notice_.step_has_ended()) {
    const std::uint32_t number = notice_.number();
    Loop loop;
    if (number == last_loop || number == 0 || !notice_.read(number, loop)) {
      wait.pause();
      continue;
    }
    last_loop = number;
    do_share(loop, member);
    for (int i = 1; i < size_; ++i) {
      const int other = (member + i) % size_;
      if (share_of(loop, other).blocks > 1) do_share(loop, other);
    }
    wait = {};
  }
}

#if CS550_HAS_TBB

int useful_threads(int wanted) { return std::min(wanted, tbb::this_task_arena::max_concurrency()); }

/// A program may call a step in a task of its own. While the step waits, it must not run the program's other tasks.
void ThreadTeam::run(const std::function<void()>& step) {
  tbb::this_task_arena::isolate([&] { run_isolated(step); });
}

void ThreadTeam::run_isolated(const std::function<void()>& step) {
  // Workers round as this thread does now.
  tbb::task_group_context context(
      tbb::task_group_context::isolated,
      tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  tbb::task_group workers(context);
  struct EndOfStep {
    ~EndOfStep() {
      team.notice_.end_step();
      workers.wait();  // workers that start only now return at once
    }
    ThreadTeam& team;
    tbb::task_group& workers;
  };
  const EndOfStep at_the_end{*this, workers};
  for (int member = 1; member < size_; ++member) {
    workers.run([this, member] { run_worker(member); });
  }
  step();
}

#else

int useful_threads(int) { return 1; }
void ThreadTeam::run(const std::function<void()>& step) { step(); }

#endif

}  // namespace cs550
