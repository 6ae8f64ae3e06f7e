#include "progress_bar.hpp"

#include <unistd.h>

#include <iostream>
#include <string>

namespace cs550::cli {

void ProgressBar::show(int done) {
  const Clock::time_point now = Clock::now();
  if (now < next_ || isatty(STDERR_FILENO) == 0) return;
  next_ = now + std::chrono::milliseconds(100);
  visible_ = true;

  constexpr int width = 40;
  const int filled = static_cast<int>(static_cast<long>(done) * width / total_);
  std::cerr << "\r[" << std::string(static_cast<std::size_t>(filled), '#')
            << std::string(static_cast<std::size_t>(width - filled), ' ') << "] step " << done
            << " of " << total_ << std::flush;
}

ProgressBar::~ProgressBar() {
  if (visible_) std::cerr << '\r' << std::string(78, ' ') << '\r' << std::flush;
}

}  // namespace cs550::cli
