/// Which files of a submission are taken, and what becomes of hostile archives.
#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <set>
#include <system_error>

#include "cli/system/files.hpp"
#include "files/output_file.hpp"
#include "gradebook/intake/discovery.hpp"
#include "gradebook/intake/lab_path.hpp"
#include "gradebook/intake/read_archive.hpp"
#include "gradebook/intake/read_folder.hpp"
#include "gradebook/run/grade_lab.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

/// An archive with entries of any kind.
class ArchiveWriter {
 public:
  explicit ArchiveWriter(const fs::path& file) : archive_(archive_write_new()) {
    if (file.extension() == ".zip") {
      archive_write_set_format_zip(archive_);
    } else {
      archive_write_set_format_pax_restricted(archive_);
      archive_write_add_filter_gzip(archive_);
    }
    archive_write_open_filename(archive_, file.c_str());
  }
  ~ArchiveWriter() { archive_write_free(archive_); }
  ArchiveWriter(const ArchiveWriter&) = delete;
  ArchiveWriter& operator=(const ArchiveWriter&) = delete;

  void add(const std::string& path, const std::string& text) {
    archive_entry* entry = begin(path, AE_IFREG);
    archive_entry_set_size(entry, static_cast<la_int64_t>(text.size()));
    archive_write_header(archive_, entry);
    archive_write_data(archive_, text.data(), text.size());
    archive_entry_free(entry);
  }
  void add_link(const std::string& path, const std::string& target, bool is_hard) {
    archive_entry* entry = begin(path, is_hard ? AE_IFREG : AE_IFLNK);
    if (is_hard) {
      archive_entry_set_hardlink(entry, target.c_str());
    } else {
      archive_entry_set_symlink(entry, target.c_str());
    }
    archive_write_header(archive_, entry);
    archive_entry_free(entry);
  }
  void add_device(const std::string& path) {
    archive_entry* entry = begin(path, AE_IFCHR);
    archive_write_header(archive_, entry);
    archive_entry_free(entry);
  }

 private:
  static archive_entry* begin(const std::string& path, unsigned type) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, path.c_str());
    archive_entry_set_filetype(entry, type);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, 0);
    return entry;
  }

  archive* archive_;
};

std::string reason_for(const Submission& submission, const std::string& path) {
  for (const IgnoredFile& file : submission.ignored) {
    if (file.path == path) return file.reason;
  }
  return {};
}

TEST(Archive, ZipAndTarHaveTheSameContent) {
  const ScratchFolder scratch;
  for (const char* name : {"ada.zip", "ada.tar.gz", "ada.tgz"}) {
    {
      ArchiveWriter writer(scratch / name);
      writer.add("labs/lab3_hill_climbing/hill_climbing.cpp", "int x;\n");
      writer.add("labs/lab3_hill_climbing/util/a.hpp", "int a;\n");
      writer.add("labs/lab3_hill_climbing/README.md", "words");
      writer.add("manifest.json", R"({"student": "Ada", "date": "2026-10-12T10:00:00Z"})");
    }
    const Submission submission = read(scratch / name);
    EXPECT_EQ(submission.trouble, "") << name;
    ASSERT_EQ(submission.labs.count(3), 1U) << name;
    ASSERT_EQ(submission.labs.at(3).size(), 2U);
    EXPECT_EQ(submission.labs.at(3)[1].path, "util/a.hpp");
    EXPECT_EQ(submission.labs.at(3)[0].text, "int x;\n");
    EXPECT_EQ(submission.student, "ada");
    EXPECT_EQ(submission.claimed_student, "Ada");
    EXPECT_NE(reason_for(submission, "labs/lab3_hill_climbing/README.md"), "");
  }
}

/// Marks the names of a zip as UTF-8, as programs do that know their encoding.
void mark_names_as_utf8(const fs::path& zip) {
  constexpr char is_utf8 = 8;  // in the upper byte of the flags
  std::string bytes = cli::read_text(zip);
  const auto mark = [&bytes](const std::string& header, std::size_t flags) {
    for (auto at = bytes.find(header); at != bytes.npos; at = bytes.find(header, at + 1)) {
      bytes[at + flags + 1] = static_cast<char>(bytes[at + flags + 1] | is_utf8);
    }
  };
  mark(std::string("PK\3\4", 4), 6);
  mark(std::string("PK\1\2", 4), 8);
  files::write_file(zip, bytes);
}

