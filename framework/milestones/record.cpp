#include "record.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "cs550/assets.hpp"
#include "cs550/excerpt.hpp"

namespace cs550::milestones {
namespace {

/// "teapot: position x (m)": the name of one number of a quantity.
std::string column_name(const Quantity& quantity, std::size_t i) {
  static const char* const of_vector[] = {" x", " y", " z"};
  static const char* const of_orientation[] = {" qw", " qx", " qy", " qz"};
  std::string name = quantity.name;
  if (quantity.is_orientation()) return name + of_orientation[i];
  if (quantity.values.size() == 3) name += of_vector[i];
  return name + " (" + quantity.unit + ')';
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ';');) words.push_back(word);
  return words;
}

std::optional<double> to_number(const std::string& cell) {
  double number = 0;
  const char* const end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

std::string in_words(const std::vector<double>& values) {
  const std::string text = fmt::format("{:.5g}", fmt::join(values, ", "));
  return values.size() > 1 ? '(' + text + ')' : text;
}

/// The largest distance of all quantities, as a share of its tolerance.
struct Worst {
  double share = 0;
  std::string name;
};

std::string departure(const Quantity& mine, const std::vector<double>& recorded, double time) {
  const std::string unit = mine.is_orientation() ? "" : ' ' + mine.unit;
  return fmt::format(
      "differs from the record at t = {:.3g} s: {}\n"
      "expected {}{}, got {}{}\n"
      "difference {:.3g} {}, tolerance {:.3g} {}",
      time, mine.name, in_words(recorded), unit, in_words(mine.values), unit,
      distance(mine.values, recorded), mine.unit, mine.tolerance, mine.unit);
}

std::string agreement(const Worst& worst, double until) {
  std::string text = fmt::format("agrees with the record for all of its {:.2g} s", until);
  if (worst.name.empty()) return text;
  return fmt::format("{}\nlargest difference: {}, {} % of its tolerance", text, worst.name,
                     static_cast<int>(100 * worst.share));
}

}  // namespace

std::filesystem::path record_file(const Milestone& milestone) {
  return assets_folder() / "trajectories" / (milestone.name() + ".csv");
}

Record to_record(const Track& track) {
  Record record;
  record.columns = {"time (s)"};
  if (!track.observations.empty()) {
    for (const Quantity& quantity : track.observations.front()) {
      for (std::size_t i = 0; i < quantity.values.size(); ++i) {
        record.columns.push_back(column_name(quantity, i));
      }
    }
  }
  for (std::size_t row = 0; row < track.times.size(); ++row) {
    record.rows.push_back({track.times[row]});
    for (const Quantity& quantity : track.observations[row]) {
      record.rows.back().insert(record.rows.back().end(), quantity.values.begin(),
                                quantity.values.end());
    }
  }
  return record;
}

std::string to_csv(const Record& record) {
  std::string text = fmt::format("{}\n", fmt::join(record.columns, ";"));
  for (const std::vector<double>& row : record.rows) {
    text += fmt::format("{:.6g}\n", fmt::join(row, ";"));
  }
  return text;
}

Record read_record(const std::filesystem::path& file) {
  std::ifstream stream(file);
  Record record;
  std::string line;
  if (std::getline(stream, line)) record.columns = cells(line);
  while (std::getline(stream, line)) {
    std::vector<double> row;
    for (const std::string& cell : cells(line)) {
      const std::optional<double> number = to_number(cell);
      if (!number) {
        throw std::runtime_error(
            fmt::format("{}: line {}, cell {}: expected a number, found \"{}\"", file.string(),
                        record.rows.size() + 2, row.size() + 1, excerpt(cell)));
      }
      row.push_back(*number);
    }
    if (row.size() != record.columns.size()) break;
    record.rows.push_back(row);
  }
  if (record.rows.empty() || !stream.eof()) {
    throw std::runtime_error(
        file.string() +
        " is not a valid record: every row needs as many numbers as there are columns");
  }
  return record;
}

Comparison compare(const Track& track, const Record& record, double share) {
  if (!track.observations.empty() && to_record(track).columns != record.columns) {
    return {false, 0, "the record and the run have different columns. Record the reference again."};
  }
  Worst worst;
  double until = 0;
  const std::size_t common = std::min(track.times.size(), record.rows.size());
  for (std::size_t row = 0; row < common; ++row) {
    auto next = record.rows[row].begin() + 1;
    for (const Quantity& mine : track.observations[row]) {
      const auto size = static_cast<std::ptrdiff_t>(mine.values.size());
      const std::vector<double> recorded(next, next + size);
      next += size;
      const double used = distance(mine.values, recorded) / mine.tolerance;
      if (!(used <= share)) {  // so that NaN departs
        return {false, until, departure(mine, recorded, track.times[row])};
      }
      if (used > worst.share) worst = {used, mine.name};
    }
    until = track.times[row];
  }
  if (!track.problem.empty()) return {false, until, track.problem};
  if (track.times.size() != record.rows.size()) {
    return {false, until,
            "the record and the run have different lengths. Record the reference again."};
  }
  return {true, until, agreement(worst, until)};
}

}  // namespace cs550::milestones
