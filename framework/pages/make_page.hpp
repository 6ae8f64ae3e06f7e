#pragma once
/// @file make_page.hpp
/// All pages by number.

#include <memory>
#include <string>

#include "pages/base/page.hpp"

namespace cs550::pages {

/// Which page, and where its code runs.
struct PageChoice {
  int lab = 0;                            ///< 0: the world
  std::string scene = "wall";             ///< of the world
  Isolation isolation = Isolation::Here;  ///< Child for a student's code
};

/// Makes a page; it is empty until its first refresh().
std::unique_ptr<Page> make_page(const PageChoice& choice);

}  // namespace cs550::pages
