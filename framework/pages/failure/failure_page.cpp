#include "pages/failure/failure_page.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "pages/failure/failure_panels.hpp"

namespace cs550::pages {
namespace {

namespace fs = std::filesystem;

/// Shows one panel at a time. Stepping shows the next one.
class FailurePage final : public Page {
 public:
  FailurePage(std::string test, std::vector<FailurePanel> panels)
      : test_(std::move(test)), panels_(std::move(panels)), shown_(count()) {
    for (FailurePanel& panel : panels_) {
      panel.content.drawing = drawing::finite_part(panel.content.drawing);
      panel.content.step_count = count();
    }
  }

  int lab() const override { return failure_page; }
  std::string title() const override { return test_; }
  std::string story() const override {
    std::string text = content().drawing.title;
    for (const std::string& note : content().drawing.notes) text += "\n\n" + note;
    return text;
  }
  void describe(ControlVisitor& visit) override {
    visit.whole({"panel", "shown panel", ""}, shown_, 1, count());
  }
  void refresh() override {}
  const Content& content() const override { return panel().content; }
  Camera first_view() const override {
    const Vec3& eye = panel().toward_eye;
    return seen_from(std::atan2(eye.y(), eye.x()), std::atan2(eye.z(), eye.head<2>().norm()));
  }
  void advance() override { shown_ = shown_ % count() + 1; }
  void rewind() override { shown_ = 1; }

 private:
  int count() const { return static_cast<int>(panels_.size()); }
  const FailurePanel& panel() const { return panels_.at(shown_ - 1); }

  std::string test_;
  std::vector<FailurePanel> panels_;
  int shown_;  ///< from 1
};

std::vector<FailurePanel> read_panels(const fs::path& picture) {
  std::ifstream file(picture);
  if (!file) throw std::invalid_argument("cannot read " + picture.string());
  std::vector<FailurePanel> panels;
  try {
    panels = panels_in({std::istreambuf_iterator<char>(file), {}});
  } catch (const std::exception& error) {
    throw std::invalid_argument("the drawings in " + picture.string() +
                                " are damaged: " + error.what());
  }
  if (panels.empty()) throw std::invalid_argument("there are no drawings in " + picture.string());
  return panels;
}

}  // namespace

std::unique_ptr<Page> make_failure_page(const fs::path& picture) {
  return std::make_unique<FailurePage>(picture.stem().string(), read_panels(picture));
}

}  // namespace cs550::pages
