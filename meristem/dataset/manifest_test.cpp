// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/manifest.h"

#include <gtest/gtest.h>

#include "meristem/base/version.h"
#include "meristem/dataset/dataset_in_a_test.h"

namespace meristem::manifest_test {

TEST(Manifest, RowsReadBack) {
  const DatasetPlan plan =
      rod_plan(R"({"meristem_dataset": 1, "files": [".csv"], "measures": ["height", "length_by_order"],
    "samples": [{"tall": 1.5, "rod.shape": "box"}]})");
  MadePlant made{.plant = plan.plant(0),
                 .files = {{"plants/0000/000000.csv", 12, "abc"}, {"plants/0000/000000.mtl", 3, "def"}},
                 .measures = {1.25, std::vector<double>{1, 2.5}},
                 .error = {}};
  const std::string header = manifest_header(plan);
  EXPECT_EQ(header, "key,document,seed,tall,rod.shape,files,bytes,hashes,version,error,height,length_by_order\n");
  const std::string row = manifest_row(plan, made);
  EXPECT_EQ(row, "000000,rod,1,1.5,box,plants/0000/000000.csv plants/0000/000000.mtl,12 3,abc def," +
                     std::string(version()) + ",,1.25,1 2.5\n");
  const auto layout = ManifestLayout::of_header(header.substr(0, header.size() - 1));
  ASSERT_TRUE(layout);
  const auto entry = layout->entry(row.substr(0, row.size() - 1));
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->number, 0U);
  EXPECT_EQ(entry->files, made.files);
  EXPECT_TRUE(entry->error.empty());

  made.error = "a \"line\",\nand more";
  made.files.clear();
  made.measures.clear();
  const std::string failed = manifest_row(plan, made);
  EXPECT_EQ(std::count(failed.begin(), failed.end(), '\n'), 1);
  EXPECT_FALSE(layout->entry(failed.substr(0, failed.size() - 1))->error.empty());
}

TEST(Manifest, RefusesWhatIsNoRow) {
  const auto layout = ManifestLayout::of_header("key,files,bytes,hashes,error");
  ASSERT_TRUE(layout);
  EXPECT_TRUE(layout->entry("3,a b,1 2,x y,"));
  EXPECT_FALSE(layout->entry("3,a b,1,x y,")) << "a size is missing";
  EXPECT_FALSE(layout->entry("x,a,1,x,"));
  EXPECT_FALSE(layout->entry("3,a,1,x"));
  EXPECT_FALSE(layout->entry("3,../a,1,x,")) << "a file outside the folder";
  EXPECT_FALSE(layout->entry("3,/etc/a,1,x,"));
  EXPECT_FALSE(ManifestLayout::of_header("key,files,bytes,error"));
}

TEST(Manifest, FieldsMayBeQuoted) {
  EXPECT_EQ(csv_fields(R"(a,"b,""c""",,)"), (std::vector<std::string>{"a", "b,\"c\"", "", ""}));
  EXPECT_FALSE(csv_fields(R"("a)"));
  EXPECT_FALSE(csv_fields(R"("a"b,c)"));
}

TEST(Manifest, CallsAMeasureThatIsAlsoAValueResult) {
  DatasetPlan plan;
  plan.columns = {"height", "seed"};
  plan.measures = {"height"};
  EXPECT_EQ(manifest_columns(plan),
            (std::vector<std::string>{"key", "document", "seed", "height", "value.seed", "files", "bytes", "hashes",
                                      "version", "error", "result.height"}));
}

}  // namespace meristem::manifest_test
