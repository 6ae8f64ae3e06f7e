// The program behind ./cs550 bench: measures stages and scenes, prints a summary.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark_figures.hpp"
#include "benchmarks/engines/engine.hpp"
#include "benchmarks/report/print.hpp"
#include "benchmarks/runs/runs.hpp"
#include "benchmarks/stages/stage.hpp"
#include "benchmarks/verb/selection.hpp"
#include "cli/command_line.hpp"
#include "cli/system/exit_code.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "engine/threads/thread_team.hpp"
#include "files/interruption.hpp"
#include "files/output_file.hpp"

namespace {

using namespace cs550;
using namespace cs550::bench;

struct BenchOptions {
  std::string filter;
  std::filesystem::path json;
  int rounds = 1;
  int threads = 1;
  bool peers = false;
  bool plot = false;
  bool brief = false;
  bool list = false;
};

std::vector<Engine> engines_for(const BenchOptions& options) {
  std::vector<Engine> engines = own_engines();
  if (!options.peers) return engines;
  std::vector<Engine> peers = peer_engines();
  if (peers.empty()) {
    throw Misuse(
        "Bullet and ODE are not installed.\n  ./cs550 doctor --install peers installs them.");
  }
  engines.insert(engines.end(), peers.begin(), peers.end());
  return engines;
}

/// Opened before anything is measured, so that a wrong name costs no time.
std::unique_ptr<files::OutputFile> open_json(const BenchOptions& options) {
  if (options.json.empty()) return nullptr;
  try {
    return std::make_unique<files::OutputFile>(options.json);
  } catch (const std::runtime_error& error) {
    throw Misuse(fmt::format("{}\n  --json FILE needs a file that can be written.", error.what()));
  }
}

class Measurement {
 public:
  Measurement(const BenchOptions& options, Selection selection)
      : selection_(std::move(selection)),
        engines_(engines_for(options)),
        threads_(options.threads) {
    if (options.brief) duration_ = {5, 1};
    duration_.rounds = options.brief ? 1 : options.rounds;
    stage_seconds_ = options.brief ? 1e-4 : 0.2;
  }

  Report run() {
    Report report;
    report.date = today();
    report.processor = processor_model();
    report.steps = duration_.steps;
    report.rounds = duration_.rounds;
    measure_each_stage(report);
    const auto announce = [](const std::string& what) {
      files::throw_if_interrupted();
      cli::show_status(what);
    };
    for (const NamedScene& scene : selection_.scenes) {
      report.scenes.push_back(compare(scene, engines_, duration_, announce));
    }
    if (threads_ > 1) measure_threads(report, announce);
    for (const NamedScene& scene : selection_.frontiers) {
      report.frontiers.push_back(trace_frontier(scene, engines_, duration_, announce));
    }
    for (const ScaledScene& family : selection_.scaling) {
      report.scaling.push_back(measure_scaling(family, duration_, announce));
    }
    if (selection_.memory) report.memory = measure_memory();
    cli::show_status("");
    return report;
  }

 private:
  void measure_threads(Report& report, const Announce& announce) const {
    const auto measure = [&](const std::string& name, const BenchScene& scene,
                             const Duration& duration) {
      const auto gains = compare_threads(name, scene, threads_, duration, announce);
      report.thread_gains.insert(report.thread_gains.end(), gains.begin(), gains.end());
    };
    for (const NamedScene& scene : selection_.scenes) measure(scene.name, scene.make(), duration_);
    for (const ScaledScene& family : selection_.scaling) {
      for (const SizedScene& sized : make_scenes(family)) {
        measure(fmt::format("{} {}", sized.bodies, family.name), sized.scene,
                duration_of_scaling(duration_));
      }
    }
  }

  void measure_each_stage(Report& report) const {
    const int count = static_cast<int>(selection_.stages.size());
    cli::ProgressBar progress(count * duration_.rounds, "stage");
    for (int round = 0; round < duration_.rounds; ++round) {
      const auto finished = [&](int done) {
        files::throw_if_interrupted();
        progress.show(round * count + done);
      };
      const std::vector<StageCost> costs =
          measure_stages(selection_.stages, stage_seconds_, finished);
      if (round == 0) report.stages = costs;
      for (std::size_t i = 0; i < costs.size(); ++i) {
        report.stages[i].seconds = std::min(report.stages[i].seconds, costs[i].seconds);
      }
    }
  }

  Selection selection_;
  std::vector<Engine> engines_;
  int threads_;
  Duration duration_;
  double stage_seconds_ = 0;
};

void draw_pictures(const std::string& json) {
  const std::filesystem::path folder = cli::project_root() / "build/results/bench";
  std::cout << '\n';
  for (const book::Figure& figure : book::benchmark_figures(json)) {
    const std::filesystem::path file = folder / (figure.name + ".svg");
    files::write_file(file, drawing::write_svg(figure.draw()));
    std::cout << "Picture: " << std::filesystem::relative(file).string() << '\n';
  }
}

void measure(const BenchOptions& options, Selection selection) {
  Measurement measurement(options, std::move(selection));
  const std::unique_ptr<files::OutputFile> json_file = open_json(options);
  files::watch_for_interruption();
  const Report report = measurement.run();
  print(report, std::cout);
  const std::string json = to_json(report);
  if (json_file) {
    json_file->write(json);
    json_file->commit();
  }
  if (options.plot) draw_pictures(json);
}

int run_bench(const BenchOptions& options) {
  try {
    Selection selection = select(options.filter, options.plot);
    if (options.threads > 1 && selection.scenes.empty() && selection.scaling.empty()) {
      throw Misuse(
          "--threads measures scene/... and step/..., and --filter selects none.\n"
          "  For example: ./cs550 bench --threads 2 --filter scene");
    }
    if (options.list) {
      for (const std::string& name : selection.names()) std::cout << name << '\n';
    } else {
      measure(options, std::move(selection));
    }
    return cli::Good;
  } catch (const Misuse& error) {
    std::cerr << "cs550: " << error.what() << '\n';
    return cli::Misused;
  }
}

void declare(CLI::App& app, BenchOptions& options) {
  app.add_flag("--peers", options.peers, "run the scenes in Bullet and ODE too");
  app.add_option("--filter", options.filter,
                 "only benchmarks whose name matches a regular expression")
      ->option_text("RE");
  app.add_flag("--list", options.list, "print the names of the benchmarks; measure nothing");
  app.add_option("--json", options.json, "write all figures to a file")->option_text("FILE");
  app.add_flag("--plot", options.plot, "measure error against time too; save pictures");
  app.add_option("--rounds", options.rounds,
                 "measure N times; keep the smallest times\n(--threads: the medians)")
      ->option_text("N")
      ->check(CLI::Range(1, 100));
  app.add_option("--threads", options.threads,
                 "run scene/... and every size of step/... with\nN threads too; print how much "
                 "faster they are")
      ->option_text("N")
      ->check(CLI::Range(2, most_threads));
  app.add_flag("--brief", options.brief, "five steps of each scene, to see that everything runs");
}

}  // namespace

int main(int argc, char** argv) {
  BenchOptions options;
  CLI::App app("Measure each stage of a step alone, and whole scenes beside other engines",
               "./cs550 bench");
  declare(app, options);
  return cli::run_verb(app, "bench", argc, argv, [&] { return run_bench(options); });
}
