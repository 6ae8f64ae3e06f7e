#pragma once
/// @file base64.hpp
/// Bytes within text.

#include <string>
#include <string_view>

namespace cs550::gradebook {

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace cs550::gradebook
