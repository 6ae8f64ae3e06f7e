// The command line of the viewer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "cli/system/viewer_options.hpp"
#include "pages/failure/failure_panels.hpp"
#include "program.hpp"
#include "viewer/options.hpp"
#include "viewer/snapshot_command.hpp"

namespace cs550::test {
namespace {

namespace fs = std::filesystem;

/// The first line of a text that is wider than a terminal, but for a long word on a line of its own.
std::string too_wide_line(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto continues = [](char byte) { return (byte & 0xC0) == 0x80; };
    const auto columns = std::ssize(line) - std::count_if(line.begin(), line.end(), continues);
    const std::size_t word = std::min(line.find_first_not_of(' '), line.size());
    if (columns > 80 && line.find(' ', word) != std::string::npos) return line;
  }
  return {};
}

/// A wrapped message without its line breaks.
std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

class CommandLine : public testing::Test {
 protected:
  CommandLine() : folder(fs::temp_directory_path() / ("cs550-view-" + std::to_string(getpid()))) {
    fs::create_directories(folder);
  }
  ~CommandLine() override { fs::remove_all(folder); }

  static Outcome view(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), CS550_VIEWER_PROGRAM);
    return run_program(arguments);
  }
  std::string file(const std::string& name) const { return (folder / name).string(); }
  static std::string bytes(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder;
};

TEST_F(CommandLine, TheSameCommandGivesTheSameBytes) {
  for (const std::string lab : {"4", "0"}) {
    std::vector<std::string> pictures;
    for (const char* name : {"first.png", "second.png"}) {
      std::vector<std::string> arguments{"--size", "400x300", "--snapshot", file(name)};
      if (lab != "0") arguments.insert(arguments.end(), {"--lab", lab});
      const Outcome outcome = view(arguments);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
      EXPECT_EQ(outcome.output, file(name) + "\n");
      pictures.push_back(bytes(file(name)));
    }
    EXPECT_GT(pictures[0].size(), 1000U);
    EXPECT_TRUE(pictures[0] == pictures[1]) << "lab " << lab;
  }
}

TEST_F(CommandLine, WrongValuesAreRefusedWithWhatIsWrongAndHowToMendIt) {
  struct Mistake {
    std::vector<std::string> arguments;
    std::string says;
  };
  const Mistake mistakes[] = {
      {{"--size", "12"}, "--size 1280x720"},
      {{"--size", "10x10"}, "from 64 to 8192"},
      {{"--camera", "7"}, "--camera=-60,20,8"},
      {{"--camera", "1,89"}, "pitch"},
      {{"--camera", "1,x"}, "'x' is not a number"},
      {{"--camera", "0,0,1e38"}, "'1e38' is not a number from -1e7 to 1e7"},
      {{"--camera", "0,0,1e-20"}, "at least 0.001 m"},
      {{"--ui", "maybe"}, "neither on nor off"},
      {{"--lab", "8"}, "--lab"},
      {{"--steps", "-1"}, "--steps"},
      {{"--set", "substeps"}, "name=value"},
      {{"--set", "substeps=1001"}, "1 to 1000"},
      {{"--set", "gravity=1,2"}, "x,y,z"},
      {{"--set", "soultion=1"}, "It has: contacts"},
      {{"--lab", "3", "--set", "step=-2"}, "0 to 60, or last"},
      {{"--lab", "2", "--set", "walk=jump"}, "next, prev, twin, face"},
      {{"--frames", file("frames")}, "cannot be used together"},
      {{"--frames", ""}, "found an empty text"},
      {{"--frames", std::string(300, 'x')}, "found 300 letters"},
      {{"--gif", std::string(300, 'x') + ".gif"}, "found 304 letters"},
      {{"--failure", std::string(300, 'x')}, "found 300 letters"},
      {{"no_such_scene"}, "no_such_scene"},
      {{"no_such_scene", "--student"}, "Give the path of a scene file or one of"},
      {{"--no-such-option"}, "--no-such-option"},
      {{"--stpes", "3"}, "there is no option --stpes. Did you mean --steps?"},
      {{"--student=5"}, "--student takes no value"},
  };
  for (const Mistake& mistake : mistakes) {
    std::vector<std::string> arguments = mistake.arguments;
    arguments.insert(arguments.end(), {"--snapshot", file("none.png")});
    const Outcome outcome = view(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_NE(in_one_line(outcome.output).find(mistake.says), std::string::npos) << outcome.output;
    EXPECT_EQ(too_wide_line(outcome.output), "");
    EXPECT_FALSE(fs::exists(file("none.png"))) << mistake.arguments.front();
  }
}

/// The options of --help, with the names of their values.
std::set<std::string> options_in(const std::string& help) {
  static const std::regex line(
      R"(\n  (?:(-[a-z]),)?(--[a-z-]+)(?: ([A-Z][A-Za-z=]*|on\|off))?(?= |\n))");
  std::set<std::string> options;
  for (std::sregex_iterator found(help.begin(), help.end(), line), end; found != end; ++found) {
    if ((*found)[1].matched) options.insert((*found)[1]);
    const std::string value = (*found)[3];
    options.insert((*found)[2].str() + (value.empty() ? "" : " " + value));
  }
  return options;
}

TEST_F(CommandLine, ItsOptionsAreKnownBeforeTheViewerIsBuilt) {
  std::set<std::string> known;
  for (const files::Argument& option : cli::viewer_options) {
    known.insert(option.name + (option.value.empty() ? "" : " " + option.value));
  }
  EXPECT_EQ(known, options_in(view({"--help"}).output));
}

TEST_F(CommandLine, WrongArgumentsAreRefusedWithoutAScreenToo) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"no_such_scene"}, {"--set", "soultion=1"}, {"--lab", "3", "--set", "step=-2"}}) {
    std::vector<std::string> command{
        "env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", CS550_VIEWER_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  }
}

