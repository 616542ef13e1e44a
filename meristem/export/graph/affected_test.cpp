// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/graph/affected.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/export/graph/graph_drawing.h"

namespace meristem::affected_test {

/// Two trees that compete, each with its leaves, and a bench that stands apart.
Document garden() {
  return read_document(R"json({"meristem": 1,
    "variables": {"size": 1, "leafiness": "2*size", "shade": 0.5, "cloudy": 0.5},
    "scene": {"sky": "cloudy"},
    "components": {
      "oak": {"type": "colonize", "points": 20, "crown": {"sphere": {"centre": [0, 2, 0], "radius": "size"}}},
      "elm": {"type": "colonize", "points": 20, "crown": {"sphere": {"centre": [0, 2, 0], "radius": 1}}},
      "cloud": {"type": "cloud", "of": "elm"},
      "leaf": {"type": "leaf", "length": 0.1, "roughness": "shade"},
      "needle": {"type": "leaf", "length": 0.1},
      "bench": {"type": "simple"},
      "cup": {"type": "simple"}},
    "links": [{"from": "oak", "to": "leaf", "kind": "branch", "density": "leafiness"},
              {"from": "elm", "to": "needle", "kind": "branch", "count": 3}, ["bench", "cup"]]})json",
                       "garden.json", builtin_components());
}

/// Returns a letter for each component: o has or uses the value, i inherits its effect, - neither.
std::string effects(const std::string& path) {
  std::string text;
  for (const GraphEffect effect : affected_by(garden(), path)) {
    text += effect == GraphEffect::own ? 'o' : effect == GraphEffect::inherited ? 'i' : '-';
  }
  return text;
}

//                                           oak, elm, cloud, leaf, needle, bench, cup, camera
TEST(AffectedBy, AParameterAffectsItsComponentAndTheDescendants) {
  EXPECT_EQ(effects("bench.size"), "-----oi-");
  EXPECT_EQ(effects("components.bench.size[1]"), "-----oi-");
  EXPECT_EQ(effects("bench"), "-----oi-");
  EXPECT_EQ(effects("leaf.length"), "---o----");
}

TEST(AffectedBy, LooksAffectTheComponentAlone) {
  EXPECT_EQ(effects("bench.colour"), "-----o--");
  EXPECT_EQ(effects("shade"), "---o----");
}

TEST(AffectedBy, GrowthAffectsPlantsBesideItAndComponentsThatShowThem) { EXPECT_EQ(effects("oak.points"), "oiiii---"); }

TEST(AffectedBy, AVariableAffectsAllThatUseItThroughOtherVariables) {
  EXPECT_EQ(effects("leafiness"), "---o----");
  EXPECT_EQ(effects("variables.leafiness.value"), "---o----");
  EXPECT_EQ(effects("size"), "oiioi---");
}

TEST(AffectedBy, AVariableOfTheSceneAffectsAllPlants) { EXPECT_EQ(effects("cloudy"), "iiiiiii-"); }

TEST(AffectedBy, AKeyOfALinkAffectsItsChild) { EXPECT_EQ(effects("links[1].count"), "----o---"); }

TEST(AffectedBy, WrongNamesAreRefusedWithTheNearest) {
  const auto error = [](const std::string& path) {
    try {
      affected_by(garden(), path);
    } catch (const InputError& found) {
      return std::string(found.what());
    }
    return std::string();
  };
  EXPECT_EQ(error("leaf.lenght"), "leaf.lenght: 'lenght' is not a parameter of a leaf; did you mean 'length'?");
  EXPECT_NE(error("lef.length").find("did you mean 'leaf'?"), std::string::npos);
  EXPECT_NE(error("links[7].count").find("the document has no value 'links[7].count'"), std::string::npos);
  EXPECT_NE(error("links[x]").find("no value"), std::string::npos);
}

TEST(AffectedBy, DrawingsHighlightTheComponents) {
  const Document document = garden();
  const std::string svg = draw_graph(document.graph, {.effects = affected_by(document, "bench.size")});
  const auto first = svg.find("#f2b84b");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(svg.find("#f2b84b", first + 1), std::string::npos) << "one component has the parameter";
  EXPECT_NE(svg.find("#fbe9c6"), std::string::npos);
  EXPECT_EQ(draw_graph(document.graph).find("#f2b84b"), std::string::npos);
}

}  // namespace meristem::affected_test
