// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/picture/truth.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/whole_file.h"
#include "meristem/components/registry.h"
#include "meristem/document/json.h"
#include "meristem/export/picture/truth_files.h"
#include "meristem/output/picture/still.h"
#include "tests/support/temporary_folder.h"

namespace meristem::truth_test {

/// A ball of 1 m about (0, 1, 0), seen from 10 m north at its own height.
constexpr const char* kBall = R"({"meristem": 1, "components": {
  "view": {"type": "camera", "position": [0, 1, -10], "target": [0, 1, 0], "field_of_view": 20},
  "ball": {"type": "simple", "shape": "sphere", "size": [2, 2, 2], "segments": 128}},
  "links": [["view", "ball"]]})";

/// Two upright shoots beside each other, each with leaves.
constexpr const char* kTwins = R"({"meristem": 1, "seed": 3, "components": {
  "view": {"type": "camera", "azimuth": 0, "altitude": 5},
  "pair": {"type": "places", "line": {"points": [[-0.5, 0], [0.5, 0]], "spacing": 1}},
  "stem": {"type": "tree", "length": 1, "radius": 0.03},
  "leaf": {"type": "leaf", "length": 0.3, "width": 0.15}},
  "links": [["view", "pair"], ["pair", "stem"],
            {"from": "stem", "to": "leaf", "kind": "branch", "density": 6}]})";

struct Seen {
  Document document;
  GrownDocument grown;
  PictureTruth truth;
};

Seen look(const char* text, const CameraView& view, int width, int height, bool transparent = false) {
  Document document = read_document(text, "test.json", builtin_components());
  Progress progress;
  GrownDocument grown = grow_document(document, progress);
  const TruthOptions options{.width = width, .height = height, .transparent = transparent};
  PictureTruth truth = see_truth(grown, document.graph.limits, document.scene, view, options, progress);
  return {std::move(document), std::move(grown), std::move(truth)};
}

CameraView ball_view() {
  CameraView view;
  view.position = Vec3(0, 1, -10);
  view.target = Vec3(0, 1, 0);
  view.field_of_view = radians(20);
  return view;
}

TEST(Truth, HasTheDepthAndNormalsOfABall) {
  const Seen seen = look(kBall, ball_view(), 101, 101);
  const PictureTruth& truth = seen.truth;
  const std::size_t middle = 50 * 101 + 50;
  EXPECT_NEAR(truth.depth[middle], 9, 0.002);
  EXPECT_NEAR(truth.normal[middle].z, 1, 1e-3);
  // Above the middle, the normal leans up and the surface is farther away.
  const std::size_t above = 35 * 101 + 50;
  EXPECT_GT(truth.normal[above].y, 0.3F);
  EXPECT_NEAR(truth.normal[above].x, 0, 0.05);
  EXPECT_GT(truth.depth[above], 9.02F);
  // A ball fills a disc on the film. Its radius is the tangent of half the cone's angle, divided by the tangent of half
  // the view's angle.
  std::size_t pixels = 0;
  for (const std::uint32_t number : truth.mask(TruthLevel::organ).number) pixels += number == 1 ? 1 : 0;
  const double radius = 50.5 * std::tan(std::asin(0.1)) / std::tan(radians(10));
  EXPECT_NEAR(static_cast<double>(pixels), kPi * radius * radius, 0.02 * kPi * radius * radius);
  ASSERT_EQ(truth.mask(TruthLevel::organ).things.size(), 1U);
  EXPECT_EQ(truth.mask(TruthLevel::organ).things[0].component, "ball");
  EXPECT_TRUE(truth.mask(TruthLevel::shoot).things.empty()) << "a ball stands on no shoot";
}

TEST(Truth, SeesSkyAndGroundAsThePictureDoes) {
  const Seen with_ground = look(kBall, ball_view(), 40, 40);
  EXPECT_TRUE(std::isinf(with_ground.truth.depth[0])) << "sky above the horizon";
  const std::size_t below = 39 * 40 + 20;
  EXPECT_TRUE(std::isfinite(with_ground.truth.depth[below])) << "ground";
  EXPECT_EQ(with_ground.truth.mask(TruthLevel::plant).number[below], 0U);
  EXPECT_GT(with_ground.truth.normal[below].y, 0.9F);
  const Seen alone = look(kBall, ball_view(), 40, 40, true);
  EXPECT_TRUE(std::isinf(alone.truth.depth[below]));
  EXPECT_EQ(alone.truth.normal[below], Vec3(0));
}

TEST(Truth, CoversWhatThePictureCovers) {
  const Seen seen = look(kTwins, CameraView(), 64, 48, true);
  Progress progress;
  const Image image = render_still(seen.grown.meshes, seen.document.scene, CameraView(),
                                   {.width = 64, .height = 48, .samples = 16, .transparent = true}, progress);
  int different = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool is_plant = seen.truth.mask(TruthLevel::organ).number[static_cast<std::size_t>(y) * 64 + x] != 0;
      const int alpha = image.pixel(x, y)[3];
      if ((is_plant && alpha < 20) || (!is_plant && alpha > 235)) ++different;
    }
  }
  EXPECT_LE(different, 3);
}