/// A command for a shell in one line.
std::string unbroken(const std::string& command) {
  return std::regex_replace(command, std::regex(R"( \\\n *)"), " ");
}

TEST_F(CommandLine, ThePictureToTakeWithoutAScreenIsOfWhatWasTyped) {
  const auto advice = [](const std::vector<std::string>& arguments) {
    std::vector<const char*> words{"viewer"};
    for (const std::string& word : arguments) words.push_back(word.c_str());
    const auto line = viewer::read_command_line(static_cast<int>(words.size()), words.data());
    return viewer::snapshot_command(line.options);
  };
  EXPECT_EQ(advice({}), "./cs550 view --snapshot wall.png");
  EXPECT_EQ(advice({"bounce", "--set", "quality=game"}),
            "./cs550 view bounce --set quality=game --snapshot bounce.png");
  EXPECT_EQ(advice({"--student", "--lab", "4"}),
            "./cs550 view --student --lab 4 --snapshot lab4.png");
  std::ofstream(file("Lab3.Climb.svg"));
  EXPECT_EQ(advice({"--failure", file("Lab3.Climb.svg")}),
            "./cs550 view --failure Lab3.Climb --snapshot Lab3.Climb.png");
  std::ofstream(file("my scene.json"));
  EXPECT_EQ(unbroken(advice({file("my scene.json")})),
            "./cs550 view '" + file("my scene.json") + "' --snapshot 'my scene.png'");
  EXPECT_EQ(advice({"--set", "gravity=0,0,-3", "--set", "substeps=12", "--set", "time_step=0.01"}),
            "./cs550 view --set gravity=0,0,-3 --set substeps=12 --set time_step=0.01 \\\n"
            "    --snapshot wall.png");
}

