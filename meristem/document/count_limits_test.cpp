// SPDX-License-Identifier: Apache-2.0
// Documents whose counts alone pass limits are refused before anything grows, and documents that may stay below are
// not.
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "tests/support/temporary_folder.h"

namespace meristem::count_limits_test {

std::string document(const std::string& components, const std::string& links, const std::string& limits = "") {
  return fmt::format(R"({{"meristem": 1, "components": {{{}}}, "links": [{}], "limits": {{{}}}}})", components, links,
                     limits);
}

/// How growth ends if it is cancelled from the start: refusals by counts come before anything else.
std::vector<std::string> outcome(const Document& document, const GrowthOptions& options) {
  Progress progress;
  progress.cancel();
  try {
    grow_document(document, progress, options);
  } catch (const Cancelled&) {
    return {"cancelled"};
  } catch (const InputError& error) {
    std::vector<std::string> messages;
    for (const Diagnostic& found : error.diagnostics()) messages.push_back(found.message + "; " + found.expected);
    return messages;
  }
  return {"grown"};
}

std::vector<std::string> outcome(const std::string& text, GrownPart up_to = GrownPart::plant) {
  return outcome(read_document(text, "d.json", builtin_components()), {.up_to = up_to});
}

using Messages = std::vector<std::string>;
const Messages kCancelled{"cancelled"};

constexpr const char* kLeaf = R"("leaf": {"type": "leaf"})";

std::string star(const std::string& id, const std::string& rows) {
  return fmt::format(R"("{}": {{"type": "hydra", {}}}, )", id, rows);
}

TEST(CountLimits, CountsOfMultipliersMultiply) {
  const std::string stars =
      star("a", R"("number": 300)") + star("b", R"("number": 700)") + star("c", R"("number": 999)");
  EXPECT_EQ(outcome(document(stars + kLeaf, R"(["a", "b"], ["b", "c"], ["c", "leaf"])")),
            Messages{"2.1e+08 instances, of which leaf 2.1e+08 (100 %), are too many; at most 20000000 "
                     "(limits.instances)"});
  EXPECT_EQ(outcome(document(stars + kLeaf, R"(["a", "b"], ["b", "c"], ["c", "leaf"])", R"("instances": 3e8)")),
            kCancelled);
}

TEST(CountLimits, TheLargestShareIsNamed) {
  const std::string text = document(star("crown", R"("number": 10)") + star("twig", R"("number": 9)") + kLeaf,
                                    R"(["crown", "twig"], ["twig", "leaf"])", R"("instances": 101)");
  // The camera, one crown, 10 twigs and 90 leaves.
  EXPECT_EQ(outcome(text),
            Messages{"102 instances, of which leaf 90 (88 %), are too many; at most 101 (limits.instances)"});
}

TEST(CountLimits, ExactlyAsManyAsTheLimitAreNotTooMany) {
  const std::string components = star("crown", R"("number": 10)") + kLeaf;
  EXPECT_EQ(outcome(document(components, R"(["crown", "leaf"])", R"("instances": 12)")), kCancelled);
  EXPECT_EQ(outcome(document(components, R"(["crown", "leaf"])", R"("instances": 11)")).size(), 1U);
}

TEST(CountLimits, NestedRecursionsAreCountedWithoutBeingMade) {
  // Each recursion of 100 lies within the one before.
  std::string components;
  for (const char id : {'a', 'b', 'c', 'd'}) {
    components += fmt::format(R"({}"{}": {{"type": "simple", "recursion": 100}})", id == 'a' ? "" : ", ", id);
  }
  const Messages messages = outcome(
      document(components, R"(["a", "b"], ["b", "c"], ["c", "d"], ["d", "d"], ["d", "c"], ["d", "b"], ["d", "a"])"));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("instances, of which d"), std::string::npos) << messages[0];
}

TEST(CountLimits, AllLimitsArePassedAtOnce) {
  const std::string text =
      document(R"("wood": {"type": "field", "rows": 1000, "plants": 1000},
                  "stem": {"type": "tree", "segments": 99}, )" +
                   std::string(kLeaf),
               R"(["wood", "stem"], {"from": "stem", "to": "leaf", "kind": "branch", "count": 60})");
  EXPECT_EQ(
      outcome(text),
      (Messages{"6.1e+07 instances, of which leaf 6e+07 (98 %), are too many; at most 20000000 (limits.instances)",
                "1e+08 skeleton nodes, of which stem 1e+08 (100 %), are too many; at most 20000000 "
                "(limits.nodes)"}));
}

