/// Whose a submission is: the roster, and the names of files.
#include <gtest/gtest.h>

#include "gradebook/marks/csv_table.hpp"
#include "gradebook/marks/roster.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

TEST(Roster, RecordsFindTheirStudents) {
  const std::string text =
      "\xEF\xBB\xBFid,name,email\ns1,\"Lovelace, Ada\",ada@x.org\ns2,Bob,b@x.org\ns3,Eve,e@x.org\n";
  std::vector<Record> records{record_of("s1", lab_record(24, 24, 12)),
                              record_of("doe_bob_S2_late", lab_record(0, 0, 0)),
                              record_of("mallory", lab_record(0, 0, 0))};
  const std::vector<Student> students = assign(parse_roster(text, "roster.csv"), records);
  ASSERT_EQ(students.size(), 4U);
  EXPECT_EQ(students[0].name, "Lovelace, Ada");
  EXPECT_EQ(students[0].records.size(), 1U);
  EXPECT_EQ(students[1].records.size(), 1U);
  EXPECT_TRUE(students[2].records.empty());
  EXPECT_EQ(students[3].id, "mallory");
  EXPECT_FALSE(students[3].on_roster);
}

TEST(Roster, AFolderOfMoodleHasTheWholeName) {
  const std::string text = "id,name\ns1,\"Lovelace, Ada\"\ns2,Ada Byron\ns3,José Ada\ns4,Jo\n";
  std::vector<Record> records{
      record_of("Ada Lovelace_123_assignsubmission_file_", lab_record(24, 24, 12)),
      record_of("José Ada_124_assignsubmission_file_", lab_record(0, 0, 0)),
      record_of("Ada Byron Lovelace_125_assignsubmission_file_", lab_record(0, 0, 0))};
  const std::vector<Student> students = assign(parse_roster(text, "roster.csv"), records);
  ASSERT_EQ(students.size(), 5U) << "two names fit the last folder, so it is nobody's";
  EXPECT_EQ(students[0].records.size(), 1U);
  EXPECT_TRUE(students[1].records.empty());
  EXPECT_EQ(students[2].records.size(), 1U);
  EXPECT_TRUE(students[3].records.empty());
}

TEST(Roster, AClaimCountsOnlyWhereTheFileNameIsNobodys) {
  const std::string text = "id\nada\neve\n";
  std::vector<Record> records{record_of("eve", lab_record(0, 0, 0)),
                              record_of("lab3", lab_record(24, 24, 12))};
  records[0].claimed_student = records[1].claimed_student = "ada";
  const std::vector<Student> students = assign(parse_roster(text, "roster.csv"), records);
  ASSERT_EQ(students.size(), 2U);
  ASSERT_EQ(students[0].records.size(), 1U);
  EXPECT_EQ(students[0].records[0]->student, "lab3");
  EXPECT_EQ(students[1].records.size(), 1U) << "eve must not hand in for ada";
}

/// The id of the student to whom a record is given.
std::string owner_of(const Record& record, const std::vector<Student>& roster) {
  const std::vector<Record> records{record};
  for (const Student& student : assign(roster, records)) {
    if (!student.records.empty()) return student.id;
  }
  return {};
}

TEST(Roster, AnIdWithSeparatorsIsFoundAsAWhole) {
  const std::vector<Student> roster = parse_roster("id\nada\nada-l\nb.c_d\n", "roster.csv");
  const auto owner = [&](const std::string& name) { return owner_of(record_of(name, {}), roster); };
  EXPECT_EQ(owner("lab3-ada-l"), "ada-l") << "ada is a part of it";
  EXPECT_EQ(owner("lab3-ada"), "ada");
  EXPECT_EQ(owner("lab3-ada-lovelace"), "ada");
  EXPECT_EQ(owner("lab3_B.C_D"), "b.c_d");
  EXPECT_EQ(owner("lab3-adam"), "lab3-adam");
  EXPECT_EQ(owner("ada-l and ada"), "ada-l and ada") << "it fits two students";
}

TEST(Roster, InAFolderThatIsNobodysTheNameOfTheFileCounts) {
  const std::vector<Student> roster =
      parse_roster("id,name\ns0101,Ada Lovelace\nb.c,\ns3,Eve\n", "roster.csv");
  const auto owner = [&](const std::string& folder, const std::string& file) {
    Record record = record_of(folder, {});
    record.source = file;
    record.claimed_student = "s3";
    return owner_of(record, roster);
  };
  EXPECT_EQ(owner("sectionA", "s0101.zip"), "s0101");
  EXPECT_EQ(owner("sectionA", "Ada Lovelace_123.tar.gz"), "s0101");
  EXPECT_EQ(owner("sectionA", "b.c"), "b.c") << "a folder";
  EXPECT_EQ(owner("sectionA", "lab3.zip"), "s3") << "the claim";
  EXPECT_EQ(owner("s0101", "b.c.zip"), "s0101") << "the folder is somebody's";
  Record both = record_of("sectionA", {});
  both.source = "s0101_s3.zip";
  EXPECT_EQ(rivals(roster, both), (std::vector<std::string>{"s0101", "s3"}));
}

