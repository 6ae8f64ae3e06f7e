#include "engine/threads/thread_team.hpp"

#include <algorithm>
#include <thread>

#if CS550_HAS_TBB
#include <tbb/task_group.h>
#endif

namespace cs550 {

/// The pause instruction of x86 would be kinder to a thread on the same core. But with it the next loop begins
/// 0.7 µs later on a virtual machine.
void ActiveWait::pause() {
  constexpr int patience = 20'000;
  if (++pauses_ > patience) std::this_thread::yield();
}

void ThreadTeam::Loop::call_block(std::size_t first, std::size_t last) {
  try {
    call(work, first, last);
  } catch (...) {
    const std::lock_guard lock(mutex);
    if (failure && failed_block < first) return;
    failed_block = first;
    failure = std::current_exception();
  }
}

void ThreadTeam::do_blocks(Loop& loop, int member) const {
  for (int i = 0; i < size_; ++i) {
    Share& share = loop.shares[static_cast<std::size_t>((member + i) % size_)];
    while (share.next.load(std::memory_order_relaxed) < share.end) {
      const std::size_t first = share.next.fetch_add(loop.block, std::memory_order_relaxed);
      if (first < share.end) loop.call_block(first, std::min(first + loop.block, share.end));
    }
  }
}

void ThreadTeam::run(Loop& loop, std::size_t count) {
  const auto size = static_cast<std::size_t>(size_);
  for (std::size_t i = 0; i < size; ++i) {
    loop.shares[i].next.store(count * i / size, std::memory_order_relaxed);
    loop.shares[i].end = count * (i + 1) / size;
  }
  loop_.store(&loop);
  do_blocks(loop, 0);
  // A worker counts itself before it reads the loop, so a worker that is not counted now finds none.
  loop_.store(nullptr);
  ActiveWait wait;
  while (inside_.load() > 0) wait.pause();
  if (loop.failure) std::rethrow_exception(loop.failure);
}

void ThreadTeam::run_worker(int member) {
  ActiveWait wait;
  while (!over_.load(std::memory_order_acquire)) {
    if (loop_.load(std::memory_order_relaxed) == nullptr) {
      wait.pause();
      continue;
    }
    ++inside_;
    Loop* const loop = loop_.load();
    if (loop != nullptr) do_blocks(*loop, member);
    --inside_;
    wait = {};
  }
}

#if CS550_HAS_TBB

void ThreadTeam::run(const std::function<void()>& step) {
  tbb::task_group workers;
  struct EndOfStep {
    ~EndOfStep() {
      team.over_.store(true, std::memory_order_release);
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

void ThreadTeam::run(const std::function<void()>& step) { step(); }

#endif

}  // namespace cs550
