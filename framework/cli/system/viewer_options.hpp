#pragma once
/// @file viewer_options.hpp
/// The viewer's options, known before it is built.

#include <vector>

#include "files/usage_fault.hpp"

namespace cs550::cli {

/// As the viewer's --help lists them. Those that take no value name none.
inline const std::vector<files::Argument> viewer_options{
    {"-h", "", ""},
    {"--help", "", ""},
    {"--lab", "N", ""},
    {"--failure", "TEST", ""},
    {"--student", "", ""},
    {"--steps", "N", ""},
    {"--set", "NAME=VALUE", ""},
    {"--list", "", ""},
    {"--camera", "NUMBERS", ""},
    {"--size", "WIDTHxHEIGHT", ""},
    {"--ui", "on|off", ""},
    {"--snapshot", "FILE", ""},
    {"--frames", "FOLDER", ""},
    {"--gif", "FILE", ""},
    {"--frame-count", "N", ""},
};

}  // namespace cs550::cli
