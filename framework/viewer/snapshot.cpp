#include "viewer/snapshot.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "files/indented.hpp"
#include "files/interruption.hpp"
#include "viewer/animation.hpp"
#include "viewer/app.hpp"
#include "viewer/gl/headless_context.hpp"

namespace cs550::viewer {

namespace fs = std::filesystem;

namespace {

/// Dear ImGui needs a few frames to determine the sizes of tables and scrollbars.
constexpr int settling_frames = 3;

/// A viewer that draws into memory.
class Studio {
 public:
  explicit Studio(const Options& options)
      : interface_(nullptr, picture_scale(options.size)),
        canvas_(options.size),
        app_(options, interface_) {
    app_.hide_times();
    for (int i = 1; i < settling_frames; ++i) app_.draw(canvas_);
  }

  Picture take() {
    app_.draw(canvas_);
    return read_picture(canvas_);
  }
  void advance() { app_.advance(); }
  const Page& page() const { return app_.page(); }
  /// Why the page shows no picture; empty if it shows one.
  const std::string& problem() const { return app_.page().content().problem; }

 private:
  Interface interface_;
  Canvas canvas_;
  App app_;
};

/// As many frames as the walk of a page has steps, within limits.
int default_frame_count(const Page& page) {
  constexpr int most = 120;
  return page.lab() == 0 ? most : std::clamp(page.content().step_count, 1, most);
}

/// A world runs in real time with a step per frame, a walk slowly enough to follow.
double frames_per_second(const Page& page) {
  const auto* world = dynamic_cast<const WorldPage*>(&page);
  return world != nullptr ? 1 / static_cast<double>(world->step_length()) : 2.5;
}

void write_frames(Studio& studio, const fs::path& folder, int count) {
  for (int i = 0; i < count; ++i) {
    if (i > 0) studio.advance();
    write_png(studio.take(), folder / frame_name(i));
    files::throw_if_interrupted();
  }
}

/// All that the options ask for.
void write_pictures(Studio& studio, const Options& options) {
  if (!studio.problem().empty()) {
    // With a student's code, the picture shows the problem. Otherwise there is nothing to show.
    if (!options.student) throw std::invalid_argument(studio.problem());
    std::cerr << files::indented("cs550: the page reports: " + studio.problem(), 0);
  }
  if (!options.snapshot.empty()) {
    write_png(studio.take(), options.snapshot);
    std::cout << options.snapshot.string() << '\n';
  }
  const int frame_count = options.frame_count.value_or(default_frame_count(studio.page()));
  if (!options.frames.empty()) {
    write_frames(studio, options.frames, frame_count);
    std::cout << options.frames.string() << ": " << frame_count << " frames\n";
  }
  if (options.gif.empty()) return;
  if (options.frames.empty()) {
    const TemporaryFolder folder;
    write_frames(studio, folder.path(), frame_count);
    write_animation(folder.path(), frame_count, options.gif, frames_per_second(studio.page()));
  } else {
    write_animation(options.frames, frame_count, options.gif, frames_per_second(studio.page()));
  }
  std::cout << options.gif.string() << '\n';
}

}  // namespace

Picture take_picture(const Options& options) { return Studio(options).take(); }

void write_pictures(const Options& options) {
  const HeadlessContext context;
  Studio studio(options);
  write_pictures(studio, options);
  if (const std::string& lost = studio.page().content().lost; !lost.empty()) {
    throw std::runtime_error("the world stands still before a step that loses the finite state: " +
                             lost);
  }
}

}  // namespace cs550::viewer
