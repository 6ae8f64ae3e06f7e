/// The report of a test that a sanitizer or an assertion has stopped.
#include <gtest/gtest.h>

#include <string>

#include "cli/grading/crash_report.hpp"

namespace {

using cs550::cli::calls_in;
using cs550::cli::crash_report;

// As GCC 12 prints them, with some frames left out.
const std::string out_of_bounds = R"([ RUN      ] Lab3.FirstOfEqualVerticesWins
=================================================================
==26573==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x606000000664 at pc 0x55c1cefee43b bp 0x7ffd4409aad0 sp 0x7ffd4409aac8
READ of size 4 at 0x606000000664 thread T0
    #0 0x55c1cefee43a in float Eigen::internal::pmul<float>(float const&, float const&) /usr/include/eigen3/Eigen/src/Core/GenericPacketMath.h:237
    #12 0x55c1cefee43a in Eigen::MatrixBase<Eigen::Matrix<float, 3, 1, 2, 3, 1> >::dot() const /usr/include/eigen3/Eigen/src/Core/Dot.h:83
    #13 0x55c1cefee43a in cs550::support_brute_force(std::span<Eigen::Matrix<float, 3, 1, 2, 3, 1> const, 18446744073709551615ul>, Eigen::Matrix<float, 3, 1, 2, 3, 1> const&) labs/lab3_hill_climbing/hill_climbing.cpp:13
    #14 0x55c1ceb20ba3 in run tests/lab3_hill_climbing/brute_force_test.cpp:56
    #15 0x55c1cef93276 in cs550::autograder::GradedTest::TestBody() framework/autograder/graded_test.cpp:50
    #16 0x55c1cefec1d6 in void testing::internal::HandleExceptionsInMethodIfSupported<testing::Test, void>() (/tmp/student copy/build/asan/bin/lab3_student+0xb6b1d6)

0x606000000664 is located 8 bytes to the right of 60-byte region [0x606000000620,0x60600000065c)
allocated by thread T0 here:
    #0 0x7f4d18eb94c8 in operator new(unsigned long) ../../../../src/libsanitizer/asan/asan_new_delete.cpp:95
    #7 0x55c1ceb1da8a in run tests/lab3_hill_climbing/brute_force_test.cpp:51

SUMMARY: AddressSanitizer: heap-buffer-overflow /usr/include/eigen3/Eigen/src/Core/GenericPacketMath.h:237 in float Eigen::internal::pmul<float>(float const&, float const&)
Shadow bytes around the buggy address:
)";

TEST(CrashReport, NamesEndlessAllocation) {
  EXPECT_EQ(crash_report("==7==AddressSanitizer: hard rss limit exhausted (4096Mb vs 4101Mb)\n"
                         "==7==Process memory map follows:\n"
                         "\t0x00007fff7000-0x00008fff7000\t\n"),
            "it allocated too much memory (a loop that adds elements without end?)\n");
}

TEST(CrashReport, NamesTheStudentsLineAmongTheLibraries) {
  EXPECT_EQ(crash_report(out_of_bounds),
            "memory error: heap-buffer-overflow\n"
            "READ of size 4\n"
            "  in support_brute_force, labs/lab3_hill_climbing/hill_climbing.cpp:13\n"
            "  from the test, tests/lab3_hill_climbing/brute_force_test.cpp:56\n"
            "8 bytes to the right of 60-byte region\n"
            "  allocated in the test, tests/lab3_hill_climbing/brute_force_test.cpp:51\n");
}