TEST(CountLimits, OfACountThatVariesTheSmallestValueCounts) {
  const auto text = [](const std::string& number) {
    return document(star("a", R"("number": 5000)") + star("b", "\"number\": " + number) + kLeaf,
                    R"(["a", "b"], ["b", "leaf"])");
  };
  EXPECT_EQ(outcome(text("[5000, 6000]")).front().substr(0, 18), "2.5e+07 instances,");
  EXPECT_EQ(outcome(text("[10, 20000]")), kCancelled);
  EXPECT_EQ(outcome(text("\"5000 + 1000*rand()\"")), kCancelled) << "nothing is known of an expression";
}

TEST(CountLimits, NothingIsCountedThatMayNotBeThere) {
  const auto text = [](const std::string& rows, const std::string& more = "") {
    return document(star("a", R"("number": 5000)") + star("b", "\"number\": 5000, " + rows) + more + kLeaf,
                    R"(["a", "b"], ["b", "leaf"])");
  };
  EXPECT_NE(outcome(text(R"j("arc": 90)j")), kCancelled);
  EXPECT_EQ(outcome(text(R"j("size": "rand()")j")), kCancelled) << "children may have no size";
  EXPECT_EQ(outcome(text(R"j("frame": {"scale": ["rand()", 1, 1]})j")), kCancelled);
  EXPECT_EQ(outcome(text(R"j("omit": ["i == 0"])j")), kCancelled);
  // Each instance of the recursion is smaller than its parent, and vanished instances have no children.
  const auto shrinking = [](const std::string& size) {
    return document(R"j("twig": {"type": "hydra", "number": 2, "recursion": 60, "size": )j" + size + "}",
                    R"j(["twig", "twig"])j");
  };
  EXPECT_NE(outcome(shrinking("0.5")), kCancelled) << "2 to the power of 25 are there before they vanish";
  EXPECT_EQ(outcome(shrinking("0.0001")), kCancelled);
}

TEST(CountLimits, TrianglesAreCountedIfAllSurfacesAreMeshed) {
  const std::string text =
      document(star("a", R"("number": 300)") + star("b", R"("number": 700)") + R"("box": {"type": "simple"})",
               R"(["a", "b"], ["b", "box"])", R"("triangles": 2e6)");
  EXPECT_EQ(outcome(text, GrownPart::meshes),
            Messages{"2.5e+06 triangles, of which box 2.5e+06 (100 %), are too many; at most 2000000 "
                     "(limits.triangles)"});
  EXPECT_EQ(outcome(text, GrownPart::textures), outcome(text, GrownPart::meshes));
  EXPECT_EQ(outcome(text, GrownPart::plant), kCancelled) << "tables and measures need no meshes";
  const Document document = read_document(text, "d.json", builtin_components());
  EXPECT_EQ(outcome(document, {.detail = {.level = 2}}), kCancelled) << "a coarse level may have few triangles";
  const auto with = [&](const std::string& rows) {
    return outcome(meristem::count_limits_test::document(
                       star("a", R"("number": 1000)") + R"("box": {"type": "simple", )" + rows + "}", R"(["a", "box"])",
                       R"("triangles": 100)"),
                   GrownPart::meshes);
  };
  EXPECT_NE(with(R"("size": [1, 1, 1])"), kCancelled);
  EXPECT_EQ(with(R"("hidden": true)"), kCancelled);
  EXPECT_EQ(with(R"j("omit": ["rand() < 0.5"])j"), kCancelled);
  EXPECT_EQ(with(R"j("only": ["rand() < 0.5"])j"), kCancelled);
}