TEST(Archive, NamesOfFoldersMayHaveAnyEncoding) {
  const ScratchFolder scratch;
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  const std::string lab = "/labs/lab3_hill_climbing/hill_climbing.cpp";
  for (const char* name : {"marked.zip", "utf8.zip", "utf8.tar.gz"}) {
    { ArchiveWriter(scratch / name).add("Übung 3" + lab, "code"); }
    if (name == std::string("marked.zip")) mark_names_as_utf8(scratch / name);
    EXPECT_EQ(read(scratch / name).labs.count(3), 1U) << name;
  }
  for (const char* name : {"old.zip", "old.tar.gz"}) {
    {
      ArchiveWriter writer(scratch / name);
      writer.add("\232bung 3" + lab, "code");
      writer.add("\232bung 4" + lab, "old");
    }
    const Submission submission = read(scratch / name);
    ASSERT_EQ(submission.labs.count(3), 1U) << name;
    EXPECT_EQ(submission.labs.at(3)[0].text, "code");
    ASSERT_EQ(submission.ignored.size(), 1U);
    EXPECT_EQ(submission.ignored[0].reason,
              "not in \357\277\275bung 3/labs/lab3_hill_climbing/, which is graded");
  }
  EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
}

TEST(Folder, ASubmissionUnpackedByAFileManagerIsWhole) {
  const ScratchFolder scratch;
  files::write_file(scratch / "s0101/lab3/manifest.json", "{}");
  files::write_file(scratch / "s0101/lab3/labs/lab3_hill_climbing/hill_climbing.cpp", "code");
  files::write_file(scratch / "s0101/lab4/labs/lab4_separating_axis/support.cpp", "code");
  const Submission submission = read(scratch / "s0101");
  ASSERT_EQ(submission.labs.size(), 2U);
  EXPECT_EQ(submission.labs.at(3)[0].path, "hill_climbing.cpp");
  EXPECT_EQ(submission.labs.at(4)[0].path, "support.cpp");
  EXPECT_EQ(submission.whole_labs, (std::set<int>{3, 4}));
}

TEST(Archive, LinksAndDevicesAreIgnoredAndTheRestIsTaken) {
  const ScratchFolder scratch;
  {
    ArchiveWriter writer(scratch / "evil.tar.gz");
    writer.add("labs/lab3_hill_climbing/hill_climbing.cpp", "honest");
    writer.add_link("labs/lab3_hill_climbing/soft.cpp", "/etc/passwd", false);
    writer.add_link("labs/lab3_hill_climbing/hard.cpp", "/etc/shadow", true);
    writer.add_device("labs/lab3_hill_climbing/device.cpp");
    writer.add("../../labs/lab3_hill_climbing/up.cpp", "up");
    writer.add("/labs/lab3_hill_climbing/absolute.cpp", "absolute");
    writer.add("labs/lab3_hill_climbing/hill_climbing.cpp", "a second one");
    writer.add("labs/lab3_hill_climbing/hill_climbing.cpp/inside.hpp", "below a file");
  }
  const Submission submission = read(scratch / "evil.tar.gz");
  EXPECT_EQ(submission.trouble, "");
  ASSERT_EQ(submission.labs.at(3).size(), 1U);
  EXPECT_EQ(submission.labs.at(3)[0].text, "honest");
  EXPECT_EQ(reason_for(submission, "labs/lab3_hill_climbing/soft.cpp"), "symbolic link");
  EXPECT_EQ(reason_for(submission, "labs/lab3_hill_climbing/hard.cpp"), "hard link");
  EXPECT_NE(reason_for(submission, "labs/lab3_hill_climbing/device.cpp"), "");
  EXPECT_EQ(reason_for(submission, "../../labs/lab3_hill_climbing/up.cpp"), "path with ..");
  EXPECT_EQ(reason_for(submission, "/labs/lab3_hill_climbing/absolute.cpp"), "absolute path");
  EXPECT_NE(reason_for(submission, "labs/lab3_hill_climbing/hill_climbing.cpp"), "");
}

