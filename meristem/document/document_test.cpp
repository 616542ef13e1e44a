// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/document.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/leaf.h"
#include "meristem/components/registry.h"
#include "meristem/graph/instances.h"

namespace meristem::document_test {

Document read(const std::string& text) { return read_document(text, "d.json", builtin_components()); }

/// All faults, one per line.
std::string errors_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

/// A good document of one box and one leaf with further members, "" or "\"seed\": 3,".
std::string with(const std::string& members, const std::string& components = R"("box": {"type": "simple"})") {
  return "{\"meristem\": 1,\n" + members + "\n\"components\": {" + components + "}}";
}

/// A document with these links between the components `tree` and `leaf`.
std::string linked(const std::string& links) {
  return with("\"links\": [" + links + "],",
              R"("tree": {"type": "colonize", "crown": {"profile": [[1, 1], [1, 2]]}}, "leaf": {"type": "leaf"})");
}

TEST(Document, SupportsOfNoLengthAreFaults) {
  const auto found = [](const std::string& support) {
    return errors_of(with("\"scene\": {\"supports\": {\"w\": " + support + "}},"));
  };
  for (const char* const support : {"[[0, 1, 0], [0, 1, 0]]", R"({"line": [[0, 1, 0], [0, 1, 0]]})"}) {
    EXPECT_NE(found(support).find("scene.supports.w.line[1]: the support has no length here"), std::string::npos)
        << found(support);
  }
  EXPECT_NE(found("[[0, 1, 0]]").find("scene.supports.w.line: the line has fewer than two points"), std::string::npos);
  EXPECT_EQ(found("[[0, 1, 0], [0, 2, 0]]"), "no fault");
}

TEST(Document, ReadsItsHead) {
  const Document document = read(with(
      R"("name": "Oak", "description": "d", "author": "a", "licence": "l", "seed": 9, "output": {"size": [3, 4], "samples": 5, "lod": 3},)"));
  EXPECT_EQ(document.name, "Oak");
  EXPECT_EQ(document.description, "d");
  EXPECT_EQ(document.author, "a");
  EXPECT_EQ(document.licence, "l");
  EXPECT_EQ(document.graph.seed, 9U);
  EXPECT_EQ(document.output.size, (std::vector<int>{3, 4}));
  EXPECT_EQ(document.output.samples, 5);
  EXPECT_EQ(document.output.lod, 3);
  EXPECT_TRUE(document.warnings.empty());
}

TEST(Document, TakesTheCallersSeedBeforeItsOwn) {
  EXPECT_EQ(read_document(with("\"seed\": 3,"), "d", builtin_components(), {.seed = 8}).graph.seed, 8U);
}

TEST(Document, KnowsVariablesInEveryExpression) {
  const Document document = read(with(R"("variables": {"size": {"value": "2*3", "unit": "m"}},)",
                                      R"("leaf": {"type": "leaf", "length": "size/2"})"));
  EXPECT_EQ(document.variables[0].value, 6);
  EXPECT_EQ(document.variables[0].unit, "m");
  EXPECT_EQ(static_cast<const Leaf*>(document.graph.components[0].parameters.get())->blade.length, 3);
}

TEST(Document, LeavesRoomForTheValueWhereBoundsAreNotGiven) {
  const Document document =
      read(with(R"("variables": {"a": 12, "b": {"value": -2, "max": 5}, "c": {"value": 3, "min": 2}},)"));
  const auto bounds = [&](int k) { return std::pair(document.variables[k].min, document.variables[k].max); };
  EXPECT_EQ(bounds(0), std::pair(0.0, 12.0));
  EXPECT_EQ(bounds(1), std::pair(-2.0, 5.0));
  EXPECT_EQ(bounds(2), std::pair(2.0, 3.0));
}

TEST(Document, ReportsAllFaultsAtOnceWithTheirPlaces) {
  EXPECT_EQ(
      errors_of(R"({
  "meristem": 1,
  "sede": 3,
  "scene": {"latitude": 99},
  "components": {
    "leaf": {"type": "leaf", "lenght": 3, "width": "2*("},
    "tre": {"type": "colonise"}
  },
  "links": [["leaf", "tree"]]
})"),
      "d.json:3:3: sede: 'sede' is not a parameter of a document; did you mean 'seed'?\n"
      "d.json:4:25: scene.latitude: the value 99 is out of range for 'latitude'; expected a number (°) from -90 to 90\n"
      "d.json:6:30: components.leaf.lenght: 'lenght' is not a parameter of a leaf; did you mean 'length'?\n"
      "d.json:6:56: components.leaf.width: the expression ends where a value should follow; expected a number, a name "
      "or '('\n"
      "d.json:7:21: components.tre.type: 'colonise' is not a type of component; did you mean 'colonize'?\n"
      "d.json:9:22: links[0][1]: there is no component 'tree'; did you mean 'tre'?");
}