TEST(CountLimits, NeverMoreTrianglesAreCountedThanThereAre) {
  struct Shape {
    std::string rows;
    bool is_exact;  // true: the exact number is known before growth
  };
  std::vector<Shape> shapes{
      {R"("type": "leaf")", true},
      {R"("type": "leaf", "rows": 9, "across": 6, "petiole": 0.01, "curl": 70, "teeth": 9)", true},
      {R"("type": "leaf", "rows": 256, "length": [0.05, 0.1], "curl": [10, 80])", false},
      {R"j("type": "leaf", "rows": 1, "length": "rand(0.05, 0.1)", "outline": {"curve": [[0, 1], [0.5, 0], [1, 0]]})j",
       false},
      {R"("type": "leaf", "rows": 30, "width": [0.01, 0.5], "polygon": [[0.9, 0.4], [0.2, 0.5], [1, 0.6]])", false},
      {R"("type": "leaf", "waves": 5, "curl": [0, 9])", false},
      {R"("type": "leaf", "rows": 256, "length": [0.05, 0.1], "outline": {"curve": [[0, 1], [0.1, 0], [1, 0]]})",
       false},
      {R"("type": "revolution", "silhouette": [[0, 0], [0.1, 0.1], [0, 0.2]])", true},
      {R"("type": "revolution", "silhouette": [[0.1, 0], [0.2, 0.1]], "kind": "linear", "sweep": 90)", true},
      {R"("type": "needles", "count": 20, "fascicle": 2, "sides": 3, "axis_radius": 0)", true},
      {R"("type": "needles", "count": 20, "axis_radius": 0.001)", false},
      {R"("type": "simple", "shape": "sphere", "segments": [5, 40])", false},
      {R"("type": "simple", "shape": "sphere", "shading": "flat")", true}};
  for (const char* shape : {"sphere", "cylinder", "cone", "torus"}) {
    for (const int segments : {3, 4, 7, 24, 100}) {
      shapes.push_back({fmt::format(R"("type": "simple", "shape": "{}", "segments": {})", shape, segments), true});
    }
  }
  for (const Shape& shape : shapes) {
    const auto text = [&](std::uint64_t triangles) {
      return document(star("a", R"("number": 120)") + R"("shape": {)" + shape.rows + "}", R"(["a", "shape"])",
                      fmt::format(R"("triangles": {})", triangles));
    };
    Progress progress;
    const Document all = read_document(text(50'000'000), "d.json", builtin_components());
    const std::uint64_t there = grow_document(all, progress, {.up_to = GrownPart::meshes}).meshes.triangle_count();
    EXPECT_EQ(outcome(text(there), GrownPart::meshes), kCancelled) << shape.rows;
    EXPECT_NE(outcome(text(119), GrownPart::meshes), kCancelled) << shape.rows;
    const bool is_refused = outcome(text(there - 1), GrownPart::meshes) != kCancelled;
    EXPECT_TRUE(is_refused || !shape.is_exact) << shape.rows;
  }
}

constexpr const char* kCrown = R"("crown": {"sphere": {"centre": [0, 3, 0], "radius": 2}}, "step": 0.1, "kill": 0.2)";

std::string forest(const std::string& rows) {
  return document(
      star("plot", R"("number": 4)") + fmt::format(R"("oak": {{"type": "colonize", {}, {}}})", kCrown, rows),
      R"(["plot", "oak"])");
}

TEST(CountLimits, PointsOfTreesThatGrowTogetherAreCounted) {
  EXPECT_EQ(outcome(forest(R"("points": 3000000)")),
            Messages{"1.2e+07 attraction points, of which oak 1.2e+07 (100 %), are too many; at most 10000000 "
                     "(limits.points)"});
  EXPECT_EQ(outcome(forest(R"("points": 2500000)")), kCancelled);
  EXPECT_NE(outcome(forest(R"("points": 600000, "roots": [[0, 0, 0], [9, 0, 0], [0, 0, 9], [9, 0, 9], [5, 0, 5]])")),
            kCancelled);
  EXPECT_EQ(outcome(forest(R"("points": 600000, "one_crown": true, "roots": [[0, 0, 0], [9, 0, 0], [0, 0, 9]])")),
            kCancelled);
  EXPECT_EQ(outcome(forest(R"("points": [2600000, 3000000])")).size(), 1U);
  EXPECT_EQ(outcome(forest(R"("points": [10, 6000000])")), kCancelled);
  EXPECT_EQ(outcome(forest(R"("points": 3000000, "alone": true)")), kCancelled) << "one after another";
  EXPECT_EQ(outcome(forest(R"("points": 3000000, "light": {"limit": {"share": 0.5}})")), kCancelled);
}

