// SPDX-License-Identifier: Apache-2.0
// Fuzzes plans of data sets, rows of manifests, and fields of lines. A valid plan must describe all of its plants, and
// its rows must be readable. Everything else must be an error in the plan or its document.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/manifest.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

constexpr const char* kDocument = R"({"meristem": 1, "variables": {"tall": {"value": 1, "min": 0.5, "max": 2}},
  "components": {"rod": {"type": "simple", "shape": "box", "size": [0.1, "tall", 0.1]}}})";

void check_plan(const DatasetPlan& plan) {
  require(plan.count() >= 1 && plan.count() <= kMaxPlants);
  const std::string header = manifest_header(plan);
  const auto layout = ManifestLayout::of_header(std::string_view(header).substr(0, header.size() - 1));
  for (const std::uint64_t number : {std::uint64_t{0}, plan.count() / 2, plan.count() - 1}) {
    const PlannedPlant plant = plan.plant(number);
    require(plant.document < plan.documents.size());
    const std::string row = manifest_row(plan, {.plant = plant, .files = {}, .measures = {}, .error = "why"});
    require(std::count(row.begin(), row.end(), '\n') == 1);
    // Columns of the plan may have names of the manifest's columns. Their values then get other names.
    require(layout.has_value());
    const auto entry = layout->entry(std::string_view(row).substr(0, row.size() - 1));
    require(entry && entry->number == number && !entry->error.empty());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    check_plan(read_dataset_plan(text, "plan.json", builtin_components(),
                                 {.documents = {{.name = "rod", .text = kDocument, .file = "rod.json", .set = {}}}}));
  } catch (const InputError& error) {
    require(!error.diagnostics().empty());
  }
  if (const auto layout = ManifestLayout::of_header(text)) layout->entry(text);
  if (const auto fields = csv_fields(text)) require(!fields->empty());
  return 0;
}
