// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_range.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/dataset/dataset_in_a_test.h"
#include "meristem/dataset/table_hashes.h"
#include "tests/support/temporary_folder.h"

namespace meristem::plant_range_test {

namespace fs = std::filesystem;

constexpr const char* kRods = R"({"meristem_dataset": 1, "seeds": 8, "rows": 5, "files": [".obj"],
  "measures": ["height"], "vary": {"tall": {"uniform": [0.5, 2]}}})";

/// A begun data set without plants.
class PlantRanges : public testing::Test {
 protected:
  PlantRanges() : plan_(rod_plan(kRods)) {
    Progress progress;
    DatasetFolder(plan_, folder("one"), DatasetOpening::fresh, progress);
    DatasetFolder(plan_, folder("other"), DatasetOpening::fresh, progress);
  }

  std::string folder(const std::string& name) const { return (root_ / name).string(); }
  PlantMaker maker() const {
    return PlantMaker(plan_, builtin_components(), {.documents = folder("one") + "/documents"});
  }

  /// Returns the content of all files of a range below a folder: files of plants, and the rows.
  std::map<std::string, std::string> made_below(const std::string& name, PlantRange range) const {
    std::map<std::string, std::string> files = files_below(root_ / name / "plants");
    files["rows"] = file_content(rows_path(folder(name), range));
    return files;
  }

  TemporaryFolder root_;
  DatasetPlan plan_;
  Progress progress_;
};

TEST_F(PlantRanges, MadeInMemoryAndPutAreAsMadeInTheFolder) {
  const PlantRange range{2, 4};
  PlantMaker here = maker(), there = maker();
  make_range(here, plan_, range, folder("one"), progress_);
  const MadeRange made = make_range_apart(there, plan_, range, folder("scratch"), progress_);
  EXPECT_TRUE(fs::is_empty(root_ / "scratch")) << "nothing is left of what was on its way";
  put_range(made, plan_, folder("other"));
  const auto files = made_below("one", range);
  EXPECT_EQ(files.size(), 2 * 2 + 1U) << "shapes, their materials, and the rows";
  EXPECT_EQ(made_below("other", range), files);
  EXPECT_TRUE(fs::is_empty(root_ / "one/partial/plants"));
}

TEST_F(PlantRanges, MadeTwiceAreTheSame) {
  const PlantRange range{0, 3};
  PlantMaker one = maker();
  make_range(one, plan_, range, folder("one"), progress_);
  const auto files = made_below("one", range);
  make_range(one, plan_, range, folder("one"), progress_);
  EXPECT_EQ(made_below("one", range), files);
}

TEST_F(PlantRanges, RowsEndWithTheirHash) {
  const PlantRange range{5, 7};
  PlantMaker one = maker();
  make_range(one, plan_, range, folder("one"), progress_);
  EXPECT_EQ(fs::path(rows_path("", range)).filename(), "0000000005-0000000007.csv");
  const std::string rows = file_content(rows_path(folder("one"), range));
  std::string_view text = rows;
  bool is_right = false;
  ASSERT_TRUE(take_end_line(text, is_right));
  EXPECT_TRUE(is_right);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2) << "names of columns, and a row for each plant";
}

TEST_F(PlantRanges, PartsBelongToTheTableOfTheirFirstPlant) {
  DatasetInfo info;
  info.plants = 8;
  info.rows = 5;
  fs::create_directories(root_ / "one/partial/rows");
  for (const PlantRange range : {PlantRange{3, 5}, {0, 3}, {5, 6}, {8, 9}}) {
    write_content(rows_path(folder("one"), range), "");
  }
  write_content(root_ / "one/partial/rows/notes.txt", "");
  const auto parts = row_parts(info, folder("one"));
  ASSERT_EQ(parts.size(), 2U) << "the plan has no plant 8";
  EXPECT_EQ(parts.at(0),
            (std::vector<std::string>{rows_path(folder("one"), {0, 3}), rows_path(folder("one"), {3, 5})}));
  EXPECT_EQ(parts.at(1), (std::vector<std::string>{rows_path(folder("one"), {5, 6})}));
  EXPECT_TRUE(row_parts(info, folder("none")).empty());
}

TEST_F(PlantRanges, AMachineSeesAFolderOfThisPlanOnly) {
  EXPECT_TRUE(sees_dataset(plan_, folder("one")));
  EXPECT_FALSE(sees_dataset(plan_, folder("none")));
  EXPECT_FALSE(sees_dataset(rod_plan(R"({"meristem_dataset": 1, "seeds": 9, "files": [".obj"]})"), folder("one")));
  write_content(root_ / "other/dataset.json", "{");
  EXPECT_FALSE(sees_dataset(plan_, folder("other")));
}

TEST_F(PlantRanges, ACancelledRangeLeavesNoRows) {
  PlantMaker one = maker();
  progress_.cancel();
  EXPECT_THROW(make_range(one, plan_, {0, 2}, folder("one"), progress_), Cancelled);
  EXPECT_FALSE(fs::exists(rows_path(folder("one"), {0, 2})));
  EXPECT_TRUE(fs::is_empty(root_ / "one/partial/plants"));
}

}  // namespace meristem::plant_range_test
