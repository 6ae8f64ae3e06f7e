#pragma once
/// @file worker_pool.hpp
/// Threads that work through a list in its order.

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cs550::gradebook {

class WorkerPool {
 public:
  /// Starts at once.
  /// @param items calls of `work`, with 0, 1, ...
  /// @param stop no further call begins once it is true
  WorkerPool(int threads, std::size_t items, std::function<void(std::size_t)> work,
             const std::atomic<bool>& stop);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Whether a thread still runs or a finished item was not yet fetched.
  bool is_busy();

  /// Waits for at most a tenth of a second. @return the items that finished since the last call
  /// Throws what a call of `work` threw; no further call begins then.
  std::vector<std::size_t> wait_for_finished();

 private:
  void run();

  std::function<void(std::size_t)> work_;
  const std::atomic<bool>& stop_;
  std::size_t items_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;  ///< guards all below
  std::condition_variable changed_;
  std::vector<std::size_t> finished_;
  std::exception_ptr failure_;
  int running_;
  std::vector<std::jthread> threads_;
};

}  // namespace cs550::gradebook
