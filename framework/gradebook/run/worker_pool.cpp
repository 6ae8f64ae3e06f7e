#include "gradebook/run/worker_pool.hpp"

#include <chrono>
#include <utility>

namespace cs550::gradebook {

WorkerPool::WorkerPool(int threads, std::size_t items, std::function<void(std::size_t)> work,
                       const std::atomic<bool>& stop)
    : work_(std::move(work)), stop_(stop), items_(items), running_(threads) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

WorkerPool::~WorkerPool() { failed_ = true; }

void WorkerPool::run() {
  while (!stop_ && !failed_) {
    const std::size_t item = next_++;
    if (item >= items_) break;
    std::exception_ptr failure;
    try {
      work_(item);
    } catch (...) {
      failure = std::current_exception();
      failed_ = true;
    }
    const std::lock_guard lock(mutex_);
    if (failure) {
      failure_ = failure;
    } else if (!stop_) {
      finished_.push_back(item);
    }
    changed_.notify_one();
  }
  const std::lock_guard lock(mutex_);
  --running_;
  changed_.notify_one();
}

bool WorkerPool::is_busy() {
  const std::lock_guard lock(mutex_);
  return running_ > 0 || !finished_.empty() || failure_;
}

std::vector<std::size_t> WorkerPool::wait_for_finished() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::milliseconds(100),
                    [this] { return !finished_.empty() || failure_ || running_ == 0; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return std::exchange(finished_, {});
}

}  // namespace cs550::gradebook
