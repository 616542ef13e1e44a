// SPDX-License-Identifier: Apache-2.0
// Grammars in documents: where their faults are, and the components that they place.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "tests/support/build_graph.h"
#include "tests/support/temporary_folder.h"

namespace meristem::lsystem_document_test {

using testing::HasSubstr;

Document read(const std::string& text, const std::string& file = "d.json") {
  return read_document(text, file, builtin_components());
}

std::string errors_of_text(const std::string& text, const std::string& file = "d.json") {
  std::string errors;
  for (const Diagnostic& error : errors_of([&] { read(text, file); })) errors += error.text() + "\n";
  return errors;
}

GrownDocument grown(const std::string& text) {
  Progress progress;
  return grow_document(read(text), progress);
}

TEST(LsystemDocument, FaultsOfLinesStandAtTheirPlaces) {
  const std::string errors =
      errors_of_text(R"json({"meristem": 1, "components": {"plant": {"type": "lsystem", "steps": 1,
  "grammar": [
    "F(1)",
    "#rules",
    "F(x) -> F(y)"
  ]
}
}
})json");
  EXPECT_THAT(errors, HasSubstr("d.json:5:16: components.plant.grammar[2]: "));
}

TEST(LsystemDocument, ElementsOfAListMayHoldSeveralLines) {
  const std::string errors =
      errors_of_text(R"json({"meristem": 1, "components": {"plant": {"type": "lsystem", "steps": 1,
  "grammar": [
    "F(1)\n\n#rules",
    "F(x) -> F(y)"
  ]}}})json");
  EXPECT_THAT(errors, HasSubstr("d.json:4:16: components.plant.grammar[1]: "));
}

TEST(LsystemDocument, NamesTheElementThatIsNoText) {
  const std::string errors =
      errors_of_text(R"json({"meristem": 1, "components": {"plant": {"type": "lsystem", "steps": 1,
  "grammar": ["F", 3]}}})json");
  EXPECT_THAT(errors, HasSubstr("d.json:2:20: components.plant.grammar[1]: "));
}

TEST(LsystemDocument, FaultsOfATextStandAtTheirPlaces) {
  const std::string errors =
      errors_of_text(R"json({"meristem": 1, "components": {"plant": {"type": "lsystem", "steps": 1,
  "grammar": "F(1)\n#rules\nF(x) -> F(y)"
}
}
})json");
  EXPECT_THAT(errors, HasSubstr("d.json:2:39: components.plant.grammar: "));
}

class GrammarFile : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string document() const { return (folder_ / "plant.json").string(); }

  TemporaryFolder folder_;
};

constexpr const char* kWithFile =
    R"json({"meristem": 1, "components": {"plant": {"type": "lsystem", "file": "plant.lsys", "steps": 1}}})json";

TEST_F(GrammarFile, IsReadWithWhatItIncludes) {
  write("plant.lsys", "#axiom\nFX\n#include top.lsys as X\n");
  write("top.lsys", "#steps 1\nF\n#rules\nF -> FF\n");
  const Document document = read(kWithFile, this->document());
  EXPECT_THAT(document.source.named_files,
              testing::ElementsAre((folder_ / "plant.lsys").string(), (folder_ / "top.lsys").string()));
  Progress progress;
  EXPECT_EQ(grow_document(document, progress).plant.stems.at(0).skeleton.node_count(), 4U);
}

TEST_F(GrammarFile, FaultsNameFileAndLine) {
  write("plant.lsys", "F(1)\n#rules\nF(x) -> F(y)\n");
  EXPECT_THAT(errors_of_text(kWithFile, document()), HasSubstr("components.plant.file: 'plant.lsys:3:11': "));
}

TEST_F(GrammarFile, MayBeMissing) {
  EXPECT_THAT(errors_of_text(kWithFile, document()), HasSubstr("components.plant.file: "));
}

