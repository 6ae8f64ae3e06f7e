/// The milestones as tests of a judge: scenes that labs of a submission run together, compared with
/// the recorded reference.
#include <gtest/gtest.h>

#include <stdexcept>

#include "milestones/record.hpp"

namespace {

using namespace cs550;
using namespace cs550::milestones;

class MilestoneTest : public testing::Test {
 public:
  explicit MilestoneTest(const Milestone& milestone) : milestone_(milestone) {}

  void TestBody() override {
    const SceneResult found = find_scene(milestone_.scene);
    if (!found) {
      ADD_FAILURE() << found.error;
      return;
    }
    const Comparison outcome =
        compare(run(milestone_, found.scene), read_record(record_file(milestone_)));
    if (!outcome.agrees) ADD_FAILURE() << outcome.sentence;
  }

 private:
  const Milestone& milestone_;
};

bool register_all() {
  for (const Milestone& milestone : all_milestones()) {
    testing::RegisterTest("Milestone", milestone.name().c_str(), nullptr, nullptr, __FILE__,
                          __LINE__, [&milestone]() -> MilestoneTest* {
                            return new MilestoneTest(milestone);  // GoogleTest deletes it
                          });
  }
  return true;
}

[[maybe_unused]] const bool are_registered = register_all();

}  // namespace
