// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/overlay/trace_csv.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/temporary_folder.h"

namespace meristem::trace_csv_test {

TEST(PointsCsv, IsNoEmptyTableOfAGrowthThatWasNotRecorded) {
  const TemporaryFolder folder;
  Progress progress;
  EXPECT_THROW(write_points_csv(GrowthTraces(), folder / "a.csv", progress), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
  GrowthTraces traces;
  traces.recorded = {TracePart::points};  // for a document without such plants
  write_points_csv(traces, folder / "a.csv", progress);
  EXPECT_TRUE(std::filesystem::exists(folder / "a.csv"));
}

}  // namespace meristem::trace_csv_test
