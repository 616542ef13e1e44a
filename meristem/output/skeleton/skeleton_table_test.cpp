// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/skeleton/skeleton_table.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/sample_plants.h"

namespace meristem::skeleton_table_test {

std::vector<double> column(const SkeletonTable& table, const std::string& name) {
  std::vector<double> values;
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    if (table.columns()[k].name != name) continue;
    table.for_each_row(0, table.row_count(), [&](const SkeletonRow& row) { values.push_back(table.value(row, k)); });
  }
  return values;
}

TEST(SkeletonTable, NamesItsColumnsAsDocumentsDo) {
  const Plant plant = two_stems();
  const SkeletonTable table(plant);
  std::vector<std::string> names;
  for (const SkeletonColumn& column : table.columns()) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"component", "instance", "node", "parent", "x", "y", "z", "radius", "axis",
                                             "order", "birth", "light"}));
  EXPECT_EQ(table.components(), (std::vector<std::string>{"tree", "vine"}));
}

TEST(SkeletonTable, CountsNodesParentsAndAxesThroughAllStems) {
  const Plant plant = two_stems();
  const SkeletonTable table(plant);
  EXPECT_EQ(table.row_count(), 7U);
  EXPECT_EQ(column(table, "component"), (std::vector<double>{0, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(column(table, "instance"), (std::vector<double>{0, 0, 0, 0, 3, 3, 3}));
  EXPECT_EQ(column(table, "node"), (std::vector<double>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(column(table, "parent"), (std::vector<double>{-1, 0, 1, 1, -1, 4, 5}));
  EXPECT_EQ(column(table, "axis"), (std::vector<double>{0, 0, 0, 1, 2, 2, 2}));
  EXPECT_EQ(column(table, "order"), (std::vector<double>{0, 0, 0, 1, 0, 0, 0}));
}

TEST(SkeletonTable, KnowsNotWhatAStemDoesNotHave) {
  const Plant plant = two_stems();
  const std::vector<double> light = column(SkeletonTable(plant), "light");
  ASSERT_EQ(light.size(), 7U);
  EXPECT_EQ(light[1], 0.1F);
  EXPECT_TRUE(std::isnan(light[4]));
}

TEST(SkeletonTable, LabelsAxesWhereMetamersAreNumbered) {
  Plant plant = two_stems();
  EXPECT_TRUE(SkeletonTable(plant).labels().empty());
  plant.stems[0].skeleton.extra["metamer"] = {0, 3, 4, 1};
  const SkeletonTable table(plant);
  EXPECT_EQ(table.labels(), (std::vector<std::string>{"main", "main.3", "main"}));
  EXPECT_EQ(table.columns().back().name, "label");
  EXPECT_EQ(column(table, "label"), (std::vector<double>{0, 0, 0, 1, 2, 2, 2}));
  EXPECT_EQ(column(table, "metamer")[3], 1);
}

TEST(SkeletonTable, AnyPartOfTheRowsIsThatPartOfAll) {
  Plant plant = two_stems();
  plant.stems.insert(plant.stems.begin() + 1, Stem{});  // a stem without nodes
  plant.stems.emplace_back();
  const SkeletonTable table(plant);
  for (std::size_t begin = 0; begin <= 7; ++begin) {
    for (std::size_t end = begin; end <= 7; ++end) {
      std::size_t expected = begin;
      table.for_each_row(begin, end, [&](const SkeletonRow& row) {
        EXPECT_EQ(row.row, expected);
        const SkeletonRow found = table.row(expected++);
        EXPECT_EQ(row.stem, found.stem);
        EXPECT_EQ(row.node, found.node);
      });
      EXPECT_EQ(expected, end);
    }
  }
}

TEST(SkeletonTable, APlantWithoutStemsHasColumnsAndNoRows) {
  const Plant plant;
  const SkeletonTable table(plant);
  EXPECT_EQ(table.row_count(), 0U);
  EXPECT_EQ(table.columns().size(), 11U);
  EXPECT_TRUE(column(table, "x").empty());
}

}  // namespace meristem::skeleton_table_test
