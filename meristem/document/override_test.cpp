// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/override.h"

#include <gtest/gtest.h>

#include "meristem/components/colonize.h"
#include "meristem/components/hyperpatch.h"
#include "meristem/components/registry.h"
#include "meristem/document/json.h"

namespace meristem::override_test {

constexpr const char* kOak = R"({
  "meristem": 1,
  "variables": {"age": {"value": 3}, "size": 2},
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[1, 1], [1, 2]]}, "points": 100},
    "leaf": {"type": "leaf", "length": "size", "width": "0.1*age"}
  },
  "links": [["tree", "leaf"], {"from": "tree", "to": "leaf", "kind": "branch", "density": 10}]
})";

Document read_with(const std::vector<std::string>& sets) {
  std::vector<ValueOverride> overrides;
  for (const std::string& set : sets) overrides.push_back(parse_override(set));
  return read_document(kOak, "oak.json", builtin_components(), {.overrides = overrides});
}

std::string error_of(const std::string& set) {
  try {
    read_with({set});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

const Colonize& tree_of(const Document& document) {
  return *static_cast<const Colonize*>(document.graph.components[0].parameters.get());
}

TEST(Override, SetsVariablesInBothForms) {
  const Document document = read_with({"age=20", "size=7"});
  EXPECT_EQ(document.variables[0].value, 20);
  EXPECT_EQ(document.variables[1].value, 7);
}

TEST(Override, SetsParametersOfComponents) {
  const Document document = read_with({"tree.points=50", "tree.step=0.02", "tree.crown.profile[1][0]=3"});
  EXPECT_EQ(tree_of(document).points.count, 50U);
  EXPECT_DOUBLE_EQ(tree_of(document).growth.step, 0.02);
  EXPECT_EQ(tree_of(document).crown->profile[1].x, 3);
}

TEST(Override, LeadsIntoShortForms) {
  const Document document = read_with({"tree.points.blue_noise=true", "variables.size.min=1"});
  EXPECT_EQ(tree_of(document).points.count, 100U) << "the bare number";
  EXPECT_TRUE(tree_of(document).points.blue_noise);
  EXPECT_EQ(document.variables[1].value, 2);
  EXPECT_EQ(document.variables[1].min, 1);
  EXPECT_EQ(tree_of(read_with({"tree.points.count=30"})).points.count, 30U);
  const Document bark = read_with({"tree.texture={\"bark\": \"plated\"}", "tree.texture.bark.scale=2"});
  EXPECT_EQ(tree_of(bark).texture.bark->style, BarkRecipe::Style::plated);
  EXPECT_EQ(tree_of(bark).texture.bark->scale, 2);
  EXPECT_NE(error_of("tree.points.cuont=30").find("did you mean 'count'?"), std::string::npos);
}

TEST(Override, LeadsToControlPoints) {
  const char* const kPatch = R"({"meristem": 1, "components": {"patch": {"type": "hyperpatch", "degree": [1, 1, 1],
    "box": [[0, 0, 0], [1, 1, 1]], "points": [[0, 0, 0], [1, 0, 0], [0, 0, 1], {"at": [1, 0, 1]},
                                              [0, 1, 0], [1, 1, 0], [0, 1, 1], [1, 1, 1]]}}})";
  const auto point = [&](const std::string& set, std::size_t k) {
    const Document document =
        read_document(kPatch, "patch.json", builtin_components(), {.overrides = {parse_override(set)}});
    return static_cast<const Hyperpatch*>(document.graph.components[0].parameters.get())->points[k].at;
  };
  EXPECT_EQ(point("patch.points[4]=[0, 2, 0]", 4), Vec3(0, 2, 0));
  EXPECT_EQ(point("patch.points[4].at=[0, 2, 0]", 4), Vec3(0, 2, 0));
  EXPECT_EQ(point("patch.points[4].at[1]=3", 4), Vec3(0, 3, 0));
  EXPECT_EQ(point("patch.points[3].at[1]=3", 3), Vec3(1, 3, 1));
}

TEST(Override, SetsKeysOfTheDocument) {
  const Document document =
      read_with({"links[1].density=90", "scene.latitude=51.5", "scene.sun.day=172", "output.samples=4",
                 "limits.nodes=1000", "components.tree.points=70", "seed=3", "name=Old oak"});
  EXPECT_EQ(document.graph.links[1].as<BranchLink>()->placement.density, 90);
  EXPECT_EQ(document.output.samples, 4);
  EXPECT_EQ(document.graph.limits.nodes, 1000U);
  EXPECT_EQ(tree_of(document).points.count, 70U);
  EXPECT_GT(document.scene.sun.altitude, 1);
  EXPECT_EQ(document.graph.seed, 3U);
  EXPECT_EQ(document.name, "Old oak");
}

