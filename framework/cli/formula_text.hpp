#pragma once
/// @file formula_text.hpp
/// The handouts' formulas where nothing can set them: in a terminal.

#include <string>
#include <string_view>

namespace cs550::cli {

/// The text with every $formula$ written in plain characters: `$v_n^0 = \tfrac12 h\,\omega$`
/// becomes `v_n⁰ = ½ h ω`. Knows the part of TeX that the handouts use; a command that it does not
/// know stays as it was typed.
std::string with_plain_formulas(std::string_view markdown);

}  // namespace cs550::cli
