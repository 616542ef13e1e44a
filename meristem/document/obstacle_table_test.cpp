// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/obstacle_table.h"

#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace meristem::obstacle_table_test {

std::string document_with(const std::string& obstacles, const std::string& more = "") {
  return fmt::format(
      R"({{"meristem": 1, {} "variables": {{"wide": 3}}, "scene": {{"obstacles": {}}}, "components": {{"leaf": {{"type": "leaf", "length": "wide"}}}}}})",
      more, obstacles);
}

// A document in a folder with a closed cube of 2 m, the same without its last triangle, and a text that is no mesh.
class ObstacleDocument : public testing::Test {
 protected:
  ObstacleDocument() {
    const std::string max =
        "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nv 0 0 2\nv 2 0 2\nv 0 2 2\nv 2 2 2\n"
        "f 1 3 2\nf 2 3 4\nf 5 6 7\nf 6 8 7\nf 1 2 5\nf 2 6 5\nf 3 7 4\nf 4 7 8\nf 1 5 3\nf 3 5 7\nf 2 4 6\n";
    write("cube.obj", max + "f 4 8 6\n");
    write("open.obj", max);
    write("none.obj", "v 0 0 nan\n");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  Document read(const std::string& text, const std::vector<ValueOverride>& overrides = {}) const {
    return read_document(text, (folder_ / "d.json").string(), builtin_components(), {.overrides = overrides});
  }
  Obstacles obstacles(const std::string& text) const { return read(document_with(text)).scene.obstacles; }

  // The first fault, from its document path on.
  std::string error(const std::string& obstacles, const std::string& more = "") const {
    try {
      read(document_with(obstacles, more));
    } catch (const InputError& error) {
      Diagnostic first = error.diagnostics().at(0);
      first.file.clear();
      first.line = first.column = 0;
      return first.text();
    }
    return "no fault";
  }

  TemporaryFolder folder_;
};

TEST_F(ObstacleDocument, ABoxIsTwoCornersInAnyOrder) {
  const Obstacles boxes =
      obstacles(R"([{"box": [[-3, 0, 3], [3, 8, 6]]}, {"box": [["wide", 8, 13], ["-wide", 0, 16]]}])");
  ASSERT_EQ(boxes.bodies().size(), 2U);
  for (const Obstacle& body : boxes.bodies()) EXPECT_TRUE(closedness_errors(body.mesh).empty());
  EXPECT_TRUE(boxes.contain({2.9F, 7.9F, 3.1F}));
  EXPECT_TRUE(boxes.contain({-2.9F, 7.9F, 13.1F}));
  EXPECT_FALSE(boxes.contain({0, 4, 8}));
  EXPECT_EQ(ClosedMesh(boxes.bodies()[1].mesh).winding_number({0, 4, 14}), 1);
  EXPECT_EQ(boxes.bounds().low, Vec3(-3, 0, 3));
  EXPECT_EQ(boxes.bounds().high, Vec3(3, 8, 16));
}

TEST_F(ObstacleDocument, BoxesAndMeshesAreScaledThenTurnedThenMoved) {
  const Obstacles placed = obstacles(
      R"([{"box": [[0, 0, 0], [4, 1, 1]], "scale": 2, "rotate": [0, 0, 90], "translate": [10, 20, 30]},
          {"mesh": "cube.obj", "up": "z", "scale": 0.5, "translate": [0, 5, 0]}])");
  // A quarter of yaw takes x to y and y to -x.
  EXPECT_LT(glm::distance(ClosedMesh(placed.bodies()[0].mesh).positions()[7], DVec3(8, 28, 32)), 1e-5);
  EXPECT_TRUE(placed.contain({8.1F, 27.9F, 31.9F}));
  // With z up the file's y goes north.
  EXPECT_TRUE(placed.contain({0.9F, 5.9F, -0.9F}));
  EXPECT_FALSE(placed.contain({0.9F, 5.9F, 0.1F}));
  for (const Obstacle& body : placed.bodies()) EXPECT_TRUE(closedness_errors(body.mesh).empty());
}

