#include "helpers/random.hpp"

#include <cstdlib>

namespace cs550::test {

std::uint32_t seed_salt() {
  static const std::uint32_t salt = [] {
    const char* text = std::getenv("CS550_SEED_SALT");
    return text == nullptr ? 0U : static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10));
  }();
  return salt;
}

}  // namespace cs550::test
