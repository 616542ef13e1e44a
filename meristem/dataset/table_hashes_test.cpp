// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/table_hashes.h"

#include <set>

#include <gtest/gtest.h>

#include "meristem/dataset/dataset_in_a_test.h"
#include "tests/support/temporary_folder.h"

namespace meristem::table_hashes_test {

constexpr const char* kTable = "key,tall,note\n000000,1.5,\n000001,2,\"a, b\"\n";

DatasetInfo info_of_rods() {
  DatasetInfo info;
  info.plan = "0123";
  info.documents.push_back({.name = "rod, red", .document = "rod.json", .hash = "4567"});
  return info;
}

void write_hashes(const TemporaryFolder& folder, const std::string& text) {
  std::filesystem::create_directories(
      std::filesystem::path(table_hashes_path(folder.path().string(), 7)).parent_path());
  write_content(table_hashes_path(folder.path().string(), 7), text);
}

TEST(TableHashes, LinesAreTakenOneByOne) {
  std::string_view text = "first\n\nlast";
  EXPECT_EQ(take_line(text), "first");
  EXPECT_EQ(take_line(text), "");
  EXPECT_EQ(take_line(text), "last") << "a last line needs no end";
  EXPECT_TRUE(text.empty());
  EXPECT_EQ(take_line(text), "");
}

TEST(TableHashes, TheEndLineTellsWhetherTheRestIsAsItWas) {
  const std::string whole = with_end_line("a,b\n1,2\n");
  std::string_view text = whole;
  bool is_right = false;
  ASSERT_TRUE(take_end_line(text, is_right));
  EXPECT_TRUE(is_right);
  EXPECT_EQ(text, "a,b\n1,2\n");

  std::string changed = whole;
  changed[4] = '3';
  text = changed;
  ASSERT_TRUE(take_end_line(text, is_right));
  EXPECT_FALSE(is_right);
  EXPECT_EQ(text, "a,b\n3,2\n");
}

TEST(TableHashes, ATextWithoutItsEndLineIsLeftAsItIs) {
  const std::string whole = with_end_line("a\n");
  for (const std::string& cut : {std::string("a\n"), std::string(), whole.substr(0, whole.size() - 1)}) {
    std::string_view text = cut;
    bool is_right = false;
    EXPECT_FALSE(take_end_line(text, is_right)) << cut;
    EXPECT_EQ(text, cut);
  }
}

TEST(TableHashes, OfTextsHave32DigitsAndDifferByOneByte) {
  EXPECT_EQ(text_hash("").size(), 32U);
  EXPECT_EQ(text_hash("abc").find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(std::set<std::string>({text_hash(""), text_hash("a"), text_hash("b"), text_hash("ab")}).size(), 4U);
  EXPECT_NE(row_hash("1,2"), row_hash("1,3"));
}

TEST(TableHashes, AChangedFieldChangesTheHashesOfItsRowAndColumnAlone) {
  const TableHashes before = hashes_of_table(info_of_rods(), kTable);
  std::string table = kTable;
  table.replace(table.find("1.5"), 3, "1.6");
  const TableHashes after = hashes_of_table(info_of_rods(), table);
  ASSERT_EQ(after.rows.size(), 2U);
  ASSERT_EQ(after.columns.size(), 3U);
  EXPECT_EQ(after.columns[1].first, "tall");
  EXPECT_NE(after.table, before.table);
  EXPECT_NE(after.rows[0], before.rows[0]);
  EXPECT_EQ(after.rows[1], before.rows[1]);
  EXPECT_EQ(after.columns[0], before.columns[0]);
  EXPECT_NE(after.columns[1], before.columns[1]);
  EXPECT_EQ(after.columns[2], before.columns[2]);
}

TEST(TableHashes, OfColumnsTellEmptyFieldsFromRowsThatAreGone) {
  const std::vector<std::string_view> rows{"1,2", "3,4"};
  EXPECT_EQ(column_hashes({"1,2", "\"3,4"}, 2), column_hashes({"1,2", ","}, 2)) << "what is no row has empty fields";
  EXPECT_NE(column_hashes(rows, 2), column_hashes({"1,2"}, 2));
  EXPECT_NE(column_hashes(rows, 2), column_hashes({"3,4", "1,2"}, 2)) << "the order counts";
  EXPECT_EQ(column_hashes({"1,2,3"}, 2), column_hashes({"1,2"}, 2));
}

TEST(TableHashes, ComeBackFromTheirFile) {
  const TemporaryFolder folder;
  const TableHashes written = hashes_of_table(info_of_rods(), kTable);
  write_hashes(folder, table_hashes_text(written));
  const auto read = read_table_hashes(folder.path().string(), 7);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->plan, "0123");
  EXPECT_EQ(read->documents, (std::vector<std::pair<std::string, std::string>>{{"rod, red", "4567"}}));
  EXPECT_EQ(read->table, written.table);
  EXPECT_EQ(read->columns, written.columns);
  EXPECT_EQ(read->rows, written.rows);
}

TEST(TableHashes, AreNotReadFromAMissingOrChangedFile) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_table_hashes(folder.path().string(), 7));
  const std::string text = table_hashes_text(hashes_of_table(info_of_rods(), kTable));
  std::string changed = text;
  changed[changed.find("0123")] = '9';
  for (const std::string& wrong :
       {changed, text.substr(0, text.size() / 2), with_end_line("kind,name,hash\nrow,1\n")}) {
    write_hashes(folder, wrong);
    EXPECT_FALSE(read_table_hashes(folder.path().string(), 7)) << wrong;
  }
}

}  // namespace meristem::table_hashes_test