TEST_F(ObstacleDocument, MapCoordinatesAreMovedToTheMillimetre) {
  write("map.obj",
        "v 3456789.1 10 5765432.3\nv 3456790.1 10 5765432.3\nv 3456789.1 11 5765432.3\nv 3456789.1 10 5765433.3\n"
        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const Obstacles moved = obstacles(R"([{"mesh": "map.obj", "translate": [-3456789.1, -10, -5765432.3]}])");
  EXPECT_LT(glm::distance(moved.bodies()[0].mesh.positions[3], DVec3(0, 0, 1)), 1e-8);
}

TEST_F(ObstacleDocument, LooksAreKept) {
  const Obstacles looks = obstacles(
      R"([{"box": [[0, 0, 0], [1, 1, 1]], "colour": "#ff0000"}, {"mesh": "cube.obj", "hidden": true, "broken": true}])");
  EXPECT_EQ(looks.bodies()[0].colour, Vec3(1, 0, 0));
  EXPECT_FALSE(looks.bodies()[0].is_hidden);
  EXPECT_EQ(looks.bodies()[1].colour, Obstacle{}.colour);
  EXPECT_TRUE(looks.bodies()[1].is_hidden);
  EXPECT_FALSE(looks.bodies()[1].is_broken);  // the cube is closed, whatever the document fears
}

TEST_F(ObstacleDocument, FilesAreNamedSoThatNothingIsWrittenOverThem) {
  const Document document = read(document_with(R"([{"mesh": "cube.obj"}])"));
  EXPECT_EQ(document.source.named_files, std::vector<std::string>{(folder_ / "cube.obj").string()});
}

TEST_F(ObstacleDocument, AnOpenMeshIsAFaultUnlessItIsCalledBroken) {
  EXPECT_EQ(
      error(R"([{"box": [[0, 0, 0], [1, 1, 1]]}, {"mesh": "open.obj"}])"),
      "scene.obstacles[1].mesh: 'open.obj' is not closed: 3 edges are open, with a triangle on one side only; the "
      "first goes from (2, 2, 0) to (2, 0, 2); expected a closed mesh, or \"broken\": true to use it anyway");
  const Document document = read(document_with(R"([{"mesh": "open.obj", "broken": true}])"));
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_EQ(document.warnings[0].severity, Severity::warning);
  EXPECT_EQ(document.warnings[0].path, "scene.obstacles[0].mesh");
  EXPECT_NE(document.warnings[0].message.find("used as it is: 3 edges are open"), std::string::npos);
  EXPECT_TRUE(document.scene.obstacles.bodies()[0].is_broken);
  EXPECT_TRUE(document.scene.obstacles.contain({1, 1, 1}));
}

TEST_F(ObstacleDocument, AClosedMeshThatCrossesItselfIsCalledThat) {
  write("tie.obj",
        "v -1 0 -1\nv -1 0 1\nv 1 0 -1\nv 1 0 1\nv -1 1 -1\nv -1 1 1\nv 1 1 -1\nv 1 1 1\nv 0 0 0\nv 0 1 0\n"
        "f 1 9 2\nf 3 9 4\nf 5 6 10\nf 7 8 10\nf 1 2 6 5\nf 2 9 10 6\nf 9 3 7 10\nf 3 4 8 7\nf 4 9 10 8\nf 9 1 5 10\n");
  EXPECT_EQ(error(R"([{"mesh": "tie.obj"}])"),
            "scene.obstacles[0].mesh: 'tie.obj' crosses itself: as much of it is turned inside out as faces outward; "
            "expected a closed mesh that faces outward everywhere, or \"broken\": true to use it anyway");
  const Document document = read(document_with(R"([{"mesh": "tie.obj", "broken": true}])"));
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_EQ(document.warnings[0].message.find("not closed"), std::string::npos);
  EXPECT_TRUE(document.scene.obstacles.contain({-0.6F, 0.5F, 0.1F}));
  EXPECT_TRUE(document.scene.obstacles.contain({0.6F, 0.5F, 0.1F}));
}

TEST_F(ObstacleDocument, OverridesReachThem) {
  const Document document = read(document_with(R"([{"box": [[0, 0, 0], [1, 1, 1]]}])"),
                                 {parse_override("scene.obstacles[0].box=[[5,0,0],[6,1,1]]")});
  EXPECT_EQ(document.scene.obstacles.bounds().low, Vec3(5, 0, 0));
}

TEST_F(ObstacleDocument, EveryFaultHasItsPlace) {
  EXPECT_EQ(error(R"([{"colour": "#ffffff"}])"),
            "scene.obstacles[0]: an obstacle has none of box, mesh; expected exactly one of them");
  EXPECT_EQ(error(R"([{"box": [[0, 0, 0], [1, 1, 1]], "mesh": "cube.obj"}])"),
            "scene.obstacles[0]: an obstacle has more than one of box, mesh; expected exactly one of them");
  EXPECT_EQ(
      error(R"([{"box": [[0, 0, 0], [1, 0, 1]]}])"),
      "scene.obstacles[0].box: the box is flat: both of its corners have y at 0; expected two corners that differ "
      "in x, y and z");
  EXPECT_EQ(error(R"([{"box": [[0, 0, 0], [1, 1, 1]], "up": "z"}])"),
            "scene.obstacles[0].up: 'up' has no meaning without 'mesh'; expected 'mesh' beside it");
  EXPECT_EQ(error(R"([{"mesh": "cubes.obj"}])"),
            "scene.obstacles[0].mesh: 'cubes.obj': there is no such file; did you mean 'cube.obj'?");
  EXPECT_EQ(error(R"([{"mesh": "none.obj"}])"),
            "scene.obstacles[0].mesh: 'none.obj:1:7': 'nan' is not a finite number; expected a coordinate");
  EXPECT_EQ(error(R"([{"mesh": "cube.obj", "scale": 0}])").substr(0, 25), "scene.obstacles[0].scale:");
  EXPECT_EQ(
      error(R"([{"mesh": "cube.obj", "scale": 1e6, "translate": [1000, 0, 0]}])"),
      "scene.obstacles[0]: the obstacle reaches 2.001e+06 m from the origin; expected coordinates within 1000000 m; "
      "scale and translate it");
  EXPECT_EQ(error(R"([{"mesh": "cube.obj", "clour": "#ffffff"}])"),
            "scene.obstacles[0].clour: 'clour' is not a parameter of an obstacle; did you mean 'colour'?");
  EXPECT_EQ(error(R"({"box": [[0, 0, 0], [1, 1, 1]]})").substr(0, 16), "scene.obstacles:");
}

TEST_F(ObstacleDocument, TheirTrianglesCountAgainstTheLimits) {
  const std::string two = R"([{"box": [[0, 0, 0], [1, 1, 1]]}, {"mesh": "cube.obj"}])";
  EXPECT_EQ(error(two, R"("limits": {"triangles": 23},)"),
            "scene.obstacles: 24 triangles of obstacles are too many; expected at most 23 (limits.triangles)");
  EXPECT_EQ(error(two, R"("limits": {"mesh_bytes": 1000},)"),
            "scene.obstacles: 7200 bytes of obstacles are too many; expected at most 1000 (limits.mesh_bytes)");
  EXPECT_EQ(error(two, R"("limits": {"triangles": 24},)"), "no fault");
}

struct HouseFacts {
  const char* up;
  Box bounds;
};

TEST_F(ObstacleDocument, HousesStandOnTheGround) {
  for (const auto& [file, facts] :
       data_sets<HouseFacts>({{"models/house.obj", {"y", {{-4.5F, 0, 12 - 5.5F}, {4.5F, 9.6F, 12 + 5.5F}}}}},
                             {{"obstacles/house.obj", {"z", {{0, 0, 12 - 18.69F}, {13.49F, 9.41F, 12}}}}})) {
    SCOPED_TRACE(file);
    const Obstacles house =
        obstacles(fmt::format(R"([{{"mesh": "{}", "up": "{}", "translate": [0, 0, 12]}}])", file, facts.up));
    EXPECT_LT(glm::distance(house.bounds().low, facts.bounds.low), 0.02F);
    EXPECT_LT(glm::distance(house.bounds().high, facts.bounds.high), 0.02F);
    EXPECT_TRUE(closedness_errors(house.bodies()[0].mesh).empty());
  }
}

}  // namespace meristem::obstacle_table_test