constexpr const char* kPlaced = R"json({"meristem": 1, "components": {
  "plant": {"type": "lsystem", "steps": 0, "length": 1, "angle": 90, "grammar": ["#symbols leaf ball", "F[+~leaf]~ball(2)F~ball"]},
  "leaf": {"type": "leaf", "length": 0.3},
  "ball": {"type": "simple", "shape": "sphere"}
}})json";

TEST(LsystemDocument, PlacesComponentsByName) {
  const Plant plant = grown(kPlaced).plant;
  const std::vector<Organ> leaves = organs_of(plant, "leaf");
  ASSERT_EQ(leaves.size(), 1U);
  EXPECT_LT(glm::distance(leaves[0].frame.origin, Vec3(0, 1, 0)), 1e-5F);
  EXPECT_LT(glm::distance(glm::normalize(leaves[0].frame.heading()), Vec3(-1, 0, 0)), 1e-5F);
  const std::vector<Organ> balls = organs_of(plant, "ball");
  ASSERT_EQ(balls.size(), 2U);
  EXPECT_NEAR(glm::length(balls[0].frame.heading()) / glm::length(balls[1].frame.heading()), 2, 1e-5);
}

TEST(LsystemDocument, StemsThatItPlacesBecomeItsBranches) {
  const Plant plant = grown(R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 0, "grammar": "#symbols twig\nFF[+~twig]F"},
    "twig": {"type": "tree", "radius": 0.002, "length": 0.2}
  }})json")
                          .plant;
  ASSERT_EQ(plant.stems.size(), 1U);
  EXPECT_EQ(plant.stems[0].parts.size(), 2U);
}

TEST(LsystemDocument, WantsThePlacedComponentsToBeThere) {
  const std::string errors = errors_of_text(R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 0, "grammar": "#symbols leav\nF~leav"}, "leaf": {"type": "leaf"}}})json");
  EXPECT_THAT(errors, HasSubstr("components.plant: 'plant' places 'leav', and there is no such component"));
  EXPECT_THAT(errors, HasSubstr("did you mean 'leaf'?"));
}

TEST(LsystemDocument, TellsToDeclareTheNameOfAComponentThatIsWrittenBehindATilde) {
  const std::string errors = errors_of_text(R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 0, "grammar": "F~leaf"}, "leaf": {"type": "leaf"}}})json");
  EXPECT_THAT(errors, HasSubstr("'plant' places 'l', and there is no such component; expected a component 'l', or "
                                "'#symbols leaf' in the grammar, since '~leaf' is '~l' without it"));
}

TEST(LsystemDocument, PlacesWhatRulesMakeOfAName) {
  const Plant plant = grown(R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 1, "grammar": "#symbols leaf\n#axiom F~A\n#rules\nA -> leaf\n"},
    "leaf": {"type": "leaf"}}})json")
                          .plant;
  EXPECT_EQ(organs_of(plant, "leaf").size(), 1U);
}

TEST(LsystemDocument, RefusesNamesThatRulesMakeOfOthers) {
  const Document document = read(R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 0, "grammar": "#symbols leaf\n#axiom F~A\n#rules\nA -> leaf\n"},
    "leaf": {"type": "leaf"}}})json");
  Progress progress;
  const std::vector<Diagnostic> errors = errors_of([&] { grow_document(document, progress); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("components.plant: 'plant' places 'A', and there is no such component"));
}

TEST(LsystemDocument, RefusesToPlaceItself) {
  EXPECT_THAT(errors_of_text(R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 0, "grammar": "#symbols plant\nF~plant"}}})json"),
              HasSubstr("form an endless circle"));
}

TEST(LsystemDocument, MayPlaceItselfToADepth) {
  const Plant plant = grown(R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 0, "recursion": 3, "grammar": "#symbols plant\nFF[+~plant(0.5)]F"}}})json")
                          .plant;
  ASSERT_EQ(plant.stems.size(), 1U);
  EXPECT_EQ(plant.stems[0].parts.size(), 3U);
}

}  // namespace meristem::lsystem_document_test
