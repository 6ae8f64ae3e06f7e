#pragma once
/// @file dispatch.hpp
/// The lab functions that a worker can be asked to call, by name.

#include <functional>
#include <map>
#include <string>

#include "serialisation/shape_archive.hpp"

namespace cs550::grader {

/// Reads the arguments, calls the function at an address, and returns what it answered as bytes.
using Server = std::function<std::string(void* address, serialisation::ByteReader& arguments)>;

struct LabFunction {
  const char* symbol;  ///< mangled
  Server serve;
};

/// Every function of every lab, by its name.
const std::map<std::string, LabFunction>& lab_functions();

}  // namespace cs550::grader