TEST(CountLimits, PointsOfTreesThatGrowOneAfterAnotherDoNotAddUp) {
  const auto with = [](const std::string& links) {
    return outcome(document(fmt::format(R"("oak": {{"type": "colonize", {0}, "points": 6000000}},
                                           "ivy": {{"type": "colonize", {0}, "points": 6000000}})",
                                        kCrown),
                            links));
  };
  EXPECT_EQ(with("").size(), 1U);
  EXPECT_EQ(with(R"({"from": "oak", "to": "ivy", "kind": "branch", "count": 1})"), kCancelled);
}

TEST(CountLimits, ScatteredPlacesAreCounted) {
  const auto text = [](const std::string& places) {
    return document(fmt::format(R"("sites": {{{}}}, )", places) + kLeaf, R"(["sites", "leaf"])",
                    R"("instances": 1000)");
  };
  const std::string line = R"("type": "places", "line": {"points": [[0, 0], [100, 0]], "spacing": 0.1})";
  EXPECT_EQ(outcome(text(line)),
            Messages{"1003 instances, of which leaf 1001 (100 %), are too many; at most 1000 (limits.instances)"});
  const auto area = [&](double density, const std::string& more = "") {
    return outcome(text(
        fmt::format(R"("type": "places", "area": {{"polygon": [[0, 0], [10, 0], [10, 10], [0, 10]], "density": {}{}}})",
                    density, more)));
  };
  EXPECT_EQ(area(9.9), kCancelled);
  EXPECT_EQ(area(11, R"(, "distance": 0)").size(), 1U);
  EXPECT_EQ(area(40).size(), 1U) << "at least a third of the sites are found";
  EXPECT_EQ(area(40, R"(, "distance": 2)"), kCancelled) << "the distance leaves few sites";
  EXPECT_EQ(outcome(text(R"("type": "places", "area": {"density": 40, "polygon": [[0, 0], [10, 0], [10, 10], [0, 10],
                                                                               [0, 0], [10, 0], [10, 10], [0, 10]]})")),
            kCancelled)
      << "what a polygon covers twice lies outside";
  const auto field = [&](const std::string& gaps) {
    return outcome(text(R"("type": "field", "rows": 100, "plants": 20, "gaps": )" + gaps));
  };
  EXPECT_EQ(field("0.1").size(), 1U);
  EXPECT_EQ(field("0.45"), kCancelled) << "chance may leave less than half";
  EXPECT_EQ(field("0.6"), kCancelled);
}

TEST(CountLimits, SitesWithinObstaclesAreNotCounted) {
  const std::string text = R"({"meristem": 1, "scene": {"obstacles": [{"box": [[1, -1, -1], [2, 1, 1]]}]},
    "components": {"sites": {"type": "places", "line": {"points": [[0, 0], [100, 0]], "spacing": 0.1}},
                   "leaf": {"type": "leaf"}},
    "links": [["sites", "leaf"]], "limits": {"instances": 1000}})";
  EXPECT_EQ(outcome(text), kCancelled);
}

/// A folder with a table of 1,200 places, a skeleton of 3 nodes and a document.
class CountLimitsWithFiles : public testing::Test {
 protected:
  CountLimitsWithFiles() {
    std::string table = "x,z,species,scale\n";
    for (int k = 0; k < 1200; ++k) table += fmt::format("{},0,{},{}\n", k, k % 4 == 0 ? "oak" : "leaf", 1);
    write("places.csv", table);
    write("wood.csv", "x,y,z,radius,parent\n0,0,0,0.1,-1\n0,0,1,0.1,0\n0,0,2,0.1,1\n");
    write("tree.json", R"({"meristem": 1, "components": {"leaf": {"type": "leaf"}}})");
  }

  std::vector<std::string> outcome_of(const std::string& text, GrownPart up_to = GrownPart::plant) const {
    return outcome(read_document(text, (folder_ / "d.json").string(), builtin_components()), {.up_to = up_to});
  }

 private:
  void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  TemporaryFolder folder_;
};