std::string type_names() { return fmt::format("{}", fmt::join(builtin_components().names(), ", ")); }

struct Rejection {
  const char* about;
  std::string text;
  std::string error;
};

class RejectedDocument : public testing::TestWithParam<Rejection> {};

TEST_P(RejectedDocument, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(errors_of(GetParam().text), "d.json:" + GetParam().error);
}

const Rejection kRejections[] = {
    {"NoObject", "[1]", "1:1: the document is a list of 1; expected an object with \"meristem\": 1"},
    {"NewerFormat", R"({"meristem": 2, "future": []})",
     "1:14: meristem: the document's format 2 is newer than this program; expected at most 1"},
    {"NoFormat", R"({"components": {"a": {"type": "simple"}}})",
     "1:1: a document has no 'meristem'; expected a whole number from 1 to 1"},
    {"NoComponents", R"({"meristem": 1})",
     R"(1:1: the document has no components; expected an object such as "components": {"tree": {"type": "colonize", ...}})"},
    {"EmptyComponents", R"({"meristem": 1, "components": {}})",
     R"(1:31: components: the document has no components; expected an object such as "components": {"tree": {"type": "colonize", ...}})"},
    {"ComponentsAsList", R"({"meristem": 1, "components": [1]})",
     R"(1:31: components: the components are a list of 1; expected an object such as "components": {"tree": {"type": "colonize", ...}})"},
    {"BadId", with("", R"("a-b": {"type": "simple"})"),
     "3:16: components.a-b: 'a-b' cannot name a component; expected letters, digits and _"},
    {"NoType", with("", R"("a": {})"),
     "3:21: components.a: 'a' has no type; expected a \"type\": one of " + type_names()},
    {"ComponentAsNumber", with("", R"("a": 3)"),
     "3:21: components.a: a component cannot be the number 3; expected a \"type\": one of " + type_names()},
    {"UnknownChoice", with("", R"("a": {"type": "simple", "shape": "bax"})"),
     "3:49: components.a.shape: 'bax' is not a value of 'shape'; expected one of box, sphere, cylinder, cone, "
     "torus, none, area, tube; "
     "did "
     "you mean 'box'?"},
    {"NestedUnknownKey", with("", R"("a": {"type": "simple", "place": {"rotat": [0, 0, 0]}})"),
     "3:50: components.a.place.rotat: 'rotat' is not a parameter of a transform; did you mean 'rotate'?"},
    {"VectorOfTwo", with("", R"("a": {"type": "simple", "size": [1, 2]})"),
     "3:48: components.a.size: 'size' cannot be a list of 2; expected a list of three numbers [x, y, z] from 1e-06 to "
     "10000"},
    {"Colour", with("", R"("a": {"type": "simple", "colour": "green"})"),
     "3:50: components.a.colour: 'green' is not a colour; expected a colour such as \"#6b8e23\""},
    {"Fraction", with("\"seed\": 1.5,"),
     "2:9: seed: 'seed' cannot be the fraction 1.5; expected a whole number from 0 to 9007199254740992"},
    {"TextAsNumber", with("\"name\": 3,"), "2:9: name: 'name' cannot be the number 3; expected a text"},
    {"OutputSize", with("\"output\": {\"size\": [0, 10]},"),
     "2:21: output.size[0]: the value 0 is out of range for 'size'; expected a whole number from 1 to 16384"},
    {"Limits", with("\"limits\": {\"nodes\": 0},"),
     "2:21: limits.nodes: the value 0 is out of range for 'nodes'; expected a whole number from 1 to 4000000000"},
    {"UnknownLimit", with("\"limits\": {\"node\": 3},"),
     "2:12: limits.node: 'node' is not a parameter of limits; did you mean 'nodes'?"},
    {"VariablesAsList", with("\"variables\": [],"),
     "2:14: variables: the variables are an empty list; expected an object of names"},
    {"VariableName", with("\"variables\": {\"2a\": 3},"),
     "2:15: variables.2a: '2a' is not a name; expected letters, digits and _, not beginning with a digit"},
    {"VariableNameBesideExpressions", with("\"variables\": {\"2 a\": 3}, \"seed\": \"1+1\","),
     "2:15: variables.2 a: '2 a' is not a name; expected letters, digits and _, not beginning with a digit"},
    {"VariableShadowsFunction", with("\"variables\": {\"sin\": 3},"),
     "2:15: variables.sin: 'sin' already has a meaning in expressions; expected another name"},
    {"VariableShadowsSite", with("\"variables\": {\"u\": 3},"),
     "2:15: variables.u: 'u' already has a meaning in expressions; expected another name"},
    {"VariableShadowsPlacement", with("\"variables\": {\"tip_distance\": 3},"),
     "2:15: variables.tip_distance: 'tip_distance' already has a meaning in expressions; expected another name"},
    {"VariableWithoutValue", with("\"variables\": {\"a\": {\"min\": 0}},"),
     "2:20: variables.a: a variable has no 'value'; expected a number"},
    {"VariableBounds", with("\"variables\": {\"a\": {\"value\": 1, \"min\": 5, \"max\": 2}},"),
     "2:40: variables.a.min: 'min' 5 lies above 'max' 2; expected a 'min' of at most 'max'"},
    {"SunTwice", with(R"("scene": {"latitude": 5, "sun": {"day": 1, "azimuth": 1, "altitude": 2}},)"),
     "2:33: scene.sun: the sun is given both by its position and by a day; expected {\"azimuth\": 180, \"altitude\": "
     "61} "
     "or "
     "{\"day\": 126, \"hour\": 9.5}"},
    {"SunHalf", with(R"("scene": {"sun": {"azimuth": 1}},)"),
     "2:18: scene.sun: the sun has only one of 'azimuth' and 'altitude'; expected both, as in {\"azimuth\": 180, "
     "\"altitude\": "
     "61}"},
    {"DayWithoutLatitude", with(R"("scene": {"sun": {"day": 1}},)"),
     "2:18: scene.sun: a sun with a day needs a latitude; expected \"latitude\" in the scene"},
    {"LinksAsObject", with("\"links\": {},"),
     "2:10: links: the links are an object; expected a list such as [[\"view\", \"tree\"]]"},
    {"LinkOfThree", linked(R"(["tree", "leaf", "leaf"])"),
     "2:11: links[0]: a link is a list of 3; expected a pair [\"from\", \"to\"]"},
    {"LinkAsText", linked(R"("tree")"),
     "2:11: links[0]: a link cannot be the text 'tree'; expected [\"from\", \"to\"] or {\"from\": ..., \"to\": ..., "
     "\"kind\": ...}"},
    {"LinkToNumber", linked(R"(["tree", 3])"),
     "2:20: links[0][1]: the end of a link cannot be the number 3; expected the id of a component"},
    {"DanglingLink", linked(R"(["tree", "lea"])"),
     "2:20: links[0][1]: there is no component 'lea'; did you mean 'leaf'?"},
    {"LinkWithoutEnd", linked(R"({"from": "tree"})"),
     "2:11: links[0]: the link has no 'to'; expected the id of a component"},
    {"LinkKind", linked(R"({"from": "tree", "to": "leaf", "kind": "brunch", "density": 3})"),
     "2:50: links[0].kind: 'brunch' is not a value of 'kind'; expected one of child, branch, leaf, crown; did you mean "
     "'branch'?"},
    {"LinkKey", linked(R"({"from": "tree", "to": "leaf", "kind": "branch", "densty": 3})"),
     "2:60: links[0].densty: 'densty' is not a parameter of a branch link; did you mean 'density'?"},
    {"PlacementOnChildLink", linked(R"({"from": "tree", "to": "leaf", "density": 3})"),
     "2:42: links[0].density: 'density' belongs to branch links; expected \"kind\": \"branch\", or no such key"},
    {"PlacementWithoutStems", linked(R"({"from": "leaf", "to": "tree", "kind": "branch", "density": 3})"),
     "2:60: links[0].density: 'density' has no meaning here, since 'leaf' makes no stems; expected a link from a "
     "component "
     "with stems"},
    {"DensityAndCount", linked(R"({"from": "tree", "to": "leaf", "kind": "branch", "density": 3, "count": 4})"),
     "2:83: links[0].count: there is both a density and a count; expected one of them"},
    {"WhereOfUnknown", linked(R"({"from": "tree", "to": "leaf", "kind": "branch", "where": "tip_distanc < 1"})"),
     "2:70: links[0].where: 'tip_distanc' is not a known name; expected a variable or a constant; did you mean "
     "'tip_distance'?"},
    {"ExpressionFault", with("", R"j("leaf": {"type": "leaf", "curl": "20 + 15*rnd(-1,1)"})j"),
     "3:58: components.leaf.curl: 'rnd' is not a function; expected a function; did you mean 'rand'?"},
    {"EmptyCrown", with("", R"("t": {"type": "colonize", "crown": {"profile": [[0, 0], [0, 1]]}})"),
     "3:63: components.t.crown.profile: the crown is empty: all its radii are 0; expected a radius above 0 somewhere"},
    {"ZeroStep", with("", R"("t": {"type": "colonize", "crown": {"profile": [[1, 0], [1, 1]]}, "step": 0})"),
     "3:90: components.t.step: the value 0 is out of range for 'step'; expected a number (m) above 0 to 1000"},
    {"TooManyPoints", with("", R"("t": {"type": "colonize", "crown": {"profile": [[1, 0], [1, 1]]}, "points": 1e9})"),
     "3:92: components.t.points: 1000000000 attraction points are too many; expected at most 10000000 (limits.points)"},
};

