#include "gradebook/reports/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --text: #1b2429; --faint: #5b6870; --back: #fff; --raised: #f2f5f7;
  --line: #d5dde2; --accent: #1f6f8b; --good: #1d7a3e; --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --text: #e4e9ec; --faint: #9db0ba; --back: #14191c;
  --raised: #1e262b; --line: #37444c; --accent: #6bb8d4; --good: #6fcf8e; --bad: #ff8a80; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.2rem 1rem 3rem; max-width: 72rem; color: var(--text);
  background: var(--back); font: 16px/1.5 system-ui, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: .4rem 0 .6rem; }
h2 { font-size: 1.25rem; margin: 2rem 0 .6rem; border-bottom: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 0 0 .3rem; }
a { color: var(--accent); }
small, footer, .faint { color: var(--faint); }
footer { margin-top: 2.5rem; font-size: .85rem; }
.table { overflow-x: auto; }
table { border-collapse: collapse; min-width: 100%; font-size: .94rem; }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid var(--line); vertical-align: top;
  overflow-wrap: normal; }
td:not(.number) { overflow-wrap: anywhere; }
th { color: var(--faint); font-weight: 600; }
.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.good { color: var(--good); }
.bad { color: var(--bad); }
pre { margin: .2rem 0; padding: .6rem; background: var(--raised); border-radius: 6px; overflow-x: auto;
  font-size: .85rem; white-space: pre-wrap; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 20rem), 1fr)); gap: 1rem; }
.card { background: var(--raised); border-radius: 8px; padding: .8rem; }
.card p { margin: .2rem 0; }
svg { display: block; width: 100%; height: auto; }
img { display: block; max-width: 100%; background: #fff; border-radius: 6px; }
svg rect { fill: var(--accent); }
svg text { fill: var(--faint); font: 11px system-ui, sans-serif; text-anchor: middle; }
details { margin: .5rem 0; }
summary { cursor: pointer; }
)";

}  // namespace

std::string page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; img-src data:\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      html(title), style, body);
}

std::string table(const std::vector<std::string>& headings, std::string_view rows) {
  std::string head;
  for (const std::string& heading : headings) head += "<th>" + html(heading) + "</th>";
  return fmt::format(
      "<div class=\"table\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n"
      "</table></div>\n",
      head, rows);
}

std::string details(std::string_view summary, std::string_view content) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", html(summary), content);
}

std::string bar_chart(const std::vector<int>& values, const std::vector<std::string>& labels,
                      std::string_view what) {
  constexpr double width = 320;
  constexpr double height = 120;
  constexpr double text_height = 16;
  const int most = std::max(1, *std::max_element(values.begin(), values.end()));
  const double step = width / static_cast<double>(values.size());
  std::string bars;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double bar = (height - 2 * text_height) * values[i] / most;
    const double middle = (static_cast<double>(i) + 0.5) * step;
    const double top = height - text_height - bar;
    bars += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                        middle - 0.4 * step, top, 0.8 * step, bar);
    if (values[i] > 0) {
      bars += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", middle, top - 3, values[i]);
    }
    bars += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", middle, height - 3,
                        html(labels[i]));
  }
  return fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>\n", width,
                     height, html(what), bars);
}

}  // namespace cs550::gradebook
