#include "gradebook/text/sha256.hpp"

#include <fmt/format.h>
#include <nettle/sha2.h>

#include <array>
#include <cstdint>

namespace cs550::gradebook {
namespace {

void add(sha256_ctx& context, std::string_view bytes) {
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

}  // namespace

std::string sha256_of(const std::vector<std::string_view>& texts) {
  sha256_ctx context;
  sha256_init(&context);
  for (const std::string_view text : texts) {
    add(context, std::to_string(text.size()) + ':');
    add(context, text);
  }
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string digits;
  for (const std::uint8_t byte : digest) digits += fmt::format("{:02x}", byte);
  return digits;
}

}  // namespace cs550::gradebook
