// SPDX-License-Identifier: Apache-2.0
#include "export_job.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"

namespace meristem::studio::export_job_test {

constexpr const char* kTree = R"({"meristem": 1, "components": {"tree": {"type": "colonize", "points": 30,
  "crown": {"ellipsoid": {"centre": [0, 1, 0], "radii": [0.5, 0.5, 0.5]}}, "iterations": 3}}})";

TEST(ExportJob, RecordsTheGrowthForTablesThatTellOfIt) {
  const auto document = std::make_shared<const Document>(read_document(kTree, "tree.json", builtin_components()));
  Progress progress;
  for (const bool is_recorded : {false, true}) {
    const GrowthView view{{}, is_recorded ? TraceRequest{TracePart::points} : TraceRequest{}};
    GrownDocument grown = grow_document(*document, progress, {.up_to = GrownPart::plant, .view = view});
    auto shown = std::make_shared<GrownPlant>();
    shown->request.document = document;
    shown->view = view;
    shown->plant = std::move(grown.plant);
    shown->traces = std::move(grown.traces);
    for (const std::shared_ptr<const GrownPlant>& there : {std::shared_ptr<const GrownPlant>(shown), {}}) {
      Downloads downloads;
      ExportOptions options;
      options.format = ".points.csv";
      export_file({.document = document, .text = kTree, .name = "tree", .grown = there}, options, downloads, progress);
      std::ifstream file(*downloads.find(1, "tree.points.csv"));
      EXPECT_EQ(std::count(std::istreambuf_iterator<char>(file), {}, '\n'), 31);
    }
  }
}

}  // namespace meristem::studio::export_job_test
