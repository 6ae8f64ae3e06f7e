#include "engine/threads/crew.hpp"

#include <algorithm>
#include <thread>

#if CS550_HAS_TBB
#include <tbb/task_group.h>
#endif

namespace cs550 {

void ActiveWait::pause() {
  constexpr int patience = 4000;
  if (++pauses_ > patience) {
    std::this_thread::yield();
    return;
  }
#if defined(__x86_64__) && defined(__GNUC__)
  __builtin_ia32_pause();
#endif
}

void Crew::Loop::call_block(std::size_t first, std::size_t last) {
  try {
    call(work, first, last);
  } catch (...) {
    const std::lock_guard lock(mutex);
    if (failure && failed_block < first) return;
    failed_block = first;
    failure = std::current_exception();
  }
}

void Crew::do_blocks(Loop& loop, int member) const {
  for (int i = 0; i < size_; ++i) {
    Share& share = loop.shares[static_cast<std::size_t>((member + i) % size_)];
    while (share.next.load(std::memory_order_relaxed) < share.end) {
      const std::size_t first = share.next.fetch_add(loop.block, std::memory_order_relaxed);
      if (first < share.end) loop.call_block(first, std::min(first + loop.block, share.end));
    }
  }
}

void Crew::run(Loop& loop, std::size_t count) {
  const auto size = static_cast<std::size_t>(size_);
  for (std::size_t i = 0; i < size; ++i) {
    loop.shares[i].next.store(count * i / size, std::memory_order_relaxed);
    loop.shares[i].end = count * (i + 1) / size;
  }
  loop_.store(&loop);
  do_blocks(loop, 0);
  // A helper counts itself before it looks at the loop, so who is not counted now sees none.
  loop_.store(nullptr);
  ActiveWait wait;
  while (inside_.load() > 0) wait.pause();
  if (loop.failure) std::rethrow_exception(loop.failure);
}

void Crew::help(int member) {
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

void Crew::run(const std::function<void()>& step) {
  tbb::task_group helpers;
  struct Dismissal {
    ~Dismissal() {
      crew.over_.store(true, std::memory_order_release);
      helpers.wait();  // helpers that have not come yet leave at once
    }
    Crew& crew;
    tbb::task_group& helpers;
  };
  const Dismissal at_the_end{*this, helpers};
  for (int member = 1; member < size_; ++member) {
    helpers.run([this, member] { help(member); });
  }
  step();
}

#else

void Crew::run(const std::function<void()>& step) { step(); }

#endif

}  // namespace cs550
