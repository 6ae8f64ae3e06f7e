#include "gradebook/marks/time_text.hpp"

#include <fmt/chrono.h>

#include <cstdlib>
#include <regex>

namespace cs550::gradebook {

std::optional<Time> parse_time(const std::string& text) {
  using namespace std::chrono;
  static const std::regex iso(
      R"((\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d)(?::(\d\d)(?:\.\d+)?)?(?:Z|([+-])(\d\d):(\d\d)))");
  std::smatch part;
  if (!std::regex_match(text, part, iso)) return std::nullopt;
  const auto number = [&part](std::size_t i) { return part[i].matched ? std::stoi(part[i]) : 0; };
  const year_month_day date{year(number(1)), month(static_cast<unsigned>(number(2))),
                            day(static_cast<unsigned>(number(3)))};
  if (!date.ok() || number(4) > 23 || number(5) > 59 || number(6) > 60) return std::nullopt;
  const minutes offset = hours(number(8)) + minutes(number(9));
  return sys_days(date) + hours(number(4)) + minutes(number(5)) + seconds(number(6)) -
         (part[7] == "-" ? -offset : offset);
}

std::string to_text(Time time, std::chrono::minutes offset) {
  const std::string local = fmt::format(
      "{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(std::chrono::system_clock::to_time_t(time + offset)));
  if (offset.count() == 0) return local + 'Z';
  const auto minutes = std::abs(offset.count());
  return fmt::format("{}{}{:02}:{:02}", local, offset.count() < 0 ? '-' : '+', minutes / 60,
                     minutes % 60);
}

}  // namespace cs550::gradebook