/// The files of a submission, handed in as a zip archive in this order, as a folder, and the other way round.
std::vector<Submission> in_any_order(std::vector<std::pair<std::string, std::string>> files) {
  std::vector<Submission> submissions;
  for (int i = 0; i < 2; ++i) {
    const ScratchFolder scratch;
    {
      ArchiveWriter writer(scratch / "ada.zip");
      for (const auto& [path, text] : files) writer.add(path, text);
    }
    submissions.push_back(read(scratch / "ada.zip"));
    for (const auto& [path, text] : files) files::write_file(scratch / "ada/" / path, text);
    submissions.push_back(
        read_submission({scratch / "ada", "ada", "ada", {}, ""}, project_catalogue()));
    std::reverse(files.begin(), files.end());
  }
  return submissions;
}

TEST(Choice, TheLabsFolderInTheProjectIsGradedAlone) {
  for (const Submission& submission :
       in_any_order({{"labs/lab3_hill_climbing/hill_climbing.cpp", "new"},
                     {"labs/lab3_hill_climbing/util.hpp", "new"},
                     {"hill_climbing.cpp", "stray"},
                     {"backup/lab3/extra.cpp", "old"},
                     {"old/labs/lab3_hill_climbing/older.cpp", "old"}})) {
    ASSERT_EQ(submission.labs.at(3).size(), 2U);
    EXPECT_EQ(submission.labs.at(3)[0].text, "new");
    EXPECT_EQ(submission.labs.at(3)[1].path, "util.hpp");
    EXPECT_TRUE(submission.whole_labs.contains(3));
    for (const char* other :
         {"hill_climbing.cpp", "backup/lab3/extra.cpp", "old/labs/lab3_hill_climbing/older.cpp"}) {
      EXPECT_EQ(reason_for(submission, other), "not in labs/lab3_hill_climbing/, which is graded");
    }
  }
}

TEST(Choice, OfEqualNamesTheOneNearestToTheTopIsGraded) {
  for (const Submission& submission : in_any_order({{"b/hill_climbing.cpp", "second"},
                                                    {"a/hill_climbing.cpp", "first"},
                                                    {"a/deep/hill_climbing.cpp", "deep"}})) {
    ASSERT_EQ(submission.labs.at(3).size(), 1U);
    EXPECT_EQ(submission.labs.at(3)[0].text, "first");
    EXPECT_NE(reason_for(submission, "b/hill_climbing.cpp"), "");
    EXPECT_NE(reason_for(submission, "a/deep/hill_climbing.cpp"), "");
  }
}

TEST(Choice, AFolderIsNeverInThePlaceOfAStarterFile) {
  for (const Submission& submission :
       in_any_order({{"lab3/hill_climbing.cpp/x.hpp", "int x;"}, {"lab3/util.hpp", "int y;"}})) {
    ASSERT_EQ(submission.labs.at(3).size(), 1U);
    EXPECT_EQ(submission.labs.at(3)[0].path, "util.hpp");
    EXPECT_EQ(reason_for(submission, "lab3/hill_climbing.cpp/x.hpp"),
              "in a folder with the name of a starter file");
  }
}

TEST(Choice, StarterFilesHaveAPlaceAmongTheFilesOfALab) {
  std::vector<std::pair<std::string, std::string>> files{{"deep/lab3/hill_climbing.cpp", "code"}};
  for (int i = 0; i < 120; ++i) files.emplace_back("lab3/a" + std::to_string(i) + ".hpp", "");
  for (const Submission& submission : in_any_order(files)) {
    const std::vector<SourceFile>& taken = submission.labs.at(3);
    EXPECT_EQ(taken.size(), 100U);
    EXPECT_TRUE(std::any_of(taken.begin(), taken.end(), [](const SourceFile& file) {
      return file.path == "hill_climbing.cpp" && file.text == "code";
    }));
  }
  files.erase(files.begin());
  const CatalogueLab& lab = project_catalogue().at(3);
  for (const Submission& submission : in_any_order(files)) {
    const LabFiles graded = files_to_grade(submission, lab, std::string(CS550_ROOT) + "/labs");
    EXPECT_EQ(graded.files.size(), 100U) << "with the starter";
    EXPECT_EQ(graded.supplied, std::vector<std::string>{"hill_climbing.cpp"});
  }
}

IntakeLimits four_megabytes() {
  IntakeLimits limits;
  limits.unpacked = 4 << 20;
  return limits;
}