/// Whatever the length of its words: a line break inside quotes would name another file.
TEST_F(CommandLine, TheCommandWithoutAScreenCanBeCopied) {
  const std::string scene = file("a scene " + std::string(120, 'x') + " of long words.json");
  std::ofstream(scene) << R"({"name": "empty", "bodies": []})";
  const Outcome outcome =
      run_program({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", CS550_VIEWER_PROGRAM, scene});
  EXPECT_EQ(outcome.exit_code, 1);
  const std::size_t message_end = outcome.output.find("A picture needs no screen:\n");
  ASSERT_NE(message_end, std::string::npos) << outcome.output;
  EXPECT_NE(unbroken(outcome.output).find("./cs550 view '" + scene + "' --snapshot 'a scene "),
            std::string::npos)
      << outcome.output;
  EXPECT_EQ(too_wide_line(outcome.output.substr(0, message_end)), "");
}

TEST_F(CommandLine, AFileThatCannotBeWrittenIsNamed) {
  const Outcome outcome = view({"--lab", "3", "--size", "64x64", "--snapshot", "/dev/null/a.png"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("cannot write /dev/null/a.png"), std::string::npos)
      << outcome.output;
}

TEST_F(CommandLine, FramesAreNumberedAndDiffer) {
  const Outcome outcome = view({"free_spin", "--size", "160x120", "--ui", "off", "--frames",
                                file("frames"), "--frame-count", "3"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(fs::exists(file("frames/0002.png")));
  EXPECT_FALSE(fs::exists(file("frames/0003.png")));
  EXPECT_NE(bytes(file("frames/0000.png")), bytes(file("frames/0002.png")));
}

TEST_F(CommandLine, FramesGoOnceThroughTheWalkOfAPageFromItsBeginning) {
  ASSERT_EQ(view({"--lab", "3", "--size", "160x120", "--frames", file("walk")}).exit_code, 0);
  const auto step = [&](const std::string& option, const std::string& value) {
    EXPECT_EQ(view({"--lab", "3", "--size", "160x120", option, value, "--snapshot", file("a.png")})
                  .exit_code,
              0);
    return bytes(file("a.png"));
  };
  EXPECT_TRUE(bytes(file("walk/0000.png")) == step("--set", "step=0"));
  EXPECT_TRUE(bytes(file("walk/0002.png")) == step("--set", "step=2"));
  EXPECT_TRUE(bytes(file("walk/0002.png")) == step("--steps", "2"));
  EXPECT_TRUE(bytes(file("walk/0006.png")) == step("--set", "step=last"));
  EXPECT_FALSE(fs::exists(file("walk/0007.png")));
}

TEST_F(CommandLine, ThePictureOfAFailingTestIsShown) {
  pages::FailurePanel panel;
  panel.content.drawing.points.push_back({Vec3::Zero(), drawing::Role::Got, 40});
  std::ofstream(file("Lab3.Climb.svg")) << pages::with_panels("<svg></svg>", {panel, panel});
  const auto shows = [&](const std::string& wanted, std::vector<std::string> more) {
    more.insert(more.begin(), {"--failure", file("Lab3.Climb.svg"), "--size", "160x120"});
    const Outcome outcome = view(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find(wanted), std::string::npos) << outcome.output;
  };
  shows("panel=2", {"--list"});
  shows(file("a.png"), {"--snapshot", file("a.png")});
  shows(file("frames") + ": 2 frames", {"--frames", file("frames")});
  std::ofstream(file("Lab3.Climb.svg")) << "<svg></svg>";
  EXPECT_EQ(view({"--failure", file("Lab3.Climb.svg"), "--list"}).exit_code, 2);
  EXPECT_EQ(view({"--failure", file("absent.svg"), "--list"}).exit_code, 2);
}

TEST_F(CommandLine, AnAnimationIsAGif) {
  const Outcome outcome = view({"--lab", "3", "--size", "160x120", "--ui", "off", "--gif",
                                file("walk.gif"), "--frame-count", "4"});
  if (outcome.output.find("needs ffmpeg") != std::string::npos) GTEST_SKIP() << outcome.output;
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(bytes(file("walk.gif")).substr(0, 4), "GIF8");
}

/// The second run's pictures are fewer than those of the first, and the folder's name has a pattern in it.
TEST_F(CommandLine, AnAnimationHasThePicturesOfItsRunOnly) {
  const auto animate = [&](const std::string& frames, const std::string& gif,
                           const std::string& count) {
    return view({"--lab", "3", "--size", "160x120", "--ui", "off", "--frames", file(frames),
                 "--gif", file(gif), "--frame-count", count});
  };
  const Outcome outcome = animate("at 100%d *", "long.gif", "5");
  if (outcome.output.find("needs ffmpeg") != std::string::npos) GTEST_SKIP() << outcome.output;
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  ASSERT_EQ(animate("at 100%d *", "second.gif", "2").exit_code, 0);
  ASSERT_EQ(animate("fresh", "fresh.gif", "2").exit_code, 0);
  EXPECT_TRUE(bytes(file("second.gif")) == bytes(file("fresh.gif")));
  EXPECT_FALSE(bytes(file("long.gif")) == bytes(file("fresh.gif")));
}

TEST_F(CommandLine, AWorldThatLosesItsFiniteStateFailsAndIsShown) {
  std::ofstream(file("lost.json")) << R"({"schema": 1, "h": 1, "world": {"gravity": [0, 0, -1e6]},
    "bodies": [{"shape": {"kind": "box", "half_extents": [1, 1, 1]}, "mass": 9e11}]})";
  const auto steps = [&](const std::string& count) {
    return view({file("lost.json"), "--steps", count, "--size", "160x120", "--ui", "off",
                 "--snapshot", file(count + ".png")});
  };
  EXPECT_EQ(steps("1").exit_code, 0);
  const Outcome outcome = steps("1000");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("loses the finite state: "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("body 0"), std::string::npos) << outcome.output;
  EXPECT_TRUE(fs::exists(file("1000.png")));
}

TEST_F(CommandLine, ASceneThatCannotBeReadHasNoSettings) {
  std::ofstream(file("damaged.json")) << "{";
  const Outcome outcome = view({file("damaged.json"), "--list"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.output.find("damaged.json"), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.output.find("substeps="), std::string::npos) << outcome.output;
}

/// Its shapes are made by the student's code, so the command may be right.
TEST_F(CommandLine, ASceneThatAStudentsCodeCannotReadHasNoSettings) {
  std::ofstream(file("damaged.json")) << "{";
  const Outcome outcome = view({file("damaged.json"), "--student", "--list"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("damaged.json"), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.output.find("substeps="), std::string::npos) << outcome.output;
}

TEST_F(CommandLine, HelpFitsEightyColumns) {
  std::istringstream lines(view({"--help"}).output);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_GT(count, 20);
}

TEST_F(CommandLine, ListsTheSettingsOfAPage) {
  const Outcome outcome = view({"--lab", "3", "--list"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.output.find("direction="), std::string::npos) << outcome.output;
}

// Without labs/ this program does not exist.
#ifdef CS550_VIEWER_ON_STARTERS
/// The starters: every function throws NotImplemented.
TEST_F(CommandLine, AnUnwrittenStageShowsItsMessageInsteadOfAPicture) {
  for (int lab = 1; lab <= 7; ++lab) {
    const std::string number = std::to_string(lab);
    const Outcome outcome = run_program({CS550_VIEWER_ON_STARTERS, "--student", "--lab", number,
                                         "--size", "320x200", "--snapshot", file("stub.png")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    // Clipping needs an axis, so lab 5 reports that lab 4 is missing.
    const std::string missing = lab == 5 ? "4" : number;
    EXPECT_NE(outcome.output.find("not implemented: L" + missing + "."), std::string::npos)
        << outcome.output;
    EXPECT_TRUE(fs::exists(file("stub.png")));
  }
}

TEST_F(CommandLine, AnEngineThatCannotMakeTheSceneListsTheDefaultSettings) {
  const Outcome outcome = run_program({CS550_VIEWER_ON_STARTERS, "wall", "--student", "--list"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("substeps="), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("these are the default settings"), std::string::npos)
      << outcome.output;
}

TEST_F(CommandLine, AnUnfinishedEngineStillShowsItsBodies) {
  const Outcome outcome = run_program({CS550_VIEWER_ON_STARTERS, "free_spin", "--student", "--size",
                                       "320x200", "--snapshot", file("stub.png")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(outcome.output, file("stub.png") + "\n")
      << "the missing stages are notes, not failures";
}
#endif

}  // namespace
}  // namespace cs550::test