INSTANTIATE_TEST_SUITE_P(Document, RejectedDocument, testing::ValuesIn(kRejections),
                         [](const auto& test) { return test.param.about; });

TEST(Document, ARecursionByAVariableMayBe1) {
  const auto instances = [](int depth) {
    const std::string tower = R"("floor": {"type": "simple", "recursion": "storeys"}, "roof": {"type": "simple"})";
    const std::string links = R"("links": [["floor", "floor"], {"from": "floor", "to": "roof", "kind": "leaf"}],)";
    const Document document = read(with(fmt::format(R"("variables": {{"storeys": {}}}, {})", depth, links), tower));
    Progress progress;
    return instance_tree(document.graph, document.scene, 0, 100, progress).instances.size();
  };
  EXPECT_EQ(instances(3), 1U + 3 + 1);
  EXPECT_EQ(instances(1), 1U + 1 + 1) << "a floor and the roof";
}

TEST(Document, RejectsLinksThatMakeNoTree) {
  const std::string two = R"("a": {"type": "simple"}, "b": {"type": "simple"})";
  const std::string cameras = two + R"(, "c": {"type": "camera"}, "d": {"type": "camera"})";
  EXPECT_NE(errors_of(with("", cameras)).find("'d' is a second camera beside 'c'"), std::string::npos);
  EXPECT_NE(errors_of(with(R"("links": [["a", "c"]],)", two + R"(, "c": {"type": "camera"})"))
                .find("d.json:2:11: links[0]: the link leads to the camera 'c'"),
            std::string::npos);
  EXPECT_NE(errors_of(with(R"("links": [["a", "b"], ["b", "a"]],)", two))
                .find("d.json:2:23: links[1]: the links a > b > a form an endless circle"),
            std::string::npos);
  EXPECT_NE(errors_of(with(R"("links": [["c", "a"]],)", two + R"(, "c": {"type": "camera"})"))
                .find("components.b: 'b' cannot be reached from the camera by links"),
            std::string::npos);
}

