// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/overlay/overlay.h"

#include <array>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/export/overlay/overlay_meshes.h"
#include "meristem/export/overlay/overlay_text.h"
#include "meristem/plant/plant_variant.h"
#include "tests/support/build_graph.h"
#include "tests/support/temporary_folder.h"

namespace meristem::overlay_test {

constexpr const char* kTree = R"j({
  "meristem": 1, "seed": 4,
  "scene": {"sun": {"azimuth": 180, "altitude": 40}, "obstacles": [{"box": [[-1, 0, 0.8], [1, 1.5, 1.2]]}]},
  "components": {"tree": {
    "type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1.2, 0], "radii": [0.6, 0.7, 0.9]}},
    "points": 80, "step": 0.08, "influence": 0.8, "kill": 0.17
  }}
})j";

constexpr const char* kMarkers = R"j({
  "meristem": 1, "seed": 2,
  "components": {"tree": {"type": "organize", "iterations": 7, "length": 0.1, "light": {"model": "markers"}}}
})j";

constexpr const char* kOrganized = R"j({
  "meristem": 1, "seed": 2,
  "components": {"tree": {"type": "organize", "iterations": 9, "length": 0.1, "shedding": {"below": 0.3, "after": 2}}}
})j";

struct Shown {
  GrownDocument grown;
  std::vector<OverlayLayer> layers;
};

Shown show(const char* text, const std::string& names, std::optional<int> step = {}) {
  const Document document = read_document(text, "test.json", builtin_components(), {});
  const std::vector<OverlayPart> parts = overlay_parts_named(names, "--show");
  Progress progress;
  Shown shown{
      grow_document(document, progress, {.up_to = GrownPart::meshes, .view = {step, request_for_overlays(parts)}}), {}};
  const OverlaySource source{shown.grown.plant, shown.grown.traces, document.scene, document.graph.limits,
                             shown.grown.meshes.bounds()};
  shown.layers = overlay_layers(source, parts, progress);
  return shown;
}

TEST(Overlay, NamesArePartsInTheirOrderAndOthersAreRefused) {
  for (const OverlayPartInfo& info : overlay_parts()) {
    EXPECT_EQ(overlay_parts_named(info.name, "--show"), (std::vector{info.part}));
    EXPECT_EQ(overlay_part(info.part).name, info.name);
  }
  EXPECT_EQ(overlay_parts_named("sun,points", "--show"), (std::vector{OverlayPart::sun, OverlayPart::points}));
  try {
    overlay_parts_named("points,skeletton", "--show");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].nearest, "skeleton");
  }
}

TEST(Overlay, PointsAreColouredByWhatTheyAreAtTheStep) {
  const Shown early = show(kTree, "points", 4);
  const Shown late = show(kTree, "points");
  ASSERT_EQ(early.layers[0].points.size(), 80U);
  EXPECT_EQ(late.layers[0].points.size(), 80U);
  EXPECT_EQ(early.layers[0].legend.size(), 2U) << "left and used up; none are removed before growth";
  EXPECT_NE(early.layers[0].legend[0].text, late.layers[0].legend[0].text);
  EXPECT_TRUE(early.layers[0].legend[0].text.ends_with("points left")) << early.layers[0].legend[0].text;
}

TEST(Overlay, SkeletonHasALineForEachSegmentAndAPointForEachNode) {
  const Shown shown = show(kTree, "skeleton");
  const std::size_t nodes = shown.grown.plant.node_count();
  EXPECT_EQ(shown.layers[0].points.size(), nodes);
  EXPECT_EQ(shown.layers[0].lines.size(), nodes - 1);
}

TEST(Overlay, WaysLeadFromTheShadeAndLightIsLessThere) {
  const Shown shown = show(kTree, "ways,light");
  ASSERT_FALSE(shown.layers[0].arrows.empty());
  for (const OverlayLine& arrow : shown.layers[0].arrows) EXPECT_NE(arrow.from, arrow.to);
  EXPECT_EQ(shown.layers[1].points.size(), shown.grown.plant.node_count());
  EXPECT_EQ(shown.layers[1].legend.size(), 3U);
}

