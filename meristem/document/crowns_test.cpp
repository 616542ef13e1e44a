// SPDX-License-Identifier: Apache-2.0
// Crowns and points in documents: the bodies that they become, and the messages about wrong ones.
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/colonize.h"
#include "meristem/components/parts/crown_table.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "tests/support/temporary_folder.h"

namespace meristem::crowns_test {

constexpr const char* kSmall = R"("points": 300)";

std::string document_with(const std::string& crown, const std::string& points = kSmall) {
  return fmt::format(R"({{"meristem": 1, "components": {{"tree": {{"type": "colonize",
"crown": {}, {}}}}}}})",
                     crown, points);
}

Document read(const std::string& text) { return read_document(text, "d.json", builtin_components()); }

CrownPointer crown(const std::string& text) {
  const Document document = read(document_with(text));
  return build_crown(*static_cast<const Colonize*>(document.graph.components[0].parameters.get())->crown);
}

/// The first fault of reading, else of growing.
std::string error(const std::string& crown_text, const std::string& points = kSmall) {
  try {
    Progress progress;
    grow_document(read(document_with(crown_text, points)), progress);
  } catch (const InputError& error) {
    return error.diagnostics().at(0).text();
  }
  return "no fault";
}

TEST(CrownDocument, TakesEveryCrown) {
  struct Case {
    const char* text;
    Vec3 inside;
    Vec3 outside;
  };
  const std::array<Case, 10> cases{{
      {R"({"profile": [[1, 1], [0, 3]]})", {0.9F, 1, 0}, {0.9F, 2, 0}},
      {R"({"profiles": {"0": [[0,0.5],[1,2],[0,3]], "180": [[0,0.5],[0.4,2],[0,3]]}})", {0, 2, -0.9F}, {0, 2, 0.9F}},
      {R"({"profiles": {"90.5": {"profile": [[1, 1], [1, 3]]}, "-90": [[2, 1], [2, 3]]}})",
       {-1.9F, 2, 0},
       {1.9F, 2, 0}},
      {R"({"union": [{"sphere": {"centre": [0, 1, 0], "radius": 1}}, {"sphere": {"centre": [0, 4, 0], "radius": 1}}]})",
       {0, 4.9F, 0},
       {0, 2.5F, 0}},
      {R"({"intersection": [{"sphere": {"centre": [0, 1, 0], "radius": 1}}, {"box": [[0, 0, 0], [1, 2, 1]]}]})",
       {0.5F, 1, 0.5F},
       {-0.5F, 1, 0.5F}},
      {R"({"difference": [{"sphere": {"centre": [0, 1, 0], "radius": 1}}, {"box": [[0, 0, 0], [1, 2, 1]]}]})",
       {-0.5F, 1, 0.5F},
       {0.5F, 1, 0.5F}},
      {R"({"ellipsoid": {"centre": [0,3,0], "radii": [1,2,1]}})", {0, 4.9F, 0}, {0, 0.9F, 0}},
      {R"({"cone": {"base": [0, 1, 0], "radius": 1, "height": 3}})", {0, 3.9F, 0}, {0.5F, 3.9F, 0}},
      {R"({"box": [[-3,0,3],[3,8,"4+2"]]})", {-2, 1, 4}, {0, 1, 0}},
      {R"({"union": [{"union": [{"difference": [{"profile": [[1, 1], [1, 3]]}, {"cone": {"base": [0, 1, 0], "radius": 0.5, "height": 2}}]}]}]})",
       {0.9F, 2, 0},
       {0, 2, 0}},
  }};
  for (const Case& each : cases) {
    SCOPED_TRACE(each.text);
    const CrownPointer made = crown(each.text);
    EXPECT_TRUE(made->contains(each.inside));
    EXPECT_FALSE(made->contains(each.outside));
    EXPECT_EQ(error(each.text), "no fault");
  }
}

TEST(CrownDocument, TakesSharesAndBlueNoise) {
  const char* const ball = R"({"sphere": {"centre": [0, 2, 0], "radius": 1}})";
  EXPECT_EQ(error(ball, R"("points": {"count": 300, "shares": [{"share": 0.2, "above": 0.4}]})"), "no fault");
  EXPECT_EQ(error(ball, R"("points": {"count": 300, "shares": [{"share": 0.9, "outer": 0.15}], "blue_noise": true})"),
            "no fault");
  EXPECT_EQ(error(ball, R"("points": {"shares": [{"share": 0.3, "above": 0.5, "outer": "1/2"}, {"share": 0.7}]})"),
            "no fault");
}