TEST(Document, GetsACameraThatLinksToAllWithoutAParent) {
  const Document document = read(with(
      R"("links": [["a", "b"]],)", R"("a": {"type": "simple"}, "b": {"type": "simple"}, "camera": {"type": "leaf"})"));
  const Graph& graph = document.graph;
  ASSERT_EQ(graph.components.size(), 4U);
  EXPECT_EQ(graph.components[3].id, "camera_");
  EXPECT_EQ(document.graph.structure.root, 3U);
  ASSERT_EQ(graph.links.size(), 3U);
  EXPECT_EQ(graph.links[1].to, 0U);
  EXPECT_EQ(graph.links[2].to, 2U);
}

TEST(Document, HangsAComponentWhoseOnlyParentIsItselfOnTheCamera) {
  const Document document = read(with(R"("links": [["b", "a"], ["a", "b"]],)",
                                      R"("a": {"type": "simple"}, "b": {"type": "simple", "recursion": 4})"));
  ASSERT_EQ(document.graph.links.size(), 3U);
  EXPECT_EQ(document.graph.links[2].to, 1U) << "b, which recurses";
  EXPECT_EQ(document.graph.structure.recursions.size(), 1U);
}

TEST(Document, StopsAtTheLimitOfFaultsAndCountsTheRest) {
  std::string links;
  for (int k = 0; k < 30; ++k) links += fmt::format("{}[\"tree\", \"nowhere{}\"]", k == 0 ? "" : ", ", k);
  std::string text = linked(links);
  text.insert(text.find("\"links\""), R"("limits": {"diagnostics": 7}, "variables": {"1": 1, "2": 2, "3": 3}, )");
  try {
    read(text);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 8U);
    EXPECT_EQ(error.diagnostics().back().message, "and 26 more faults");
  }
}

TEST(Document, CountsFaultsOfTheStructureTowardsTheLimit) {
  std::string components = R"("camera": {"type": "camera"})";
  for (int k = 0; k < 20; ++k) components += fmt::format(", \"c{}\": {{\"type\": \"simple\"}}", k);
  try {
    read(with("\"limits\": {\"diagnostics\": 5},", components));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_LE(error.diagnostics().size(), 6U);
  }
}

TEST(Document, KeepsWarningsWithinTheLimitWithoutRefusing) {
  const Document document =
      read(with(R"("limits": {"diagnostics": 1}, "scene": {"sun": {"azimuth": 0, "altitude": -3}},)"));
  EXPECT_EQ(document.warnings.size(), 1U);
}

TEST(ReadTextFile, FailsForPathsThatAreNoFiles) {
  EXPECT_THROW(read_text_file("/nowhere/a.json"), MachineError);
  EXPECT_THROW(read_text_file("/"), MachineError);
}

}  // namespace meristem::document_test