TEST(Roster, OfSeveralFoldersTheFirstThatIsSomebodysCounts) {
  const std::vector<Student> roster =
      parse_roster("id,name\ns0101,Ada Lovelace\ns0102,\ns3,Eve\n", "roster.csv");
  const auto owner = [&](const std::vector<std::string>& folders) {
    Record record = record_of(folders.front(), {});
    record.folders = folders;
    record.source = "s3.zip";
    record.claimed_student = "s3";
    return owner_of(record, roster);
  };
  EXPECT_EQ(owner({"sectionA", "s0101"}), "s0101");
  EXPECT_EQ(owner({"sectionA", "week3", "Ada Lovelace_123_assignsubmission_file_"}), "s0101");
  EXPECT_EQ(owner({"s0101", "s0102"}), "s0101");
  EXPECT_EQ(owner({"sectionA", "mallory"}), "s3") << "the name of the file";
  Record both = record_of("sectionA", {});
  both.folders = {"sectionA", "s0101 s0102"};
  both.source = "s3.zip";
  EXPECT_EQ(rivals(roster, both), (std::vector<std::string>{"s0101", "s0102"}));
  EXPECT_EQ(owner_of(both, roster), "sectionA");
}

TEST(Roster, AnIdentityFromAPlatformIsFinal) {
  const std::vector<Student> roster =
      parse_roster("id,name,email\ns1,Ada Lovelace,ada@x.org\n", "roster.csv");
  const auto owner = [&](const std::string& student) {
    Record record = record_of(student, {});
    record.is_identified = true;
    record.source = "s1-lab3.zip";
    record.claimed_student = "s1";
    return owner_of(record, roster);
  };
  EXPECT_EQ(owner("ADA@x.org"), "s1");
  EXPECT_EQ(owner("Ada Lovelace"), "s1");
  for (const char* other : {"eve@x.org", "s1@y.org", "ada.lovelace@y.org"}) {
    EXPECT_EQ(owner(other), other);
  }
}

TEST(Roster, ANameThatFitsSeveralStudentsIsNobodys) {
  const std::string text = "id,name\ns1,Mallory Mal\ns2,Ada Lovelace\ns3,Ada Byron\n";
  const std::vector<Student> roster = parse_roster(text, "roster.csv");
  const auto student_of = [&](const std::string& name, const std::string& claimed = "") {
    Record record = record_of(name, lab_record(24, 24, 12));
    record.claimed_student = claimed;
    return owner_of(record, roster);
  };
  const std::string uploaded = "Mallory Mal_123_assignsubmission_file_s2";
  EXPECT_EQ(student_of(uploaded), uploaded) << "the name of an uploaded file is no identity";
  EXPECT_EQ(rivals(roster, record_of(uploaded, {})), (std::vector<std::string>{"s1", "s2"}));
  const std::string both = "Ada Byron Lovelace_124_assignsubmission_file_";
  EXPECT_EQ(student_of(both, "s2"), both) << "a claim does not decide between students";
  EXPECT_EQ(student_of("Mallory Mal_123_assignsubmission_file_s1"), "s1");
  EXPECT_EQ(student_of("lab3", "s2"), "s2");
  EXPECT_EQ(student_of("Ada Lovelace"), "s2");
}

TEST(Roster, SpacesAroundFieldsDoNotCount) {
  const std::vector<Student> roster =
      parse_roster("id, name , email\ns1, Ada Lovelace , ada@x.org\n", "roster.csv");
  ASSERT_EQ(roster.size(), 1U);
  EXPECT_EQ(roster[0].name, "Ada Lovelace");
  EXPECT_EQ(roster[0].email, "ada@x.org");
}

TEST(Roster, BadOnesAreRefused) {
  const auto fault = [](const std::string& text) {
    try {
      parse_roster(text, "roster.csv");
      return std::string();
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(fault("").find("no column id"), std::string::npos);
  EXPECT_NE(fault("name\nAda").find("no column id"), std::string::npos);
  EXPECT_NE(fault("id\na\nA").find("twice"), std::string::npos);
  EXPECT_NE(fault("id,name\n,Ada").find("row 2 has no id"), std::string::npos);
  EXPECT_NE(fault("id,name\n").find("no students"), std::string::npos);
  EXPECT_NE(fault("id,submitted\nada,soon").find("found soon"), std::string::npos);
  EXPECT_EQ(fault("id;name\nada;Ada\n"), "");
  // The first swallows the students after it to the end of the file, the second those up to the next quote.
  EXPECT_EQ(fault("id,name\na,Ada\nb,\"Bob\nc,Eve\n").find("roster.csv:3: a quote"), 0U);
  EXPECT_EQ(fault("id,name\na,\"Ada\nb,\"Bob\"\nc,Eve\n").find("roster.csv:2: a quote"), 0U);
  // Two quotes inside of fields would swallow the students between them.
  const std::string stray = "id,name,email\ns1,Ada 5\",a@x\ns2,Bob,b@x\ns3,Eve 6\",e@x\n";
  EXPECT_EQ(fault(stray).find("roster.csv:2: a quote inside of a field"), 0U) << fault(stray);
  EXPECT_EQ(fault("id,name\na,\"Ada\" B\n").find("roster.csv:2: text follows a quote"), 0U);
}

TEST(CsvTable, QuotedFieldsAreRead) {
  EXPECT_EQ(parse_csv("a,b\r\n\"1,\"\"2\"\"\n3\",4\n\n", "a.csv"),
            (std::vector<std::vector<std::string>>{{"a", "b"}, {"1,\"2\"\n3", "4"}}));
  EXPECT_EQ(parse_csv("\"a\", \"b, c\" \r\n\"\",d", "a.csv"),
            (std::vector<std::vector<std::string>>{{"a", " b, c "}, {"", "d"}}))
      << "spaces around quotes";
}

}  // namespace
}  // namespace cs550::gradebook
