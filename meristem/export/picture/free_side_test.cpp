// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/free_side.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/export/picture/truth.h"
#include "meristem/output/picture/still.h"

namespace meristem::free_side_test {

/// Returns a ball of 2 m on the ground, and boxes given by their corners.
Document ball_among(const std::string& boxes) {
  return read_document(fmt::format(R"({{"meristem": 1, "components": {{
      "ball": {{"type": "simple", "shape": "sphere", "size": [2, 2, 2], "frame": {{"translate": [0, 1, 0]}}}}}},
      "scene": {{"obstacles": [{}]}}}})",
                                   boxes),
                       "test.json", builtin_components());
}

/// Returns the visible share of the ball's pixels among the obstacles, relative to a picture without obstacles.
double seen_share(const Document& document) {
  Progress progress;
  const GrownDocument grown = grow_document(document, progress);
  const auto pixels = [&](const Scene& scene) {
    const TruthOptions size{.width = 100, .height = 100};
    const PictureTruth truth = see_truth(grown, document.graph.limits, scene, CameraView(), size, progress);
    const auto& number = truth.mask(TruthLevel::organ).number;
    return static_cast<double>(number.size()) - static_cast<double>(std::ranges::count(number, 0U));
  };
  return pixels(document.scene) / pixels(Scene());
}

// North is -z, east +x. The camera stands in the south-south-east if possible.
constexpr const char* kSouth = R"({"box": [[-20, 0, 3], [20, 15, 6]]})";
constexpr const char* kEast = R"({"box": [[3, 0, -20], [6, 15, 20]]})";
constexpr const char* kNorth = R"({"box": [[-20, 0, -6], [20, 15, -3]]})";
constexpr const char* kWest = R"({"box": [[-6, 0, -20], [-3, 15, 20]]})";

TEST(FreeSide, PlantsAreSeenPastAWallOnAnySide) {
  for (const char* wall : {kSouth, kEast, kNorth, kWest}) EXPECT_GT(seen_share(ball_among(wall)), 0.5) << wall;
}

TEST(FreeSide, PlantsAreSeenInACorner) {
  EXPECT_GT(seen_share(ball_among(fmt::format("{}, {}", kSouth, kEast))), 0.5);
  EXPECT_GT(seen_share(ball_among(fmt::format("{}, {}, {}", kSouth, kEast, kNorth))), 0.5);
}

TEST(FreeSide, PlantsAreSeenFromAboveInAYard) {
  EXPECT_GT(seen_share(ball_among(fmt::format("{}, {}, {}, {}", kSouth, kEast, kNorth, kWest))), 0.25);
}

CameraView chosen(const Document& document, const CameraView& view) {
  Progress progress;
  const GrownDocument grown = grow_document(document, progress);
  return view_past_obstacles(grown.meshes, document.scene.obstacles, view, 1, progress);
}

TEST(FreeSide, TheUsualSideStaysWhereItIsFree) {
  for (const char* wall : {kNorth, kWest})
    EXPECT_EQ(chosen(ball_among(wall), CameraView()).azimuth, CameraView().azimuth) << wall;
  EXPECT_EQ(chosen(ball_among(R"({"box": [[-20, 0, 3], [20, 15, 6]], "hidden": true})"), CameraView()).azimuth,
            CameraView().azimuth);
}

TEST(FreeSide, ASideThatAUserHasChosenStays) {
  CameraView view;
  view.azimuth = kPi;
  EXPECT_EQ(chosen(ball_among(kSouth), view).azimuth, kPi);
  CameraView looking;
  looking.target = Vec3(0, 1, 0);
  EXPECT_EQ(chosen(ball_among(kSouth), looking).azimuth, CameraView().azimuth);
}

}  // namespace meristem::free_side_test
