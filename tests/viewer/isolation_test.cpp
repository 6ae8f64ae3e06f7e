// Code that may fail runs in a child process.
#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

#include "cs550/not_implemented.hpp"
#include "isolation/service.hpp"
#include "pages/base/content_archive.hpp"

namespace cs550::test {
namespace {

using namespace std::chrono_literals;
using isolation::Answer;
using isolation::Isolation;
using IntService = isolation::Service<int, int>;

TEST(Isolation, AnswersComeBackAndStateIsKept) {
  for (const Isolation isolation : {Isolation::Here, Isolation::Child}) {
    int sum = 0;
    IntService service([sum](const int& term) mutable { return sum += term; }, isolation);
    EXPECT_EQ(service.ask(3).value, 3);
    EXPECT_EQ(service.ask(4).value, 7);
  }
}

TEST(Isolation, WhatIsThrownBecomesASentence) {
  for (const Isolation isolation : {Isolation::Here, Isolation::Child}) {
    IntService missing([](const int&) -> int { throw NotImplemented("L3.2", "hill_climb"); },
                       isolation);
    EXPECT_NE(missing.ask(0).failure.find("not implemented: L3.2 hill_climb"), std::string::npos);
    IntService strange([](const int&) -> int { throw 7; }, isolation);
    EXPECT_FALSE(strange.ask(0).failure.empty());
  }
}

TEST(Isolation, ACrashIsSaidAndStaysSaid) {
  IntService service(
      [](const int& request) {
        if (request == 2) std::raise(SIGSEGV);
        return request;
      },
      Isolation::Child);
  EXPECT_EQ(service.ask(1).value, 1);
  EXPECT_EQ(service.ask(2).failure, "crashed: Segmentation fault");
  EXPECT_EQ(service.ask(1).failure, "crashed: Segmentation fault");
}

TEST(Isolation, AnEndlessLoopIsStopped) {
  IntService service(
      [](const int& request) {
        volatile bool forever = request == 0;
        while (forever) {
        }
        return request;
      },
      Isolation::Child, 1000ms);
  EXPECT_EQ(service.ask(5).value, 5);
  EXPECT_EQ(service.ask(0).failure, "stopped after 1 s without an answer (an endless loop?)");
}

TEST(Isolation, EndingTheProgramIsSaid) {
  IntService service([](const int&) -> int { _exit(3); }, Isolation::Child);
  EXPECT_EQ(service.ask(0).failure, "ended with exit code 3");
}

TEST(Isolation, AContentSurvivesTheWire) {
  pages::Content content;
  content.drawing.labels.push_back({Vec3(1, 2, 3), "λ", drawing::Role::Axis});
  content.drawing.polygons.push_back({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}, 1});
  content.plots.emplace_back().series.push_back({"energy", {Vec2(1, 2)}, {}, {}, true});
  content.facts.push_back({"mass", "1 kg"});
  content.step_count = 7;
  content.focus = {Vec3(4, 5, 6), 2};
  content.solids.emplace_back().mesh = std::make_shared<const HalfEdgeMesh>();
  const auto copy = serialisation::from_bytes<pages::Content>(serialisation::to_bytes(content));
  EXPECT_EQ(serialisation::to_bytes(copy), serialisation::to_bytes(content));
  EXPECT_EQ(copy.drawing.labels[0].text, "λ");
  EXPECT_EQ(copy.focus.center, Vec3(4, 5, 6));
  EXPECT_TRUE(copy.plots[0].series[0].dashed);
}

}  // namespace
}  // namespace cs550::test
