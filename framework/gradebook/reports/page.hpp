#pragma once
/// @file page.hpp
/// Pieces of HTML pages that need no other file and no network.

#include <string>
#include <string_view>
#include <vector>

namespace cs550::gradebook {

/// A whole page, readable in light and dark and from a phone's width on.
/// @param title text
/// @param body HTML
std::string page(std::string_view title, std::string_view body);

/// A table that scrolls sideways by itself where the screen is too narrow.
/// @param headings text
/// @param rows HTML
std::string table(const std::vector<std::string>& headings, std::string_view rows);

/// A part that opens with a click.
/// @param summary text
/// @param content HTML
std::string details(std::string_view summary, std::string_view content);

/// A bar chart as SVG.
/// @param labels below every bar
/// @param what the chart shows, for screen readers
std::string bar_chart(const std::vector<int>& values, const std::vector<std::string>& labels,
                      std::string_view what);

}  // namespace cs550::gradebook
