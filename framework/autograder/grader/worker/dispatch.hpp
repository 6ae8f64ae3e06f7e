#pragma once
/// @file dispatch.hpp
/// The functions that a worker can be asked to call, by name.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "serialisation/named_content.hpp"

namespace cs550::grader {

/// Reads the arguments, calls the function at an address, and returns what it answered as bytes.
using Server = std::function<std::string(void* address, serialisation::ByteReader& arguments)>;

struct Function {
  const char* symbol;              ///< mangled; null for given code, whose server knows its address
  std::vector<std::string> calls;  ///< lab functions that given code calls
  Server serve;
};

/// Every function of every lab, and the given loops around them, by name.
const std::map<std::string, Function>& functions();

}  // namespace cs550::grader
