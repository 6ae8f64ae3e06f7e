#pragma once
/// @file promise.hpp
/// What a reader promises about every input, as a crash that libFuzzer records.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "cs550/excerpt.hpp"

namespace cs550::fuzz {

/// Ends the process unless the promise was kept.
inline void promise(bool kept, const char* sentence, const std::string& detail = "") {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n%s\n", sentence, detail.c_str());
  std::abort();
}

/// No terminal obeys a message: it has no control characters but line breaks.
inline bool is_printable(const std::string& message) {
  for (std::size_t i = 0; i < message.size(); ++i) {
    if (message[i] != '\n' && control_length(std::string_view(message).substr(i)) > 0) return false;
  }
  return true;
}

}  // namespace cs550::fuzz
