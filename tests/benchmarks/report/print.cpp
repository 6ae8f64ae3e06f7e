#include "benchmarks/report/print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>

#include "cli/system/terminal.hpp"

namespace cs550::bench {
namespace {

std::string heading(const std::string& text) {
  return '\n' + cli::coloured(text, cli::Colour::Bold) + '\n';
}

/// Three digits and a unit.
std::string time_text(double seconds) {
  constexpr std::array<std::pair<double, const char*>, 3> units{
      {{1e-3, "ms"}, {1e-6, "µs"}, {1e-9, "ns"}}};
  for (const auto& [size, unit] : units) {
    if (seconds >= size) return fmt::format("{:#.3g} {}", seconds / size, unit);
  }
  return fmt::format("{:#.3g} ns", seconds * 1e9);
}

void print_stages(const std::vector<StageCost>& stages, std::ostream& out) {
  if (stages.empty()) return;
  out << heading("Stages alone, per query, body or constraint");
  for (const StageCost& stage : stages)
    out << fmt::format("  {:<32}{:>10}\n", stage.name, time_text(stage.seconds));
}

void print_scaling(const std::vector<Scaling>& scaling, std::ostream& out) {
  if (scaling.empty()) return;
  out << heading("A step against the number of bodies");
  for (const Scaling& family : scaling) {
    for (const Cost& cost : family.costs) {
      out << fmt::format("  {:<32}{:>10}  {} a body\n",
                         fmt::format("{:.0f} {}", cost.n, family.name), time_text(cost.seconds),
                         time_text(cost.seconds / cost.n));
    }
  }
}

void print_exponents(const std::vector<FittedFamily>& families, std::ostream& out) {
  if (families.empty()) return;
  out << heading("Cost against n, fitted: time ~ n^p");
  for (const FittedFamily& family : families) {
    out << fmt::format("  {:<32}p = {:<8.2f}n = {:.0f} to {:.0f}\n", family.name,
                       family.law.exponent, family.smallest, family.largest);
  }
}

void print_runs(const std::vector<SceneRun>& runs, std::ostream& out) {
  if (runs.empty()) return;
  const double fastest =
      std::min_element(runs.begin(), runs.end(), [](const SceneRun& a, const SceneRun& b) {
        return a.seconds < b.seconds;
      })->seconds;
  out << "  engine                   ms/step ratio  depth mm >2 cm  energy J drift mm lost\n";
  for (const SceneRun& run : runs) {
    const Quality& quality = run.quality;
    out << fmt::format(
        "  {:<25}{:>7.3f} {:>5.2f} {:>9.1f} {:>5} {:>9.2g} {:>8} {:>4}\n",
        fmt::format("{}, {}", run.engine, run.effort), 1e3 * run.seconds, run.seconds / fastest,
        1e3 * quality.deepest, quality.deep_pairs, quality.kinetic_energy,
        quality.drift ? fmt::format("{:.1f}", 1e3 * *quality.drift) : "-", quality.lost_bodies);
  }
}

void print_thread_gains(const std::vector<ThreadGain>& gains, std::ostream& out) {
  if (gains.empty()) return;
  out << heading(
             fmt::format("One thread and {}, time by the clock, medians", gains.front().threads))
      << "At most: as many copies of the scene at once, which share nothing.\n"
      << "                                                  ms/step  shared   gain at most\n";
  for (const ThreadGain& gain : gains) {
    out << fmt::format("  {:<24} {:<22}{:>8.3f} {:>7.3f} {:>6.2f} {:>7.2f}\n", gain.scene,
                       gain.engine, 1e3 * gain.seconds_alone, 1e3 * gain.seconds_shared,
                       gain.gain(), gain.largest_gain());
  }
}

void print_memory(const Memory& memory, std::ostream& out) {
  out << heading("Memory of a world")
      << fmt::format("  {:<32}{:>7.0f} bytes\n", "a body", memory.bytes_per_body)
      << fmt::format("  {:<32}{:>7.0f} bytes\n", "a contact of two cubes", memory.bytes_per_contact)
      << fmt::format("  {:<32}{:>7}\n", "allocations in a steady step",
                     memory.allocations_per_step);
}

}  // namespace

void print(const Report& report, std::ostream& out) {
  out << fmt::format("{}, {}. Processor time, smallest of {} rounds.\n", report.processor,
                     report.date, report.rounds);
  print_stages(report.stages, out);
  for (const SceneComparison& scene : report.scenes) {
    out << heading(fmt::format("{}: {}", scene.scene, scene.title));
    print_runs(scene.runs, out);
  }
  print_thread_gains(report.thread_gains, out);
  for (const Frontier& frontier : report.frontiers) {
    out << heading(fmt::format("{}: error against time as the effort varies", frontier.scene));
    print_runs(frontier.runs, out);
  }
  print_scaling(report.scaling, out);
  print_exponents(fitted_families(report), out);
  if (report.memory) print_memory(*report.memory, out);
}

}  // namespace cs550::bench