TEST(Overlay, BudsOfOrganizedTreesHaveTheirLight) {
  const Shown shown = show(kOrganized, "light,resource,losses,ways,hull");
  EXPECT_GT(shown.layers[0].points.size(), 10U);
  EXPECT_EQ(shown.layers[1].lines.size(), shown.grown.plant.node_count() - 1);
  EXPECT_FALSE(shown.layers[4].lines.empty());
}

TEST(Overlay, WaysOfBudsThatLookForRoomSaySoWithoutTheirMarkers) {
  const Shown shown = show(kMarkers, "ways");
  ASSERT_EQ(shown.layers[0].legend.size(), 1U);
  EXPECT_EQ(shown.layers[0].legend[0].text, "ways to more room");
  EXPECT_TRUE(show(kMarkers, "ways", 0).layers[0].arrows.empty()) << "no bud has grown before the first step";
}

TEST(Overlay, PlantsWithoutBudsHaveWaysBesideThoseWithSome) {
  const Shown shown = show(R"j({
    "meristem": 1, "seed": 4, "scene": {"obstacles": [{"box": [[-1, 0, 0.8], [1, 1.5, 1.2]]}]},
    "components": {
      "field": {"type": "world"},
      "bush": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1.2, 0], "radii": [0.6, 0.7, 0.9]}},
               "points": 80, "step": 0.08, "influence": 0.8, "kill": 0.17},
      "tree": {"type": "organize", "iterations": 5, "length": 0.1, "light": {"model": "markers"},
               "frame": {"translate": [4, 0, 0]}}
    },
    "links": [["field", "bush"], ["field", "tree"]]
  })j",
                           "ways");
  std::array<std::size_t, 2> arrows{};
  for (const OverlayLine& arrow : shown.layers[0].arrows) ++arrows[arrow.from.x < 2 ? 0 : 1];
  EXPECT_GT(arrows[0], 10U);
  EXPECT_GT(arrows[1], 0U);
  EXPECT_EQ(shown.layers[0].legend.size(), 2U) << "to light and to room";
}

TEST(Overlay, ShortStemsHaveTheirShareOfTheWays) {
  const Shown shown = show(R"j({
    "meristem": 1, "scene": {"obstacles": [{"box": [[-30, 2, -30], [30, 3, 0.1]]}]},
    "components": {
      "row": {"type": "field", "rows": 1, "plants": 60, "spacing": 0.15},
      "stem": {"type": "tree", "length": 0.2, "radius": 0.01}
    },
    "links": [["row", "stem"]]
  })j",
                           "ways");
  EXPECT_GT(shown.layers[0].arrows.size(), 40U);
}

TEST(Overlay, PlantsOfOtherDocumentsAreShownAsWell) {
  const TemporaryFolder folder;
  std::ofstream(folder / "tree.json") << kOrganized;
  const Document document = read_document(R"j({
    "meristem": 1, "components": {
      "row": {"type": "field", "rows": 1, "plants": 3, "spacing": 4},
      "tree": {"type": "document", "file": "tree.json", "seed": 1}
    },
    "links": [["row", "tree"]]
  })j",
                                          (folder / "row.json").string(), builtin_components(), {});
  Progress progress;
  const GrownDocument grown = grow_document(document, progress, {.up_to = GrownPart::meshes});
  const OverlaySource source{grown.plant, grown.traces, document.scene, document.graph.limits, grown.meshes.bounds()};
  const std::vector<OverlayPart> parts = overlay_parts_named("skeleton,light,resource,hull", "--show");
  const std::vector<OverlayLayer> layers = overlay_layers(source, parts, progress);
  EXPECT_EQ(layers[0].points.size(), totals_of(grown.plant).nodes);
  for (const OverlayLayer& layer : layers) EXPECT_FALSE(layer.legend.empty());
}

