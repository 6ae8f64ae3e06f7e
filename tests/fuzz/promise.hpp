#pragma once
/// @file promise.hpp
/// What a reader promises about every input, as a crash that libFuzzer records.

#include <cstdio>
#include <cstdlib>
#include <string>

namespace cs550::fuzz {

/// Ends the process unless the promise was kept.
inline void promise(bool kept, const char* sentence, const std::string& detail = "") {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n%s\n", sentence, detail.c_str());
  std::abort();
}

/// No terminal obeys a message: it has no control characters but line breaks.
inline bool is_printable(const std::string& message) {
  for (const char letter : message) {
    const auto code = static_cast<unsigned char>(letter);
    if ((code < 0x20 && letter != '\n') || code == 0x7f) return false;
  }
  return true;
}

}  // namespace cs550::fuzz