TEST(Override, UsesVariablesInValues) {
  EXPECT_EQ(tree_of(read_with({"age=5", "tree.points=age*10"})).points.count, 50U);
}

TEST(Override, LetsTheLastOneWin) {
  EXPECT_EQ(tree_of(read_with({"tree.points=50", "tree.points=60"})).points.count, 60U);
}

TEST(Override, ReadsValuesAsJsonWhereTheyAreAndAsTextElsewhere) {
  EXPECT_EQ(parse_override("a=1.5").value, Value(1.5));
  EXPECT_EQ(parse_override("a=[1, 2]").value, Value(Value::List{1.0, 2.0}));
  EXPECT_EQ(parse_override("a=\"7\"").value, Value("7"));
  EXPECT_EQ(parse_override("a=b == c").value, Value("b == c"));
  EXPECT_EQ(parse_override("a=").value, Value(""));
  EXPECT_EQ(parse_override("a.b[2].c=1").path, "a.b[2].c");
}

TEST(Override, RejectsTextsThatSetNothing) {
  for (const char* text : {"", "age", "=3"}) {
    try {
      parse_override(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), "'" + std::string(text) +
                                               "' sets nothing; expected NAME=VALUE, such as age=20, stem.length=2 or "
                                               "links[1].density=90");
    }
  }
}

TEST(Override, RefusesPathsThatAreNone) {
  for (const char* path : {"", "a..b", ".x", "x.", "[0]", "x[", "x[1", "x.[0]", "x[0]y"}) {
    try {
      read_document(R"({"meristem": 1, "components": {"c": {"type": "camera"}}})", "d.json", builtin_components(),
                    {.overrides = {ValueOverride{.path = path, .value = Value(1), .name = {}}}});
      ADD_FAILURE() << path;
    } catch (const InputError& error) {
      EXPECT_EQ(error.diagnostics()[0].message, "'" + std::string(path) + "' is not a path");
    }
  }
  EXPECT_EQ(error_of("a..b=3"),
            "--set a..b: a..b: 'a..b' is not a path; expected one such as age, stem.length or links[1].density");
}

TEST(Override, NamesTheNearestVariableAndComponent) {
  EXPECT_EQ(error_of("agee=3"), "--set agee: variables.agee: there is no variable 'agee'; did you mean 'age'?");
  EXPECT_EQ(error_of("wind=3"), "--set wind: variables.wind: there is no variable 'wind'; expected one of age, size");
  EXPECT_EQ(error_of("laef.width=3"),
            "--set laef.width: components.laef.width: there is no component 'laef'; did you mean 'leaf'?");
}

TEST(Override, ReportsUnknownParametersAndBadValuesUnderTheirOwnName) {
  EXPECT_EQ(error_of("leaf.lenght=3"),
            "--set leaf.lenght: components.leaf.lenght: 'lenght' is not a parameter of a leaf; did you mean 'length'?");
  EXPECT_EQ(error_of("leaf.length=-3"),
            "--set leaf.length: components.leaf.length: the value -3 is out of range for "
            "'length'; expected a number (m) from 0.0001 to 100");
  EXPECT_EQ(error_of("age=true"), "--set age: variables.age.value: 'value' cannot be true; expected a number");
  EXPECT_EQ(error_of("leaf.length=2*q"),
            "--set leaf.length: components.leaf.length: 'q' is not a known name; expected a variable or a constant");
}

TEST(Override, PlacesFaultsBelowItsValueToo) {
  EXPECT_EQ(error_of(R"(tree.crown={"profile": [[1, "x"], [1, 2]]})").substr(0, 44),
            "--set tree.crown: components.tree.crown.prof");
}

TEST(Override, LeavesOtherFaultsInTheText) { EXPECT_EQ(error_of("tree.influence=0.01").substr(0, 9), "oak.json:"); }

TEST(Override, RejectsPathsThatLeadNowhere) {
  EXPECT_EQ(error_of("links[2].density=3"),
            "--set links[2].density: links[2].density: there is no element [2] in a list of 2; expected [0] to [1]");
  EXPECT_EQ(error_of("tree[0]=3"), "--set tree[0]: components.tree[0]: there is no element [0] in an object");
  EXPECT_EQ(error_of("links[1].density.count=3"),
            "--set links[1].density.count: links[1].density.count: the number 10 has no member 'count'");
}

TEST(Override, LeavesADocumentThatIsNoObjectToTheReader) {
  try {
    read_document("[1]", "a.json", builtin_components(), {.overrides = {parse_override("age=3")}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "a.json:1:1: the document is a list of 1; expected an object with \"meristem\": 1");
  }
}

}  // namespace meristem::override_test