TEST(Overlay, SunCompassAndScaleStandAboutThePlant) {
  const Shown shown = show(kTree, "sun,compass,scale");
  for (const OverlayLine& arrow : shown.layers[0].arrows) {
    EXPECT_NEAR(arrow.from.y - arrow.to.y, glm::distance(arrow.from, arrow.to) * 0.6428F, 1e-4F) << "sin of 40 degrees";
    EXPECT_GT(arrow.from.z, arrow.to.z) << "from the south";
  }
  EXPECT_EQ(shown.layers[1].labels.size(), 4U);
  ASSERT_EQ(shown.layers[2].labels.size(), 1U);
  EXPECT_EQ(shown.layers[2].labels[0].text, "50 cm");
  EXPECT_NEAR(glm::distance(shown.layers[2].lines[0].from, shown.layers[2].lines[0].to), 0.5, 1e-5);
  EXPECT_TRUE(overlay_bounds(shown.layers).is_empty()) << "they are none of the plant's";
}

TEST(Overlay, BoxesAndCellsOfBlendedStems) {
  const Shown shown = show(R"j({"meristem": 1, "components": {"stem": {
    "type": "tree", "length": 1, "radius": 0.1, "surface": {"style": "blend", "resolution": 50}}}})j",
                           "box");
  ASSERT_EQ(shown.layers[0].lines.size(), 24U) << "the box and a cell";
  Box box;
  for (const OverlayLine& line : shown.layers[0].lines) {
    box.add(line.from);
    box.add(line.to);
  }
  const Box made = shown.grown.meshes.bounds();
  const OverlayLine& cell = shown.layers[0].lines.back();
  const float side = glm::distance(cell.from, cell.to);
  EXPECT_NEAR(side, 1.0F / 50, 0.01F);
  EXPECT_NEAR(box.low.x, made.low.x, side) << "of the stem, not of its axis";
  EXPECT_NEAR(box.high.x, made.high.x, side);
  EXPECT_LE(box.low.y, made.low.y) << "solids have round ends below the base, which is flat";
  EXPECT_NEAR(box.high.y, made.high.y, side);
  EXPECT_TRUE(show(kTree, "box").layers[0].lines.empty());
}

TEST(Overlay, BecomesMeshesOfOneMaterialBehindThePlants) {
  const Shown shown = show(kTree, "points,skeleton,sun");
  const MeshScene all = with_overlays(shown.grown.meshes, shown.layers, 2);
  ASSERT_EQ(all.meshes.size(), shown.grown.meshes.meshes.size() + 3) << "balls, rods, heads of arrows";
  EXPECT_EQ(all.meshes[0].mesh, shown.grown.meshes.meshes[0].mesh) << "shared";
  const MeshInstances& balls = all.meshes[shown.grown.meshes.meshes.size()];
  EXPECT_EQ(balls.frames.size(), 80 + shown.grown.plant.node_count());
  EXPECT_EQ(balls.tints.size(), balls.frames.size());
}

TEST(Overlay, TextIsWrittenWhereItIsSeen) {
  OverlayLayer layer;
  layer.labels.push_back({Vec3(0), "N"});
  Image image{64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 200)};
  const Image before = image;
  write_overlay_text(image, std::span(&layer, 1), [](Vec3) { return std::optional<Vec2>(); });
  EXPECT_EQ(image.rgba, before.rgba) << "behind the camera";
  write_overlay_text(image, std::span(&layer, 1), [](Vec3) { return std::optional(Vec2(0)); });
  EXPECT_NE(image.rgba, before.rgba);
  const auto dark = [&](int x, int y) { return image.pixel(x, y)[0] < 60; };
  int inside = 0, elsewhere = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool is_near = std::abs(x - 32) <= 4 && std::abs(y - 32) <= 5;
      (is_near ? inside : elsewhere) += dark(x, y) ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 10);
  EXPECT_EQ(elsewhere, 0);
}

}  // namespace meristem::overlay_test