TEST_F(CountLimitsWithFiles, RowsOfTablesAreCounted) {
  EXPECT_EQ(outcome_of(document(R"("sites": {"type": "places", "table": "places.csv"}, )" + std::string(kLeaf),
                                R"(["sites", "leaf"])", R"("instances": 1000)")),
            Messages{"1202 instances, of which leaf 1200 (100 %), are too many; at most 1000 (limits.instances)"});
  const std::string chosen = R"("sites": {"type": "places", "table": "places.csv", "choose": "species"},
                                "oak": {"type": "hydra", "number": 10}, "acorn": {"type": "simple"}, )";
  EXPECT_EQ(outcome_of(document(chosen + kLeaf, R"(["oak", "acorn"])", R"("instances": 2000)")),
            Messages{"4202 instances, of which acorn 3000 (71 %), are too many; at most 2000 (limits.instances)"});
}

TEST_F(CountLimitsWithFiles, NodesOfSkeletonsAreCounted) {
  EXPECT_EQ(outcome_of(document(star("a", R"("number": 500)") + R"("wood": {"type": "skeleton", "file": "wood.csv"})",
                                R"(["a", "wood"])", R"("nodes": 1499)")),
            Messages{"1500 skeleton nodes, of which wood 1500 (100 %), are too many; at most 1499 (limits.nodes)"});
}

TEST_F(CountLimitsWithFiles, DifferentPlantsOfOtherDocumentsAreCounted) {
  const auto with = [&](const std::string& rows) {
    return outcome_of(document(R"("plot": {"type": "field", "rows": 40, "plants": 30},
                                  "oak": {"type": "document", "file": "tree.json")" +
                                   rows + "}",
                               R"(["plot", "oak"])"));
  };
  EXPECT_EQ(with(""), Messages{"1200 different plants of other documents, of which oak 1200 (100 %), are too many; "
                               "at most 1000: \"variants\", or one \"seed\""});
  EXPECT_EQ(with(R"(, "variants": 9)"), kCancelled);
  EXPECT_EQ(with(R"(, "seed": 9)"), kCancelled);
  EXPECT_EQ(with(R"(, "hidden": true)"), kCancelled);
  EXPECT_EQ(with(R"(, "omit": ["i < 1000"])"), kCancelled);
}

TEST(CountLimits, LimitsAlsoBoundTheMemoryOfInstances) {
  // A stem of two nodes takes more memory than limits.instances and limits.nodes stand for.
  const Document stems = read_document(document(R"("field": {"type": "field", "rows": 500, "plants": 1000},
                  "stem": {"type": "tree", "length": 0.1, "segments": 1})",
                                                R"(["field", "stem"])", R"("instances": 500002, "nodes": 1000000)"),
                                       "d.json", builtin_components());
  Progress progress;
  try {
    grow_document(stems, progress, {.up_to = GrownPart::plant});
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("bytes of memory, which are too many"), std::string::npos) << text;
    EXPECT_NE(text.find("160 for each of 500002 (limits.instances)"), std::string::npos) << text;
  }
}

TEST(CountLimits, SitesOfAWideFieldAreNoMemoryThatIsKept) {
  const Document field =
      read_document(document(R"("field": {"type": "field", "rows": 300, "plants": 300}, "leaf": {"type": "leaf"})",
                             R"(["field", "leaf"])", R"("instances": 90002, "nodes": 1)"),
                    "d.json", builtin_components());
  Progress progress;
  EXPECT_EQ(grow_document(field, progress, {.up_to = GrownPart::plant}).plant.organs.size(), 90000U);
  GrowthCache cache;
  EXPECT_EQ(grow_document(field, progress, {.up_to = GrownPart::plant, .cache = &cache}).plant.organs.size(), 90000U);
}

TEST(CountLimits, StemsThatEndWithinTheBarkOfTheirParentBearNothing) {
  const Document trunk = read_document(document(R"("trunk": {"type": "tree", "length": 4, "radius": 2},
                  "spine": {"type": "tree", "length": 0.2, "radius": 0.01}, "leaf": {"type": "leaf"})",
                                                R"({"from": "trunk", "to": "spine", "kind": "branch", "count": 80},
                  {"from": "spine", "to": "leaf", "kind": "branch", "count": 900})",
                                                R"("instances": 1000)"),
                                       "d.json", builtin_components());
  Progress progress;
  EXPECT_EQ(grow_document(trunk, progress, {.up_to = GrownPart::plant}).plant.organs.size(), 0U);
}

}  // namespace meristem::count_limits_test
