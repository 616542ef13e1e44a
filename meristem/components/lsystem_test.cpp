// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/lsystem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_skeleton.h"

namespace meristem::lsystem_test {

using testing::HasSubstr;

GraphBuilder plant_of(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("plant", "lsystem", parameters).link("view", "plant");
  return builder;
}

const Skeleton& only_skeleton(const Plant& plant) {
  EXPECT_EQ(plant.stems.size(), 1U);
  return plant.stems.at(0).skeleton;
}

TEST(Lsystem, GrowsTheWordAfterItsSteps) {
  const Plant plant = plant_of({{"grammar", "F\n#rules\nF -> F[+F]F[-F]F\n"}, {"steps", 2}}).grow();
  const Skeleton& skeleton = only_skeleton(plant);
  EXPECT_TRUE(check_skeleton(skeleton));
  EXPECT_EQ(skeleton.node_count(), 26U);
  EXPECT_EQ(*std::ranges::max_element(skeleton.order), 2);
}

TEST(Lsystem, TakesTextAlsoAsLines) {
  const Value::Object as_text{{"grammar", "F\n#rules\nF -> FF\n"}, {"steps", 3}};
  const Value::Object as_lines{{"grammar", Value::List{"F", "#rules", "F -> FF"}}, {"steps", 3}};
  EXPECT_EQ(hash_of(plant_of(as_text).grow()), hash_of(plant_of(as_lines).grow()));
}

TEST(Lsystem, ParametersGoBeforeTheGrammarsDirectives) {
  const char* grammar = "#steps 3\n#angle 30\n#axiom\nF+F\n#rules\nF -> FF\n";
  const Plant by_grammar = plant_of({{"grammar", grammar}}).grow();
  EXPECT_EQ(only_skeleton(by_grammar).node_count(), 17U);
  const Plant by_document = plant_of({{"grammar", grammar}, {"steps", 0}, {"angle", 90}, {"length", 1}}).grow();
  const Skeleton& skeleton = only_skeleton(by_document);
  ASSERT_EQ(skeleton.node_count(), 3U);
  EXPECT_LT(glm::distance(skeleton.position[2], Vec3(-1, 1, 0)), 1e-6F);
}

TEST(Lsystem, VariablesAreConstantsOfItsExpressions) {
  GraphBuilder builder(builtin_components());
  builder.variable("height", 3).component("view", "camera");
  builder.component("plant", "lsystem", {{"grammar", "#define height 1\nF(height)\n"}, {"steps", 0}});
  const Plant plant = builder.link("view", "plant").grow();
  EXPECT_FLOAT_EQ(only_skeleton(plant).position[1].y, 3);
}

TEST(Lsystem, PolygonsOfOneShapeAreOneBlade) {
  const Plant plant =
      plant_of({{"grammar", "[{-f(1)+f(1)+f(1)-|-f(1)+f(1)+f(1)}]F(2)&+(40){-f(3)+f(3)+f(3)-|-f(3)+f(3)+f(3)}"},
                {"steps", 0},
                {"palette", Value::List{"#ff0000"}}})
          .grow();
  EXPECT_EQ(prototypes_of(plant, "plant").size(), 1U);
  const std::vector<Organ> blades = organs_of(plant, "plant");
  ASSERT_EQ(blades.size(), 2U);
  EXPECT_NEAR(glm::length(blades[1].frame.heading()) / glm::length(blades[0].frame.heading()), 3, 1e-5);
  EXPECT_LT(glm::distance(blades[1].frame.origin, Vec3(0, 2, 0)), 1e-5F);
  ASSERT_EQ(plant.materials.size(), 2U);
  EXPECT_EQ(plant.materials[1].name, "plant_blades");
  EXPECT_TRUE(plant.materials[1].two_sided);
  const Vec3 red = blades[0].tint * plant.materials[1].tint();
  EXPECT_LT(glm::distance(red, Vec3(1, 0, 0)), 1e-5F);
}

TEST(Lsystem, SmallPolygonsFarFromTheirBeginningKeepTheirCorners) {
  const Plant plant = plant_of({{"grammar", "{g(10).g(0.005).+(90)g(0.005).}"}, {"steps", 0}}).grow();
  const std::vector<Organ> blades = organs_of(plant, "plant");
  ASSERT_EQ(blades.size(), 1U);
  float highest = 0;
  for (const Vec3 corner : prototypes_of(plant, "plant")[0].mesh->positions) {
    highest = std::max(highest, blades[0].frame.point(corner).y);
  }
  EXPECT_NEAR(highest, 10.005F, 2e-6F);
}

TEST(Lsystem, StepsMayRiseWithTime) {
  const GraphBuilder builder = plant_of({{"grammar", "F\n#rules\nF -> FF\n"}, {"steps", "floor(2*t)"}});
  EXPECT_EQ(only_skeleton(builder.grow(0)).node_count(), 2U);
  EXPECT_EQ(only_skeleton(builder.grow(1.6)).node_count(), 9U);
}

TEST(Lsystem, BranchLinksPlaceChildrenAlongItsTwigs) {
  GraphBuilder builder = plant_of({{"grammar", "FFFFFFFF[+F]F"}, {"steps", 0}, {"length", 0.1}});
  builder.component("leaf", "leaf", {}).link("plant", "leaf", LinkKind::branch, {{"density", 100}});
  const std::vector<Organ> leaves = organs_of(builder.grow(), "leaf");
  ASSERT_FALSE(leaves.empty());
  for (const Organ& leaf : leaves) EXPECT_GT(leaf.frame.origin.y, 0.39F) << "none on the trunk by default";
}

TEST(Lsystem, HasTheSameBytesOnAnyNumberOfThreads) {
  const GraphBuilder builder = plant_of(
      {{"grammar", "A\n#rules\nA : * : 2 -> F(ran(1))[+(nran(30,5))A]A\nA : * : 1 -> F[-A]A\n"}, {"steps", 9}});
  std::string one;
  {
    const ThreadLimit limit(1);
    one = hash_of(builder.grow());
  }
  const ThreadLimit limit(8);
  EXPECT_EQ(hash_of(builder.grow()), one);
}

constexpr const char* kWinding = "!(0.04)FF-FF!(0.02)F+FF[+F+!(0.01)FF]FF-F'{FFF+FF+F}F[]FF+FF!(0.005)FF";

TEST(Lsystem, FinishKeepsRadiiOrdersAndMarkedEnds) {
  const auto grown = [](const Value::Object& finish) {
    Value::Object parameters{{"grammar", kWinding}, {"steps", 0}, {"length", 0.1}};
    if (!finish.empty()) parameters.emplace_back("finish", finish);
    return plant_of(parameters).grow();
  };
  const auto count_ends = [](const Skeleton& skeleton) {
    return std::ranges::count(skeleton.extra.find("end")->second, 1);
  };
  const Plant drawn = grown({});
  const Plant finished = grown({{"decimate", 3}, {"subdivide", 0.5}});
  const Skeleton& raw = only_skeleton(drawn);
  const Skeleton& fine = only_skeleton(finished);
  EXPECT_TRUE(check_skeleton(fine));
  EXPECT_GT(fine.node_count(), raw.node_count());
  EXPECT_EQ(count_ends(fine), count_ends(raw));
  EXPECT_EQ(*std::ranges::max_element(fine.axis), *std::ranges::max_element(raw.axis));
  EXPECT_EQ(*std::ranges::max_element(fine.radius), *std::ranges::max_element(raw.radius));
  EXPECT_EQ(fine.radius.back(), raw.radius.back());
  EXPECT_LT(only_skeleton(grown({{"decimate", 3}, {"relax", false}})).node_count(), raw.node_count());
}

TEST(Lsystem, FinishMovesPolygonsWithTheirNodes) {
  // A right angle with a polygon at its corner. Relaxing moves the corner half way to the root.
  const auto polygon_of = [](bool relax) {
    const Plant plant = plant_of({{"grammar", "F-(90){.f.+(90)f.}[F]FF"},
                                  {"steps", 0},
                                  {"length", 0.1},
                                  {"finish", Value::Object{{"relax", relax}, {"decimate", 50}}}})
                            .grow();
    return organs_of(plant, "plant").at(0).frame.origin;
  };
  EXPECT_LT(glm::distance(polygon_of(false), Vec3(0, 0.1F, 0)), 1e-6F);
  EXPECT_LT(glm::distance(polygon_of(true), Vec3(0, 0.05F, 0)), 1e-6F);
}

std::string error_of(const Value::Object& parameters) {
  std::string text;
  for (const Diagnostic& error : errors_of([&] { plant_of(parameters).grow(); })) text += error.text() + "\n";
  return text;
}

TEST(Lsystem, SaysWhatIsWrong) {
  EXPECT_THAT(error_of({{"grammar", "F"}}), HasSubstr("the number of steps of the grammar is not given"));
  EXPECT_THAT(error_of({{"steps", 1}}), HasSubstr("grammar"));
  EXPECT_THAT(error_of({{"grammar", 3}, {"steps", 1}}), HasSubstr("a text or a list of its lines"));
  EXPECT_THAT(error_of({{"grammar", Value::List{"F", 3}}, {"steps", 1}}), HasSubstr("a text or a list of its lines"));
  EXPECT_THAT(error_of({{"grammar", "F"}, {"steps", 1}, {"stack_angles", false}}), HasSubstr("\"turtle\": \"polar\""));
  EXPECT_THAT(error_of({{"grammar", "F"}, {"steps", 1}, {"turtle", "polar"}, {"elasticity", 0.2}}),
              HasSubstr("\"turtle\": \"frame\""));
  EXPECT_THAT(error_of({{"grammar", "Ff}"}, {"steps", 0}}), HasSubstr("components.plant: module 3 of the word"));
  EXPECT_THAT(error_of({{"grammar", "F"}, {"steps", 0}, {"length", 0}, {"finish", Value::Object{{"subdivide", 1}}}}),
              HasSubstr("'finish' counts in steps of 'length', which is 0"));
}

TEST(Lsystem, ALengthOf0Warns) {
  const auto warnings_of = [](const Value::Object& parameters) {
    ParameterReader reader({}, SizeLimits());
    const ComponentType type = lsystem_component();
    const std::shared_ptr<void> plant = type.make_parameters();
    reader.read_varying(type.parameters, plant.get(), parameters, DocumentPath());
    std::vector<std::string> texts;
    for (const Diagnostic& warning : reader.take_diagnostics()) {
      EXPECT_EQ(warning.severity, Severity::warning);
      texts.push_back(warning.path + ": " + warning.message);
    }
    return texts;
  };
  const char* message =
      "length: 'length' is 0, and the grammar has F, G, f or g without a parameter, which then draw nothing";
  for (const char* grammar : {"F", "A\n#rules\nA -> [+f]A", "A\n#interpret\nA -> G"}) {
    EXPECT_EQ(warnings_of({{"grammar", grammar}, {"steps", 1}, {"length", 0}}), std::vector<std::string>{message});
    EXPECT_EQ(warnings_of({{"grammar", grammar}, {"steps", 1}}), std::vector<std::string>{});
  }
  EXPECT_EQ(warnings_of({{"grammar", "F(0.3)[+F(0.2)]"}, {"steps", 1}, {"length", 0}}), std::vector<std::string>{});
}

TEST(Lsystem, OneAgeDrivesStepsLeavesAndTheirSize) {
  const auto grown_at = [](int age) {
    GraphBuilder builder(builtin_components());
    builder.variable("age", age).component("view", "camera");
    builder.component("tree", "lsystem", {{"grammar", "A\n#rules\nA -> F[&(40)A]/(180)A"}, {"steps", "age"}});
    builder.component("leaf", "leaf", {{"length", "0.05 + 0.005*age"}, {"width", 0.03}});
    builder.link("view", "tree").link("tree", "leaf", LinkKind::branch, {{"density", "4*age"}});
    return builder.grow();
  };
  const Plant young = grown_at(3);
  const Plant old = grown_at(6);
  const auto leaves_per_node = [](const Plant& plant) {
    return static_cast<double>(plant.organs.size()) / static_cast<double>(only_skeleton(plant).node_count());
  };
  EXPECT_NEAR(leaves_per_node(old) / leaves_per_node(young), 2, 0.5);
  const auto length_of = [](const Plant& plant) {
    Box box;
    for (const Vec3 position : plant.prototypes.at(0).mesh->positions) box.add(position);
    return box.size().y * glm::length(plant.organs.at(0).frame.heading());
  };
  EXPECT_GT(length_of(old), length_of(young));
}

TEST(Lsystem, FaultsOfADerivationNameTheRulesLine) {
  EXPECT_THAT(error_of({{"grammar", "A(1)\n#rules\nA(x) -> A(1/(1-x))\n"}, {"steps", 2}}),
              HasSubstr("components.plant.grammar: line 3 of the grammar"));
}

TEST(Lsystem, StopsBeforeAnExplosionTakesMemory) {
  EXPECT_THAT(error_of({{"grammar", "F\n#rules\nF -> FFFFFFFFFF\n"}, {"steps", 40}}), HasSubstr("limits.modules"));
}

}  // namespace meristem::lsystem_test
