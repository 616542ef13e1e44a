// SPDX-License-Identifier: Apache-2.0
// All readers of placed plants must respect the limits of the document. With limits that exactly suit a garden, all
// outputs succeed. With lower limits, every output is refused before a file appears.
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/export/formats.h"
#include "meristem/export/overlay/overlay.h"
#include "meristem/export/picture/picture.h"
#include "meristem/measure/measures.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/measure/surface_labels.h"
#include "meristem/output/skeleton/organ_csv.h"
#include "meristem/plant/plant_variant.h"
#include "tests/support/temporary_folder.h"

namespace meristem::document_limits_test {

constexpr const char* kTwig = R"({"meristem": 1, "components": {
  "stem": {"type": "tree", "length": 1}, "leaf": {"type": "leaf", "length": 0.1}},
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 4}]})";

constexpr const char* kGarden = R"({"meristem": 1, "components": {
  "field": {"type": "field", "rows": 3, "plants": 5, "spacing": 2, "row_spacing": 2},
  "twig": {"type": "document", "file": "twig.json"}},
  "links": [["field", "twig"]]})";

class DocumentLimits : public testing::Test {
 protected:
  DocumentLimits() {
    write("twig.json", kTwig);
    garden_ = read_document(kGarden, (folder_ / "garden.json").string(), builtin_components());
    grown_ = grow_document(garden_, progress_);
    totals_ = totals_of(grown_.plant);
  }

  /// Returns the garden with these limits, as it has grown.
  Document with_limits(std::uint64_t nodes, std::uint64_t instances) const {
    Document document = garden_;
    document.graph.limits.nodes = nodes;
    document.graph.limits.instances = instances;
    return document;
  }

  /// Expects that `make` succeeds with exactly sufficient limits, and that it is refused if either limit is lowered by
  /// one.
  void expect_limits_kept(const std::string& what, const std::function<void(const Document&)>& make) const {
    SCOPED_TRACE(what);
    EXPECT_NO_THROW(make(with_limits(totals_.nodes, totals_.organs)));
    EXPECT_EQ(limit_named(with_limits(totals_.nodes - 1, totals_.organs), make), "limits.nodes");
    EXPECT_EQ(limit_named(with_limits(totals_.nodes, totals_.organs - 1), make), "limits.instances");
  }

  TemporaryFolder folder_;
  Document garden_;
  Progress progress_;
  GrownDocument grown_;
  PlantTotals totals_;

 private:
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  static std::string limit_named(const Document& document, const std::function<void(const Document&)>& make) {
    try {
      make(document);
    } catch (const InputError& error) {
      const std::string text = error.what();
      for (const char* name : {"limits.nodes", "limits.instances"}) {
        if (text.find(name) != std::string::npos) return name;
      }
      return text;
    }
    return "nothing";
  }
};

TEST_F(DocumentLimits, HoldForTables) {
  for (const FileFormat& format : formats()) {
    // Points come from the record of the growth and not from the plant. Meshes have tests of their own.
    if (format.needs != GrownPart::plant || format.ending == ".points.csv") continue;
    const std::string ending(format.ending);
    const std::string path = (folder_ / ("garden" + ending)).string();
    expect_limits_kept(ending, [&](const Document& document) {
      std::filesystem::remove(path);
      try {
        format.write(document, grown_, path, {}, progress_);
      } catch (const InputError&) {
        EXPECT_FALSE(std::filesystem::exists(path)) << "a refused output leaves no file";
        throw;
      }
      EXPECT_TRUE(std::filesystem::exists(path));
    });
  }
}

TEST_F(DocumentLimits, HoldForNoFormatThatKeepsInstances) {
  for (const std::string ending : {".glb", ".obj"}) {
    const std::string path = (folder_ / ("garden" + ending)).string();
    EXPECT_NO_THROW(format_of(path).write(with_limits(1, 1), grown_, path, {}, progress_)) << ending;
  }
}

TEST_F(DocumentLimits, HoldForMeasures) {
  const MeshScene& meshes = grown_.meshes;
  const Scene& scene = garden_.scene;
  expect_limits_kept("measures", [&](const Document& document) {
    measure_plant(grown_.plant, document.graph.limits, meshes, scene, {}, progress_);
  });
  expect_limits_kept("foliage", [&](const Document& document) {
    EXPECT_EQ(measure_foliage(grown_.plant, document.graph.limits, progress_).leaves, totals_.organs);
  });
  expect_limits_kept("layers", [&](const Document& document) {
    measure_leaf_layers(grown_.plant, document.graph.limits, 0.5, progress_);
  });
  expect_limits_kept("trees of organs", [&](const Document& document) {
    trees_of_organs(grown_.plant, document.graph.limits, progress_);
  });
  std::vector<LitOrgan> lit;
  expect_limits_kept("light on organs", [&](const Document& document) {
    lit = measure_organ_light(grown_.plant, document.graph.limits, meshes, scene, progress_);
  });
  expect_limits_kept("a table of organs", [&](const Document& document) {
    write_organ_csv(grown_.plant, document.graph.limits, lit, (folder_ / "organs.csv").string(), progress_);
  });
}

TEST_F(DocumentLimits, HoldForPicturesThatReadPlants) {
  PictureOptions picture{.still = {.width = 8, .height = 8, .samples = 1}, .view = {}};
  picture.overlays = {OverlayPart::skeleton};
  expect_limits_kept("overlays", [&](const Document& document) {
    take_picture(grown_, document.graph.limits, garden_.scene, picture, progress_);
  });
}

TEST_F(DocumentLimits, HoldForLabelsOfDeformedPlants) {
  Document leaning = read_document(
      R"({"meristem": 1, "components": {
        "wind": {"type": "hyperpatch", "box": [[-9, 0, -9], [9, 2, 9]], "degree": [1, 1, 1], "dx": "x + 0.1*y"},
        "field": {"type": "field", "rows": 3, "plants": 5, "spacing": 2, "row_spacing": 2},
        "twig": {"type": "document", "file": "twig.json"}}, "links": [["wind", "field"], ["field", "twig"]]})",
      (folder_ / "garden.json").string(), builtin_components());
  grown_ = grow_document(leaning, progress_);
  ASSERT_TRUE(has_deformed_plantings(grown_.plant));
  expect_limits_kept("labels", [&](const Document& document) {
    const SurfaceLabels labels(grown_.plant, document.graph.limits, grown_.meshes, progress_);
  });
  expect_limits_kept("scans", [&](const Document& document) {
    const Scanner scanner(grown_.plant, document.graph.limits, grown_.meshes, {}, progress_);
  });
}

}  // namespace meristem::document_limits_test