/// What read_archive() or read_folder() reports.
template <class Read>
std::string trouble_within(const IntakeLimits& limits, const Read& read,
                           const std::filesystem::path& source) {
  Submission submission;
  Collector collector(submission, project_catalogue());
  return read(source, collector, limits);
}

TEST(Archive, AZipBombIsRefused) {
  const ScratchFolder scratch;
  {
    ArchiveWriter writer(scratch / "bomb.zip");
    const std::string megabyte(1 << 20, '0');
    for (int i = 0; i < 8; ++i) writer.add("zeros" + std::to_string(i), megabyte);
    writer.add("labs/lab3_hill_climbing/hill_climbing.cpp", "");
  }
  EXPECT_EQ(trouble_within(four_megabytes(), read_archive, scratch / "bomb.zip"),
            "the archive unpacks to more than 4 MB");
  IntakeLimits few;
  few.entries = 5;
  EXPECT_EQ(trouble_within(few, read_archive, scratch / "bomb.zip"),
            "the archive has more than 5 entries");
}

TEST(Archive, ContentWithAWrongChecksumIsCounted) {
  const ScratchFolder scratch;
  {
    ArchiveWriter writer(scratch / "bomb.zip");
    const std::string megabyte(1 << 20, '0');
    for (int i = 0; i < 8; ++i) writer.add("zeros" + std::to_string(i), megabyte);
    writer.add("hill_climbing.cpp", "");
  }
  std::string bytes = cli::read_text(scratch / "bomb.zip");
  const std::string central_entry("PK\1\2", 4);
  constexpr std::size_t checksum = 16;  // in an entry of the central directory
  for (auto at = bytes.find(central_entry); at != bytes.npos;
       at = bytes.find(central_entry, at + 1)) {
    bytes[at + checksum] = static_cast<char>(~bytes[at + checksum]);
  }
  files::write_file(scratch / "bomb.zip", bytes);
  EXPECT_EQ(trouble_within(four_megabytes(), read_archive, scratch / "bomb.zip"),
            "the archive unpacks to more than 4 MB");
}

TEST(Folder, FilesOfMoreThanTheLimitAreRefused) {
  const ScratchFolder scratch;
  for (int i = 0; i < 5; ++i) {
    files::write_file(scratch / "ada/lab3" / (std::to_string(i) + ".cpp"),
                      std::string(1 << 20, ' '));
  }
  EXPECT_EQ(trouble_within(four_megabytes(), read_folder, scratch / "ada"),
            "the folder has files of more than 4 MB");
}