TEST(Truth, TellsOrgansShootsAndPlantsApart) {
  const Seen seen = look(kTwins, CameraView(), 160, 120);
  const TruthMask& organs = seen.truth.mask(TruthLevel::organ);
  const TruthMask& shoots = seen.truth.mask(TruthLevel::shoot);
  const TruthMask& plants = seen.truth.mask(TruthLevel::plant);
  EXPECT_EQ(shoots.things.size(), 2U);
  EXPECT_EQ(plants.things.size(), 2U);
  int leaves = 0;
  int wood = 0;
  for (const SeenThing& thing : organs.things) {
    (thing.is_organ ? leaves : wood) += 1;
    EXPECT_EQ(thing.component, thing.is_organ ? "leaf" : "stem");
    EXPECT_GE(thing.shoot, 1U);
    EXPECT_GE(thing.plant, 1U);
  }
  EXPECT_EQ(wood, 2);
  EXPECT_GE(leaves, 8);
  // Masks are nested: an organ lies on one shoot and in one plant, in all of its pixels.
  for (std::size_t pixel = 0; pixel < organs.number.size(); ++pixel) {
    if (organs.number[pixel] == 0) continue;
    const SeenThing& thing = organs.things[organs.number[pixel] - 1];
    EXPECT_EQ(shoots.number[pixel], thing.shoot);
    EXPECT_EQ(plants.number[pixel], thing.plant);
  }
  // The plant on the left differs from the plant on the right.
  EXPECT_NE(shoots.things[0].plant, shoots.things[1].plant);
}

TEST(Truth, IsTheSameOnAnyNumberOfThreads) {
  const auto with_threads = [](int threads) {
    const ThreadLimit limit(threads);
    return look(kTwins, CameraView(), 80, 60).truth;
  };
  const PictureTruth one = with_threads(1);
  const PictureTruth three = with_threads(3);
  EXPECT_EQ(one.depth, three.depth);
  for (int level = 0; level < kTruthLevels; ++level) EXPECT_EQ(one.masks[level].number, three.masks[level].number);
}

TEST(TruthFiles, WritesRunLengthsAsCocoDoes) {
  // Columns from the left: 0 1 1 | 1 0 0 | 0 0 1, so the runs are 1 3 4 1.
  const TruthMask mask{.number = {0, 1, 0, 1, 0, 0, 1, 0, 1}, .things = {SeenThing{}}};
  EXPECT_EQ(coco_counts(mask, 3, 3, 1), "134N");
}

TEST(TruthFiles, WritesDepthInMillimetresAndMetres) {
  const PictureTruth truth{.width = 2,
                           .height = 2,
                           .depth = {1.2345F, 70, INFINITY, 0.5F},
                           .normal = std::vector<Vec3>(4, Vec3(0, 0, 1)),
                           .masks = {},
                           .camera = Camera(Vec3(0), Vec3(0, 0, -1), 0.6, 1)};
  const std::string pfm = encode_truth(truth, truth_format("depth"), "a.pfm", {});
  ASSERT_EQ(pfm.size(), 12 + 16U);
  EXPECT_TRUE(pfm.starts_with("Pf\n2 2\n-1.0\n"));
  float lower_left = 0;
  std::memcpy(&lower_left, pfm.data() + pfm.size() - 16, sizeof(float));
  EXPECT_TRUE(std::isinf(lower_left)) << "rows from the bottom";
  EXPECT_TRUE(encode_truth(truth, truth_format("depth"), "a.png", {}).starts_with("\x89PNG"));
  EXPECT_THROW(check_truth_file(truth_format("depth"), "a.jpg"), InputError);
  EXPECT_THROW(check_truth_file(truth_format("coco"), "a.png"), InputError);
  EXPECT_THROW(truth_format("deep"), InputError);
}

TEST(TruthFiles, WritesWhatWasAskedFor) {
  const TemporaryFolder folder;
  const Seen seen = look(kBall, ball_view(), 8, 6);
  EXPECT_EQ(seen.truth.camera.position(), *ball_view().position);
  const std::vector<TruthFile> files{{&truth_format("depth"), folder / "a.pfm"},
                                     {&truth_format("coco"), folder / "a.json"}};
  write_truths(seen.truth, files, {.picture = "a.png", .name = {}, .licence = {}});
  for (const TruthFile& file : files) {
    EXPECT_EQ(whole_file(file.path),
              encode_truth(seen.truth, *file.format, file.path, {.picture = "a.png", .name = {}, .licence = {}}));
  }
}

TEST(TruthFiles, AnnotatesWhatIsSeen) {
  const Seen seen = look(kTwins, CameraView(), 160, 120);
  const Value coco = parse_json(encode_truth(seen.truth, truth_format("coco"), "a.json",
                                             {.picture = "a.png", .name = "Twins", .licence = "CC0-1.0"}));
  EXPECT_EQ(*(*coco.find("images")->list())[0].find("file_name")->text(), "a.png");
  EXPECT_EQ(coco.find("categories")->list()->size(), 4U) << "leaf, wood of stem, shoot, plant";
  std::size_t things = 0;
  for (int level = 0; level < kTruthLevels; ++level) things += seen.truth.masks[level].things.size();
  const Value::List& annotations = *coco.find("annotations")->list();
  ASSERT_EQ(annotations.size(), things);
  double area = 0;
  for (std::size_t k = 0; k < seen.truth.mask(TruthLevel::organ).things.size(); ++k) {
    area += *annotations[k].find("area")->number();
    const Value::List& box = *annotations[k].find("bbox")->list();
    EXPECT_LE(*annotations[k].find("area")->number(), *box[2].number() * *box[3].number());
  }
  double pixels = 0;
  for (const std::uint32_t number : seen.truth.mask(TruthLevel::organ).number) pixels += number != 0 ? 1 : 0;
  EXPECT_EQ(area, pixels);
}

}  // namespace meristem::truth_test