TEST(CrownDocument, EveryFaultHasItsPlaceAndSaysWhatIsWanted) {
  const std::array<std::array<const char*, 2>, 22> cases{{
      {R"({})", "d.json:2:10: components.tree.crown: a crown has none of profile, profiles"},
      {R"({"sphere": {"centre": [0, 1, 0], "radius": 1}, "box": [[0, 0, 0], [1, 1, 1]]})",
       "crown: a crown has more than one of"},
      {R"({"profile": [[1, 1]]})", "d.json:2:22: components.tree.crown.profile: the profile has fewer than two points"},
      {R"({"profile": [[1, 2], [1, 1]]})", "crown.profile[1]: the height 1 does not rise; expected a height above 2"},
      {R"({"profile": [[1, 2], [-1, 3]]})", "crown.profile[1][0]: the value -1 is out of range for 'profile'"},
      {R"({"profile": [[0, 2], [0, 3]]})", "components.tree.crown.profile: the crown is empty"},
      {R"({"profiles": {}})", "components.tree.crown: the crown is empty: its list has no parts"},
      {R"({"profiles": {"north": [[1, 0], [1, 2]]}})",
       "d.json:2:24: components.tree.crown.profiles.north: 'north' is not an azimuth"},
      {R"({"profiles": {"22.5": [[1, 2], [1, 1]]}})",
       "d.json:2:41: components.tree.crown.profiles.22.5[1]: the height 1"},
      {R"({"profiles": {"-90": [[1, 1], [1, 2]], "270": [[1, 1], [1, 2]]}})", "'-90' and '270' are one azimuth"},
      {R"({"union": []})", "components.tree.crown: the crown is empty: its list has no parts"},
      {R"({"union": [{"sphere": {"centre": [0, 1, 0], "radius": -2}}]})",
       "crown.union[0].sphere.radius: the value -2 is out of range"},
      {R"({"union": [{"sphere": {"centre": [0, 1, 0]}}]})", "crown.union[0].sphere: a sphere has no 'radius'"},
      {R"({"union": {"sphere": {}}})", "crown.union: 'union' cannot be an object"},
      {R"({"intersection": [{"sphere": {"centre": [0, 1, 0], "radius": 1}}, {"sphere": {"centre": [0, 4, 0], "radius": 1}}]})",
       "components.tree.crown: the crown is empty, or nearly; expected"},
      {R"({"union": [{"difference": [{"sphere": {"centre": [0, 1, 0], "radius": 1}}, {"sphere": {"centre": [0, 1, 0], "radius": 1}}]}]})",
       "components.tree.crown.union[0]: the crown is empty"},
      {R"({"ellipsoid": {"centre": [0, 3, 0], "radii": [1, 0, 1]}})",
       "crown.ellipsoid.radii[1]: the value 0 is out of range"},
      {R"({"elipsoid": {"centre": [0, 3, 0], "radii": [1, 0, 1]}})", "did you mean 'ellipsoid'?"},
      {R"({"cone": {"base": [0, 1], "radius": 1, "height": 3}})", "crown.cone.base: 'base' cannot be a list of 2"},
      {R"({"box": [[0, 0, 0], [1, -1, 1]]})", "crown.box: the box ends in y at -1, where it begins at 0"},
      {R"({"box": [0, 0, 0, 1, 1, 1]})", "crown.box: 'box' cannot be a list of 6; expected two corners"},
      {R"("round")", "components.tree.crown: a crown cannot be the text 'round'"},
  }};
  for (const auto& [text, wanted] : cases) {
    EXPECT_NE(error(text).find(wanted), std::string::npos) << text << "\n" << error(text) << "\nis not\n" << wanted;
  }
}

TEST(CrownDocument, FaultyPointsHaveTheirPlace) {
  const char* const ball = R"({"sphere": {"centre": [0, 2, 0], "radius": 1}})";
  const std::array<std::array<const char*, 2>, 6> cases{{
      {R"("points": {"shares": [{"share": 0.6}, {"share": 0.5}]})", "points.shares: the shares sum to 1.1"},
      {R"("points": {"shares": [{"share": 0}]})", "points.shares[0].share: the value 0 is out of range"},
      {R"("points": {"shares": [{"above": 0.5}]})", "points.shares[0]: a share has no 'share'"},
      {R"("points": {"shares": [{"share": 0.5, "outer": 0}]})", "points.shares[0].outer: the value 0 is out of range"},
      {R"("points": {"shares": [{"share": 0.5, "over": 0.4}]})", "'over' is not a parameter of a share"},
      {R"("points": {"count": 0})", "points.count: the value 0 is out of range"},
  }};
  for (const auto& [text, wanted] : cases) {
    EXPECT_NE(error(ball, text).find(wanted), std::string::npos) << error(ball, text) << "\nis not\n" << wanted;
  }
  const std::string cone = R"({"cone": {"base": [0, 0, 0], "radius": 1, "height": 1}})";
  EXPECT_NE(error(cone, R"("points": {"shares": [{"share": 0.5, "above": 0.999}]})")
                .find("tree.points.shares[0]: the share's part"),
            std::string::npos);
}

