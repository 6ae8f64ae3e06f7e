/// When `./cs550 lab` suggests --asan for wrong values.
#include "cli/grading/memory_signs.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "cli/scratch_project.hpp"
#include "helpers/scoped_environment.hpp"

namespace {

namespace fs = std::filesystem;
using cs550::cli::memory_advice;
using cs550::cli::Verdict;
using Kind = cs550::cli::Verdict::Kind;

class MemorySigns : public cs550::cli::ScratchProject {
 protected:
  /// A graded program whose only test fails with a message that the shell expands.
  fs::path program_that_reports(const std::string& message) const {
    const fs::path program = root / "program";
    std::ofstream(program)
        << "#!/bin/sh\ncat >\"$3\" <<END\n"
           R"({"tests": [{"test": "Lab5.Clips", "status": "failed", "seconds": 0,)"
        << " \"message\": \"" << message << "\"}]}\nEND\n";
    fs::permissions(program, fs::perms::owner_all);
    return program;
  }
  static Verdict failed(const std::string& message) {
    return {{"Clips", "L5.1", 4, false}, Kind::Failed, message, 0};
  }

 private:
  const cs550::test::ScopedEnvironment no_tunables_{"GLIBC_TUNABLES", std::nullopt};
  const cs550::test::ScopedEnvironment no_pictures_{"CS550_PICTURES", std::nullopt};
};

TEST_F(MemorySigns, ValuesThatDependOnFreedMemoryAreAMemoryError) {
  const fs::path program = program_that_reports("got 0${GLIBC_TUNABLES:+garbage}");
  const std::string advice = memory_advice(program, 5, failed("got 0"));
  EXPECT_NE(advice.find("Clips gets other values if freed memory"), std::string::npos) << advice;
  EXPECT_NE(advice.find("\ntry  ./cs550 lab 5 --asan  which"), std::string::npos) << advice;
  EXPECT_EQ(std::getenv("GLIBC_TUNABLES"), nullptr);
}

TEST_F(MemorySigns, ValuesThatAreTheSameInEveryRunAreNone) {
  EXPECT_EQ(memory_advice(program_that_reports("got 0"), 5, failed("got 0")), "");
}

TEST_F(MemorySigns, ValuesThatDependOnEarlierTestsAreNone) {
  const std::string advice = memory_advice(program_that_reports("got 1"), 5, failed("got 0"));
  EXPECT_NE(advice.find("Clips gets other values if it runs alone"), std::string::npos) << advice;
  EXPECT_NE(advice.find("static or global variable"), std::string::npos) << advice;
  EXPECT_NE(advice.find("a local one may be read before it is set"), std::string::npos) << advice;
  EXPECT_EQ(advice.find("--asan"), std::string::npos) << advice;
}

TEST_F(MemorySigns, AValueThatIsNotANumberMayBeOneWhateverElseDependsOnEarlierTests) {
  const fs::path program = program_that_reports("  got       0");
  const std::string advice = memory_advice(program, 5, failed("  got       nan"));
  EXPECT_NE(advice.find("not a number"), std::string::npos) << advice;
  EXPECT_NE(advice.find("./cs550 lab 5 --asan"), std::string::npos) << advice;
}

TEST_F(MemorySigns, ValuesThatChangeWithEachRunMayBeRandomNumbers) {
  for (const std::string report : {"got $$", "got 1${GLIBC_TUNABLES:+garbage}"}) {
    const std::string advice = memory_advice(program_that_reports(report), 5, failed("got 0"));
    EXPECT_NE(advice.find("Clips gets other values each time it runs"), std::string::npos)
        << advice;
    EXPECT_NE(advice.find("may use random numbers"), std::string::npos) << advice;
    EXPECT_NE(advice.find("./cs550 lab 5 --asan"), std::string::npos) << advice;
  }
}

TEST_F(MemorySigns, ThePicturesOfTheReportedFailuresStay) {
  const std::string picture = "build/results/pictures/Lab5.Clips.svg";
  fs::create_directories((root / picture).parent_path());
  std::ofstream(root / picture) << "reported";
  const fs::path program = program_that_reports(
      "  got       0\\n  picture   $(echo repeated >$CS550_PICTURES/Lab5.Clips.svg; echo "
      "$CS550_PICTURES/Lab5.Clips.svg)");
  EXPECT_EQ(memory_advice(program, 5, failed("  got       0\n  picture   " + picture)), "");
  std::string kept;
  std::ifstream(root / picture) >> kept;
  EXPECT_EQ(kept, "reported");
  EXPECT_EQ(std::getenv("CS550_PICTURES"), nullptr);
  for (const fs::directory_entry& left : fs::directory_iterator(root / "build/results")) {
    EXPECT_EQ(left.path().filename(), "pictures");
  }
}

TEST_F(MemorySigns, AValueThatIsNotANumberMayBeOne) {
  const std::string report = "  got       (0, -nan, 0)";
  const std::string advice = memory_advice(program_that_reports(report), 5, failed(report));
  EXPECT_NE(advice.find("not a number. If no division"), std::string::npos) << advice;
  EXPECT_NE(advice.find("./cs550 lab 5 --asan"), std::string::npos) << advice;
}

TEST_F(MemorySigns, OrdinaryWrongValuesAreNone) {
  const std::string report = "  given     nan in the mesh banana  got       3 m";
  EXPECT_EQ(memory_advice(program_that_reports(report), 5, failed(report)), "");
}

TEST_F(MemorySigns, NothingIsRunAgainIfNoValuesWereCompared) {
  const fs::path program = program_that_reports("got something else");
  EXPECT_EQ(memory_advice(program, 5, failed("not implemented: L5.1 clip_polygon")), "");
  Verdict crashed = failed("crashed: Aborted");
  crashed.ending = "crashed: Aborted";
  EXPECT_EQ(memory_advice(program, 5, crashed), "");
  Verdict long_test = failed("got 0");
  long_test.test.is_long = true;
  EXPECT_EQ(memory_advice(program, 5, long_test), "");
}

}  // namespace