TEST(Archive, AManifestIsReadWithinLimits) {
  const auto submission_with = [](const std::string& manifest) {
    const ScratchFolder scratch;
    {
      ArchiveWriter writer(scratch / "ada.zip");
      writer.add("manifest.json", manifest);
      writer.add("hill_climbing.cpp", "int x;\n");
    }
    return read(scratch / "ada.zip");
  };
  const std::string padding(70'000, ' ');
  const Submission large = submission_with(R"({"student": "Ada")" + padding + '}');
  EXPECT_EQ(large.claimed_student, "");
  EXPECT_EQ(reason_for(large, "manifest.json"), "larger than 64 kB");
  EXPECT_EQ(large.labs.count(3), 1U);
  const std::string deep = std::string(1000, '[') + std::string(1000, ']');
  EXPECT_EQ(submission_with(R"({"files": )" + deep + R"(, "student": "Ada"})").claimed_student,
            "Ada");
  EXPECT_NE(reason_for(submission_with(std::string(60'000, '[')), "manifest.json"), "");
}

TEST(Archive, WhatCannotBeReadIsReported) {
  const ScratchFolder scratch;
  files::write_file(scratch / "empty.zip", "");
  const std::string no_archive = "not a zip or tar archive (";
  EXPECT_EQ(read(scratch / "empty.zip").trouble.find(no_archive), 0U);
  files::write_file(scratch / "text.zip", "I am not a zip file, whatever my name is.");
  EXPECT_EQ(read(scratch / "text.zip").trouble.find(no_archive), 0U);
  files::write_file(scratch / "short.tgz", std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03xx", 12));
  EXPECT_EQ(read(scratch / "short.tgz").trouble.find(no_archive), 0U);
  { ArchiveWriter(scratch / "nothing.zip").add("notes.txt", "no lab"); }
  EXPECT_EQ(read(scratch / "nothing.zip").trouble, "it contains no file of a lab");
  {
    ArchiveWriter(scratch / "whole.zip").add("hill_climbing.cpp", std::string(50000, 'x') + "end");
  }
  const std::string whole = cli::read_text(scratch / "whole.zip");
  files::write_file(scratch / "half.zip", whole.substr(0, whole.size() / 2));
  const Submission half = read(scratch / "half.zip");
  EXPECT_NE(half.trouble, "");
  EXPECT_TRUE(half.labs.empty()) << "half a submission must not be graded";
}

/// Root can read every file: for a while, the test is somebody who cannot.
class AsNobody {
 public:
  AsNobody() : was_root_(geteuid() == 0) {
    constexpr uid_t nobody = 65534;
    if (was_root_ && seteuid(nobody) != 0) throw std::system_error(errno, std::generic_category());
  }
  ~AsNobody() {
    if (was_root_) seteuid(0);
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool was_root_;
};

TEST(Intake, WhatTheMachineCannotReadIsNotTheStudentsFault) {
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms::all);
  const fs::path file = scratch / "ada/labs/lab3_hill_climbing/hill_climbing.cpp";
  files::write_file(file, "code");
  { ArchiveWriter(scratch / "bob.zip").add("hill_climbing.cpp", "code"); }
  const std::vector<FoundSubmission> found =
      find_submissions({scratch.path()}, project_catalogue()).submissions;
  ASSERT_EQ(found.size(), 2U);
  for (const fs::path& locked : {file, scratch / "bob.zip"})
    fs::permissions(locked, fs::perms::none);
  const AsNobody somebody;
  std::error_code hidden;
  if (!fs::exists(file, hidden)) GTEST_SKIP() << "only its owner can enter the folder of this test";
  const Submission ada = read_submission(found[0], project_catalogue());
  EXPECT_EQ(ada.trouble,
            "labs/lab3_hill_climbing/hill_climbing.cpp cannot be read: Permission denied");
  EXPECT_TRUE(ada.labs.empty()) << "the starter must not take its place";
  EXPECT_EQ(read_submission(found[1], project_catalogue()).trouble,
            "cannot be read: Permission denied");
}

TEST(Archive, OnlyAFileIsOpened) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "class");
  ASSERT_EQ(mkfifo((scratch / "class/pipe.zip").c_str(), 0600), 0);
  alarm(10);  // nobody ever writes into it
  EXPECT_EQ(read(scratch / "class").trouble, "not a file");
  alarm(0);
  EXPECT_EQ(trouble_within({}, read_archive, scratch / "class"), "not a file");
  EXPECT_EQ(trouble_within({}, read_archive, scratch / "gone.zip"),
            "cannot be read: No such file or directory");
}

TEST(Folder, ACheckoutIsReadWithoutFollowingLinks) {
  const ScratchFolder scratch;
  const fs::path lab = scratch / "ada/labs/lab3_hill_climbing";
  files::write_file(lab / "hill_climbing.cpp", "code");
  files::write_file(scratch / "ada/.git/config", "[core]\nfsmonitor = touch /tmp/run");
  files::write_file(scratch / "ada/framework/given.cpp", "");
  fs::create_symlink("/etc/passwd", lab / "link.cpp");
  fs::create_directory_symlink("/etc", lab / "folder");
  const Submission submission = read(scratch / "ada");
  ASSERT_EQ(submission.labs.at(3).size(), 1U);
  EXPECT_EQ(reason_for(submission, "labs/lab3_hill_climbing/link.cpp"), "symbolic link");
  EXPECT_EQ(reason_for(submission, "labs/lab3_hill_climbing/folder"), "symbolic link");
  EXPECT_EQ(reason_for(submission, "framework/"), outside_of_labs);
}

TEST(Hash, DependsOnTheFilesOfTheLab) {
  Submission a;
  a.labs[3] = {{"a.cpp", "bc"}};
  Submission b;
  b.labs[3] = {{"a.cppb", "c"}};
  EXPECT_NE(a.hash(), b.hash());
  EXPECT_EQ(a.lab_hash(3), Submission(a).lab_hash(3));
  EXPECT_EQ(a.hash().size(), 64U);
}

}  // namespace
}  // namespace cs550::gradebook