// A tree of two roots with few points, and a cloud that shows them.
Plant tree_with_cloud(const std::string& tree, const std::string& cloud) {
  const std::string text = fmt::format(R"({{"meristem": 1, "seed": 5, "components": {{
    "dots": {{"type": "cloud", {}}},
    "tree": {{"type": "colonize", "crown": {{"sphere": {{"centre": [0, 3, 0], "radius": 2}}}}, "points": 12,
              "step": 0.05, "influence": 6, "kill": 0.1, "finish": {{"decimate": 0, "relax": false, "subdivide": 0}}, {}}}}}}})",
                                       cloud, tree);
  const Document document = read_document(text, "d.json", builtin_components());
  Progress progress;
  return grow_document(document, progress, {.up_to = GrownPart::plant}).plant;
}

/// The largest distance from a dot to the tree's nearest node.
float farthest_from_tree(const Plant& plant) {
  float farthest = 0;
  for (const Organ& dot : plant.organs) {
    float nearest = 1e9F;
    for (const Vec3 node : plant.stems.at(0).skeleton.position) {
      nearest = std::min(nearest, glm::distance(node, dot.frame.origin));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(CrownDocument, ACloudShowsThePointsThatItsTreeGrowsTo) {
  for (const char* const tree :
       {R"("alone": false)", R"("roots": [[0, 0, 0], [5, 0, 1]])",
        R"("frame": {"translate": [1, 0, 2], "rotate": [0, 0, 30]})",
        R"("roots": [[-1, 0, 0], [2, 0, 1]], "one_crown": true, "frame": {"scale": [2, 2, 2]})"}) {
    const Plant plant = tree_with_cloud(tree, R"("of": "tree")");
    EXPECT_GE(plant.organs.size(), 12U);
    const float scale = std::string(tree).find("scale") == std::string::npos ? 1 : 2;
    EXPECT_LT(farthest_from_tree(plant), scale * 0.11F) << tree;
  }
}

TEST(CrownDocument, ACloudMayStandElsewhereThanItsTree) {
  const Plant there = tree_with_cloud(R"("alone": false)", R"("of": "tree")");
  const Plant away = tree_with_cloud(R"("alone": false)", R"("of": "tree", "frame": {"translate": [4, 0, 0]})");
  ASSERT_EQ(away.organs.size(), there.organs.size());
  for (std::size_t k = 0; k < away.organs.size(); ++k) {
    EXPECT_LT(glm::distance(away.organs[k].frame.origin, there.organs[k].frame.origin + Vec3(4, 0, 0)), 1e-5F);
  }
}

TEST(CrownDocument, ACloudOfATreeThatIsNotThereNamesTheNearest) {
  try {
    tree_with_cloud(R"("alone": false)", R"("of": "tre")");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].message, "there is no colonize 'tre'");
    EXPECT_EQ(error.diagnostics()[0].nearest, "tree");
    EXPECT_EQ(error.diagnostics()[0].path, "components.dots.of");
    EXPECT_GT(error.diagnostics()[0].line, 0);
  }
}

/// A folder with files for one test.
class CrownFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "scans");
    write("scans/tree.xyz", "# a scan, z up\n0 0 1\n0.2 0 1.5\n-0.2 0.1 1.8\n0 4 1\n");
    write("scans/bad.xyz", "0 0 1\n0 0 nan\n");
    write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
    write("tetra.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string document_path() const { return (folder_ / "d.json").string(); }

  Document read_here(const std::string& members) const {
    const std::string text = fmt::format(R"({{"meristem": 1, "components": {{"tree": {{"type": "colonize",
{}}}}}}})",
                                         members);
    return read_document(text, document_path(), builtin_components());
  }
  /// The first fault, without the path of the document.
  std::string error_here(const std::string& members) const {
    try {
      Progress progress;
      grow_document(read_here(members), progress);
    } catch (const InputError& error) {
      Diagnostic found = error.diagnostics().at(0);
      found.file = "d.json";
      return found.text();
    }
    return "no fault";
  }
  std::vector<Vec3> points_of(const std::string& members) const {
    const Document document = read_here(members);
    const auto& tree = *static_cast<const Colonize*>(document.graph.components[0].parameters.get());
    Progress progress;
    const SizeLimits limits;
    const Scene scene;
    Stand stand;
    const std::string component = "tree";
    return make_points(tree.crown, tree.points, RandomKey(1),
                       {scene, scene.directions(), limits, component, stand, progress});
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

TEST_F(CrownFiles, AreSoughtFromTheDocumentsFolder) {
  EXPECT_EQ(points_of(R"("points": {"file": "scans/tree.xyz"})").size(), 4U);
  EXPECT_EQ(error_here(R"("points": {"file": "scans/tree.xyz", "up": "z"}, "influence": 5)"), "no fault");
}

TEST_F(CrownFiles, PointsAreTurnedUpScaledTurnedAndMoved) {
  const std::vector<Vec3> points =
      points_of(R"("points": {"file": "scans/tree.xyz", "up": "z", "scale": 2, "translate": [10, 0, 0]})");
  EXPECT_EQ(points[0], Vec3(10, 2, 0));
  EXPECT_LT(glm::length(points[2] - Vec3(9.6F, 3.6F, -0.2F)), 1e-5F);
  const std::vector<Vec3> turned = points_of(R"("points": {"file": "scans/tree.xyz", "rotate": [0, 90, 0]})");
  EXPECT_LT(glm::length(turned[0] - Vec3(1, 0, 0)), 1e-5F);
}

TEST_F(CrownFiles, PointsWithTheCoordinatesOfACountryAreMovedToTheMillimetre) {
  write("scans/map.xyz", "3456789.126 105.25 5765432.381\n3456790.001 106.75 5765431.906\n");
  const std::vector<Vec3> points =
      points_of(R"("points": {"file": "scans/map.xyz", "translate": [-3456789.001, -105.125, -5765432.256]})");
  ASSERT_EQ(points.size(), 2U);
  EXPECT_LT(glm::length(points[0] - Vec3(0.125F, 0.125F, 0.125F)), 1e-6F);
  EXPECT_LT(glm::length(points[1] - Vec3(1, 1.625F, -0.35F)), 1e-6F);
  const std::vector<Vec3> up = points_of(R"("points": {"file": "scans/map.xyz", "scale": 0.001, "rotate": [0, 90, 0],
                              "translate": [-5765.432256, -0.1, 3456.789001]})");
  EXPECT_LT(glm::length(up[0] - Vec3(0.000125F, 0.00525F, -0.000125F)), 1e-8F) << "turns and scales, too";
}

