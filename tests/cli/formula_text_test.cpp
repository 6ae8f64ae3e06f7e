/// Formulas of hints in a terminal.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "cli/handout/formula_text.hpp"

namespace {

namespace fs = std::filesystem;
using cs550::cli::with_plain_formulas;

TEST(FormulaText, WritesFormulasInPlainCharacters) {
  EXPECT_EQ(with_plain_formulas("take $v_n^0 = \\tfrac12 h\\,\\omega$, then go on"),
            "take v_n⁰ = ½ h ω, then go on");
  EXPECT_EQ(with_plain_formulas("$R\\,I^{-1}R^{T}$"), "R I⁻¹Rᵀ");
  EXPECT_EQ(with_plain_formulas("$a + \\dfrac{d_a}{d_a - d_b}(b - a)$"),
            "a + d_a/(d_a - d_b) (b - a)");
  EXPECT_EQ(with_plain_formulas("$\\lVert(b-a)\\times(c-b)\\rVert < 10^{-7}\\,\\ell^2$"),
            "‖(b-a) × (c-b)‖ < 10⁻⁷ ℓ²");
  EXPECT_EQ(with_plain_formulas("$d\\cdot (\\omega \\times r_A) = J_{\\omega A}V$"),
            "d·(ω × r_A) = J_ωA V");
  EXPECT_EQ(with_plain_formulas("$\\begin{pmatrix}a_u&-b\\\\b&c\\end{pmatrix}^{-1}$"),
            "(a_u -b; b c)⁻¹");
}

TEST(FormulaText, LeavesTheRestAlone) {
  EXPECT_EQ(with_plain_formulas("`a_b` costs 5 $ only"), "`a_b` costs 5 $ only");
  EXPECT_EQ(with_plain_formulas("$\\unheardof{x}$"), "\\unheardofx");
  EXPECT_EQ(with_plain_formulas("$\\frac$"), "/");
  EXPECT_EQ(with_plain_formulas("$a } b$"), "a } b");
  EXPECT_EQ(with_plain_formulas(""), "");
}

TEST(FormulaText, KnowsEveryCommandOfTheHints) {
  const fs::path labs = fs::path(CS550_TEST_DATA).parent_path().parent_path() / "labs";
  int handouts = 0;
  for (const fs::directory_entry& lab : fs::directory_iterator(labs)) {
    std::ifstream stream(lab.path() / "README.md");
    if (!stream) continue;
    ++handouts;
    const std::string source{std::istreambuf_iterator<char>(stream), {}};
    static const std::regex displayed("[$][$][^$]*[$][$]");  // hints contain none
    const std::string text = with_plain_formulas(std::regex_replace(source, displayed, ""));
    const std::size_t left = text.find('\\');
    EXPECT_EQ(left, std::string::npos)
        << lab.path().filename() << " shows \"" << text.substr(std::min(left, text.size()), 20)
        << "\": formula_text.cpp does not know that command";
  }
  EXPECT_GT(handouts, 0) << "no handout in " << labs;
}

}  // namespace
