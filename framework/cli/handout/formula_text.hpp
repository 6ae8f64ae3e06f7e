#pragma once
/// @file formula_text.hpp
/// The handouts' TeX formulas in plain characters, for a terminal.

#include <string>
#include <string_view>

namespace cs550::cli {

/// The text with every $formula$ written in plain characters: `$v_n^0 = \tfrac12 h\,\omega$`
/// becomes `v_n⁰ = ½ h ω`. It covers the part of TeX that the handouts use; an unknown command is
/// left unchanged.
std::string with_plain_formulas(std::string_view markdown);

}  // namespace cs550::cli