TEST_F(CrownFiles, AMeshWithTheCoordinatesOfACountryIsMovedToTheMillimetre) {
  write("map.obj",
        "v 3456789.1 10 5765432.3\nv 3456790.1 10 5765432.3\nv 3456789.1 11 5765432.3\nv 3456789.1 10 5765433.3\n"
        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const Document document = read_here(R"("crown": {"mesh": "map.obj", "translate": [-3456789.1, -10, -5765432.3]})");
  const auto& tree = *static_cast<const Colonize*>(document.graph.components[0].parameters.get());
  const CrownPointer made = build_crown(*tree.crown);
  EXPECT_NEAR(made->bounds().low.x, 0, 1e-6);
  EXPECT_NEAR(made->bounds().high.z, 1, 1e-6);
  EXPECT_TRUE(made->contains({0.01F, 0.01F, 0.01F}));
  EXPECT_FALSE(made->contains({-0.01F, 0.01F, 0.01F}));
}

TEST_F(CrownFiles, ACrownCutsOffThePointsOutside) {
  EXPECT_EQ(
      points_of(R"("points": {"file": "scans/tree.xyz", "up": "z"}, "crown": {"profile": [[1, 0], [1, 3]]})").size(),
      3U);
  EXPECT_EQ(
      error_here(R"("points": {"file": "scans/tree.xyz"}, "crown": {"box": [[5, 5, 5], [6, 6, 6]]})"),
      "d.json:2:20: components.tree.points.file: none of the points of 'scans/tree.xyz' lies in the crown; expected "
      "points around the crown; scale, turn or translate them");
}

TEST_F(CrownFiles, PointsOutOfTheWorldAreRefusedUnlessACrownCutsThemOff) {
  write("scans/far.xyz", "0 1 0\n3e11 3e11 3e11\n");
  EXPECT_EQ(error_here(R"("points": {"file": "scans/far.xyz"})"),
            "d.json:2:20: components.tree.points.file: a point of 'scans/far.xyz' comes to lie at (3e+11, 3e+11, "
            "3e+11); expected coordinates within 10000000 m; scale and translate them");
  EXPECT_EQ(points_of(R"("points": {"file": "scans/far.xyz"}, "crown": {"box": [[-1, 0, -1], [1, 2, 1]]})").size(), 1U);
  write("scans/beyond.xyz", "0 1 0\n0 0 3e38\n");
  EXPECT_EQ(error_here(R"("points": {"file": "scans/beyond.xyz"})"),
            "d.json:2:20: components.tree.points.file: 'scans/beyond.xyz:2:5': '3e38' is out of range; expected a "
            "coordinate from -1e+12 to 1e+12");
}

TEST_F(CrownFiles, AMeshIsACrown) {
  const Document document = read_here(R"("crown": {"mesh": "tetra.obj", "up": "z", "translate": [0, 1, 0]})");
  const auto& tree = *static_cast<const Colonize*>(document.graph.components[0].parameters.get());
  const CrownPointer made = build_crown(*tree.crown);
  EXPECT_TRUE(made->contains({0.1F, 2.7F, -0.1F}));
  EXPECT_FALSE(made->contains({0.1F, 2.7F, 0.1F}));
  EXPECT_FALSE(made->contains({0.1F, 0.9F, -0.1F}));
  EXPECT_EQ(error_here(R"("points": 200, "crown": {"mesh": "tetra.obj"})"), "no fault");
  EXPECT_EQ(
      error_here(R"("points": 200, "crown": {"union": [{"mesh": "tetra.obj", "scale": 2}, {"mesh": "tetra.obj"}]})"),
      "no fault");
}

TEST_F(CrownFiles, EveryFaultSaysItsPlaceInTheDocumentAndInTheFile) {
  EXPECT_EQ(
      error_here(R"("points": {"file": "scans/bad.xyz"})"),
      "d.json:2:20: components.tree.points.file: 'scans/bad.xyz:2:5': z is not a finite number; expected a number (m)");
  EXPECT_EQ(error_here(R"("points": {"file": "scans/tre.xyz"})"),
            "d.json:2:20: components.tree.points.file: 'scans/tre.xyz': there is no such file; did you mean "
            "'scans/tree.xyz'?");
  EXPECT_EQ(error_here(R"("crown": {"mesh": "tetr.obj"})"),
            "d.json:2:19: components.tree.crown.mesh: 'tetr.obj': there is no such file; did you mean 'tetra.obj'?");
  EXPECT_EQ(
      error_here(R"("crown": {"mesh": "open.obj"})"),
      "d.json:2:19: components.tree.crown.mesh: 'open.obj': 3 edges are open, with a triangle on one side only; "
      "the first "
      "goes from (1, 0, 0) to (0, 1, 0); expected a closed mesh, in which every edge has a triangle on both sides");
  EXPECT_NE(error_here(R"("crown": {"mesh": "scans"})").find("'scans': this is a folder"), std::string::npos);
  EXPECT_NE(error_here(R"("crown": {"mesh": ""})").find("'': there is no such file"), std::string::npos);
  EXPECT_NE(error_here(R"("crown": {"mesh": 3})").find("'mesh' cannot be the number 3; expected the path of a file"),
            std::string::npos);
  EXPECT_NE(
      error_here(R"("crown": {"box": [[0, 0, 0], [1, 1, 1]], "up": "z"})").find("'up' has no meaning without 'mesh'"),
      std::string::npos);
  EXPECT_NE(
      error_here(R"("points": {"file": "scans/tree.xyz", "count": 3})").find("'count' has no meaning beside 'file'"),
      std::string::npos);
  EXPECT_EQ(error_here(R"("step": 0.05)"),
            "d.json:1:40: components.tree: a colonize has no 'crown'; expected a 'crown', or 'points' with a 'file'");
}

TEST(CrownDocument, SizesMayVaryFromTreeToTree) {
  const std::string text = R"({"meristem": 1, "components": {
    "row": {"type": "simple", "hidden": true}, "second": {"type": "simple", "hidden": true},
    "tree": {"type": "colonize", "crown": {"sphere": {"centre": [0, 2, 0], "radius": "0.5 + i"}}, "points": 200}},
    "links": [["row", "tree"], ["second", "tree"]]})";
  EXPECT_NO_THROW(read(text));
}

TEST(CrownDocument, NestingIsBounded) {
  std::string crown = R"({"sphere": {"centre": [0, 2, 0], "radius": 1}})";
  for (int k = 0; k < 100; ++k) crown = fmt::format(R"({{"union": [{}]}})", crown);
  EXPECT_NE(error(crown).find("nest"), std::string::npos) << error(crown);
}

}  // namespace meristem::crowns_test
