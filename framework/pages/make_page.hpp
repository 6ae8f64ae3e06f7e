#pragma once
/// @file make_page.hpp
/// All pages by number.

#include <filesystem>
#include <memory>
#include <string>

#include "pages/base/page.hpp"

namespace cs550::pages {

/// Which page, and where its code runs.
struct PageChoice {
  int lab = 0;                            ///< 0: the world; or failure_page
  std::string scene = "wall";             ///< of the world
  Isolation isolation = Isolation::Here;  ///< Child for a student's code
  std::filesystem::path picture;          ///< of the failing test (failure_page.hpp)
};

/// Makes a page; it is empty until its first refresh().
std::unique_ptr<Page> make_page(const PageChoice& choice);

/// Why the scene of a choice cannot be read; empty if it can. A student's code makes its shapes: what that code cannot do
/// yet is no fault of the scene.
std::string fault_of_scene(const PageChoice& choice);

}  // namespace cs550::pages