TEST(CrashReport, SaysWhichRuleOfTheLanguageWasBroken) {
  EXPECT_EQ(
      crash_report(R"([ RUN      ] Lab3.ClimbEndsOnAPlateau
/tmp/student copy/labs/lab3_hill_climbing/hill_climbing.cpp:26:70: runtime error: signed integer overflow: 36 + 2147483630 cannot be represented in type 'int'
    #0 0x55 in cs550::(anonymous namespace)::count(cs550::HalfEdgeMesh const&) labs/lab3_hill_climbing/hill_climbing.cpp:26
    #1 0x56 in cs550::hill_climb(cs550::HalfEdgeMesh const&, int) labs/lab3_hill_climbing/hill_climbing.cpp:40
    #2 0x57 in run tests/lab3_hill_climbing/hill_climb_test.cpp:41
    #13 0x7f38efa45304 in __libc_start_main_impl ../csu/libc-start.c:360
)"),
      "undefined behaviour: signed integer overflow: 36 + 2147483630 cannot be represented in type "
      "'int'\n"
      "  in count, labs/lab3_hill_climbing/hill_climbing.cpp:26\n"
      "  from hill_climb, labs/lab3_hill_climbing/hill_climbing.cpp:40\n"
      "  from the test, tests/lab3_hill_climbing/hill_climb_test.cpp:41\n");
}

TEST(CrashReport, AnEndlessRecursionIsShownByItsFirstFrames) {
  std::string output = "==7==ERROR: AddressSanitizer: stack-overflow on address 0x7ffc (pc 0x55)\n";
  for (int i = 0; i < 200; ++i) {
    output += "    #" + std::to_string(i) +
              " 0x55 in cs550::support(int) labs/lab3_hill_climbing/hill_climbing.cpp:9\n";
  }
  EXPECT_EQ(crash_report(output),
            "memory error: stack-overflow\n"
            "  in support, labs/lab3_hill_climbing/hill_climbing.cpp:9\n"
            "  from support, labs/lab3_hill_climbing/hill_climbing.cpp:9\n"
            "  from support, labs/lab3_hill_climbing/hill_climbing.cpp:9\n"
            "  from support, labs/lab3_hill_climbing/hill_climbing.cpp:9\n");
}

TEST(CrashReport, AnAssertionOfALibraryIsShown) {
  EXPECT_EQ(crash_report("lab3_student: /usr/include/eigen3/Eigen/src/Core/DenseCoeffsBase.h:408: "
                         "Eigen::Scalar& Eigen::operator[](Eigen::Index): Assertion `index >= 0 && "
                         "index < size()' failed.\n"),
            "assertion `index >= 0 && index < size()' failed.\n");
}

TEST(CrashReport, AnAssertionOfAContractNamesItsLine) {
  EXPECT_EQ(
      crash_report("lab5_student: /home/a/framework/include/cs550/static_vector.hpp:59: T& "
                   "cs550::StaticVector<T, N>::operator[](int): Assertion `i < size_' failed.\n"),
      "assertion `i < size_' failed.\n"
      "  at framework/include/cs550/static_vector.hpp:59\n");
}

TEST(CrashReport, AnAssertionLeadsToTheStudentsLine) {
  EXPECT_EQ(crash_report(R"(lab3_student: DenseCoeffsBase.h:408: Assertion `index < size()' failed.
==9==ERROR: AddressSanitizer: ABRT on unknown address 0x0000681f (pc 0x7f bp 0x00 sp 0x7f T0)
    #0 0x7f in __pthread_kill_implementation nptl/pthread_kill.c:43
    #7 0x55 in cs550::support(int) labs/lab3_hill_climbing/hill_climbing.cpp:45
)"),
            "assertion `index < size()' failed.\n"
            "  in support, labs/lab3_hill_climbing/hill_climbing.cpp:45\n");
}

TEST(CrashReport, AProgramThatWasStoppedNamesItsCalls) {
  const std::string report = crash_report(
      R"(==9==ERROR: AddressSanitizer: ABRT on unknown address 0x0000681f (pc 0x7f bp 0x00 sp 0x7f T0)
    #0 0x55 in cs550::link_faces(cs550::HalfEdgeMesh&) labs/lab2_half_edge_mesh/links.cpp:45
)");
  EXPECT_EQ(report, "aborted\n  in link_faces, labs/lab2_half_edge_mesh/links.cpp:45\n");
  EXPECT_EQ(calls_in(report), "  in link_faces, labs/lab2_half_edge_mesh/links.cpp:45\n");
  EXPECT_EQ(calls_in(""), "");
}

TEST(CrashReport, AProgramThatSaidNothingHasNone) {
  EXPECT_EQ(crash_report("[ RUN      ] Lab3.FirstOfEqualVerticesWins\n"), "");
}

}  // namespace
