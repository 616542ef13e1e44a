// SPDX-License-Identifier: Apache-2.0
// Documents that place the plants of other documents.
#include "meristem/document/sources.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/plant/skeleton.h"
#include "tests/support/build_graph.h"
#include "tests/support/temporary_folder.h"

namespace meristem::sources_test {

constexpr const char* kTwig = R"j({
  "meristem": 1,
  "variables": {"girth": {"value": 0.02}, "age": {"value": 2, "min": 1, "max": 9}},
  "components": {"stem": {"type": "tree", "length": "age", "radius": "girth", "gnarl": 0.2},
                 "leaf": {"type": "leaf", "length": 0.1}},
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 7}]
})j";

/// A folder of documents, and what they grow into.
class Garden : public testing::Test {
 protected:
  Garden() { write("twig.json", kTwig); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  Document read(const std::string& components, const std::string& links = "[]", const std::string& more = "") const {
    const std::string text =
        R"j({"meristem": 1, )j" + more + R"j("components": {)j" + components + R"j(}, "links": )j" + links + "}";
    return read_document(text, (folder_ / "garden.json").string(), builtin_components(), options_);
  }

  static GrownDocument grow(const Document& document) {
    Progress progress;
    return grow_document(document, progress);
  }

  std::vector<Diagnostic> errors(const std::string& components, const std::string& links = "[]",
                                 const std::string& more = "") const {
    return errors_of([&] { grow(read(components, links, more)); });
  }

  std::string error(const std::string& components, const std::string& links = "[]",
                    const std::string& more = "") const {
    const std::vector<Diagnostic> found = errors(components, links, more);
    return found.empty() ? "no fault" : found.front().text();
  }

  TemporaryFolder folder_;
  ReadOptions options_;
};

constexpr const char* kRow = R"j("row": {"type": "field", "rows": 1, "plants": 12, "spacing": 2}, )j";

TEST_F(Garden, InstancesOfEqualRequestsShareOnePlant) {
  const auto grown = grow(read(std::string(kRow) + R"j("oak": {"type": "document", "file": "twig.json", "seed": 3})j",
                               R"j([["row", "oak"]])j"));
  ASSERT_EQ(grown.plant.plantings.size(), 1U);
  EXPECT_EQ(grown.plant.plantings[0].component, "oak");
  EXPECT_EQ(grown.plant.plantings[0].places.size(), 12U);
  EXPECT_TRUE(grown.plant.stems.empty()) << "stems stand in the shared plant";
  for (const MeshInstances& part : grown.meshes.meshes) EXPECT_EQ(part.place_count(), 12U) << part.component;
}

TEST_F(Garden, APlacedPlantIsThatOfItsOwnDocument) {
  const std::string file = (folder_ / "twig.json").string();
  const GrownDocument alone =
      grow(read_document(kTwig, file, builtin_components(), {.overrides = {{"age", Value(5.0)}}, .seed = 3}));
  const GrownDocument garden =
      grow(read(R"j("oak": {"type": "document", "file": "twig.json", "set": {"age": 5}, "seed": 3})j"));
  const Plant& placed = *garden.plant.plantings.at(0).variant->plant;
  ASSERT_EQ(placed.stems.size(), 1U);
  EXPECT_EQ(skeleton_hash(placed.stems[0].skeleton), skeleton_hash(alone.plant.stems.at(0).skeleton));
  EXPECT_EQ(garden.meshes.triangle_count(), alone.meshes.triangle_count());
}

TEST_F(Garden, EachInstanceHasItsOwnSeedUnlessItIsToldOne) {
  const auto variants = [&](const std::string& seed) {
    return grow(read(std::string(kRow) + R"j("oak": {"type": "document", "file": "twig.json")j" + seed + "}",
                     R"j([["row", "oak"]])j"))
        .plant.plantings.size();
  };
  EXPECT_EQ(variants(""), 12U);
  EXPECT_EQ(variants(R"j(, "seed": "i % 3")j"), 3U);
  EXPECT_LE(variants(R"j(, "variants": 2)j"), 2U);
}

TEST_F(Garden, ValuesAreExpressionsOverInstancesWithinTheVariablesRange) {
  const auto grown = grow(
      read(std::string(kRow) + R"j("oak": {"type": "document", "file": "twig.json", "set": {"age": "i"}, "seed": 1})j",
           R"j([["row", "oak"]])j"));
  // 0 and 1 are both 1; 9, 10 and 11 are all 9.
  EXPECT_EQ(grown.plant.plantings.size(), 9U);
  const Plant& last = *grown.plant.plantings.back().variant->plant;
  EXPECT_EQ(grown.plant.plantings.back().places.size(), 3U);
  EXPECT_GT(bounds(last.stems.at(0).skeleton).size().y, 4.0F);
}

TEST_F(Garden, ParametersAreSetByTheirPath) {
  const auto grown =
      grow(read(R"j("oak": {"type": "document", "file": "twig.json", "set": {"leaf.length": 0.5}, "seed": 1})j"));
  const Plant& placed = *grown.plant.plantings.at(0).variant->plant;
  Box box;
  for (const Vec3 point : placed.prototypes.at(0).mesh->positions) box.add(placed.organs[0].frame.vector(point));
  EXPECT_GT(glm::length(box.size()), 0.3F);
}

TEST_F(Garden, GrowsTheSameOnAnyNumberOfThreads) {
  const Document document =
      read(std::string(kRow) + R"j("oak": {"type": "document", "file": "twig.json", "set": {"age": "2 + 3*rand()"}})j",
           R"j([["row", "oak"]])j");
  std::string expected;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const GrownDocument grown = grow(document);
    std::string hashes;
    for (const Planting& planting : grown.plant.plantings) {
      hashes += skeleton_hash(planting.variant->plant->stems.at(0).skeleton);
    }
    if (expected.empty()) expected = hashes;
    EXPECT_EQ(hashes, expected) << threads << " threads";
  }
}

TEST_F(Garden, ACacheGivesWhatGrowingAnewGives) {
  Cache cache;
  const Document document =
      read(std::string(kRow) + R"j("oak": {"type": "document", "file": "twig.json", "variants": 3})j",
           R"j([["row", "oak"]])j");
  Progress progress;
  const GrownDocument first = grow_document(document, progress, {.cache = &cache});
  const GrownDocument second = grow_document(document, progress, {.cache = &cache});
  ASSERT_EQ(first.plant.plantings.size(), second.plant.plantings.size());
  EXPECT_EQ(first.plant.plantings[0].variant->plant, second.plant.plantings[0].variant->plant) << "grown once";
  EXPECT_EQ(first.meshes.meshes[0].mesh, second.meshes.meshes[0].mesh) << "clothed once";
}

TEST_F(Garden, DocumentsOfDocumentsMultiply) {
  write("clump.json", R"j({"meristem": 1, "components": {
    "ring": {"type": "wreath", "number": 3, "diameter": 1, "angle": 0}, "twig": {"type": "document", "file": "twig.json", "seed": 1}},
    "links": [["ring", "twig"]]})j");
  const auto grown =
      grow(read(std::string(kRow) + R"j("clump": {"type": "document", "file": "clump.json", "seed": 1})j",
                R"j([["row", "clump"]])j"));
  EXPECT_EQ(totals_of(grown.plant).stems, 36U);
  for (const MeshInstances& part : grown.meshes.meshes) {
    EXPECT_EQ(part.place_count(), 36U);
    EXPECT_TRUE(part.component.starts_with("clump.twig.")) << part.component;
  }
}

TEST_F(Garden, RejectsDocumentsThatUseEachOtherWithTheWholeWay) {
  write("a.json", R"j({"meristem": 1, "components": {"b": {"type": "document", "file": "b.json"}}})j");
  write("b.json", R"j({"meristem": 1, "components": {"a": {"type": "document", "file": "a.json"}}})j");
  EXPECT_NE(error(R"j("a": {"type": "document", "file": "a.json"})j").find("a.json -> b.json -> a.json"),
            std::string::npos);
}

TEST_F(Garden, RejectsADocumentThatPlacesItself) {
  const std::string text = R"j({"meristem": 1, "components": {"me": {"type": "document", "file": "garden.json"}}})j";
  write("garden.json", text);
  const auto found = errors_of([&] { read_document(text, (folder_ / "garden.json").string(), builtin_components()); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].path, "components.me.file");
  EXPECT_NE(found[0].message.find("contain each other in a circle"), std::string::npos) << found[0].message;
}

TEST_F(Garden, RejectsDocumentsThatLieTooDeep) {
  for (int k = 0; k < 12; ++k) {
    write("d" + std::to_string(k) + ".json",
          R"j({"meristem": 1, "components": {"d": {"type": "document", "file": "d)j" + std::to_string(k + 1) +
              R"j(.json"}}})j");
  }
  write("d12.json", kTwig);
  EXPECT_NE(error(R"j("d": {"type": "document", "file": "d0.json"})j").find("too deep"), std::string::npos);
}

TEST_F(Garden, RejectsAVariableThatTheDocumentDoesNotHave) {
  const auto found = errors(R"j("oak": {"type": "document", "file": "twig.json", "set": {"agee": 3}})j");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nearest, "age");
  EXPECT_EQ(found[0].path, "components.oak.set.agee");
  EXPECT_EQ(found[0].line, 1);
}

TEST_F(Garden, RejectsAParameterOfAComponentThatTheDocumentDoesNotHave) {
  const auto found = errors(R"j("oak": {"type": "document", "file": "twig.json", "set": {"leef.length": 3}})j");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nearest, "leaf");
}

TEST_F(Garden, RejectsAPlainValueBeyondTheVariablesRange) {
  const std::string found = error(R"j("oak": {"type": "document", "file": "twig.json", "set": {"age": 1000}})j");
  EXPECT_NE(found.find("age = 1000"), std::string::npos) << found;
  EXPECT_NE(found.find("1 to 9"), std::string::npos) << found;
}

TEST_F(Garden, RejectsAMissingDocumentAndSaysWhichModelIsNearest) {
  options_.models = folder_.path().string();
  EXPECT_NE(error(R"j("oak": {"type": "document", "file": "none.json"})j").find("none.json"), std::string::npos);
  const auto found = errors(R"j("oak": {"type": "document", "file": "twgi"})j");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nearest, "twig");
  EXPECT_TRUE(errors(R"j("oak": {"type": "document", "file": "twig"})j").empty()) << "a model is found by its name";
}

TEST_F(Garden, TellsWhatIsWrongInTheOtherDocumentWithItsPlace) {
  write("broken.json", "{\"meristem\": 1, \"components\": {\"stem\": {\"type\": \"tree\",\n  \"lenght\": 2}}}");
  const auto found = errors(R"j("oak": {"type": "document", "file": "broken.json"})j");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].path, "components.oak.file");
  EXPECT_NE(found[0].message.find("broken.json:2:3"), std::string::npos) << found[0].message;
  EXPECT_EQ(found[0].nearest, "length");
}

TEST_F(Garden, TellsWithWhatAPlantCouldNotGrow) {
  write("small.json", R"j({"meristem": 1, "limits": {"instances": 100}, "variables": {"many": 1}, "components": {
    "row": {"type": "field", "plants": 10, "rows": 10}, "leaf": {"type": "leaf"}}, "links": [["row", "leaf"]]})j");
  const std::string found =
      error(R"j("oak": {"type": "document", "file": "small.json", "set": {"many": 4}, "seed": 2})j");
  EXPECT_NE(found.find("many = 4, seed 2"), std::string::npos) << found;
  EXPECT_NE(found.find("components.oak"), std::string::npos) << found;
}

TEST_F(Garden, ReadsNothingOutsideOfItsRoot) {
  TemporaryFolder elsewhere;
  std::ofstream(elsewhere / "secret.json") << kTwig;
  options_.root = folder_.path().string();
  const std::string found =
      error(R"j("oak": {"type": "document", "file": ")j" + (elsewhere / "secret.json").string() + R"j("})j");
  EXPECT_NE(found.find("outside the folder"), std::string::npos) << found;
  EXPECT_TRUE(errors(R"j("oak": {"type": "document", "file": "twig.json"})j").empty());
}

TEST_F(Garden, RejectsMoreVariantsThanMayBe) {
  const auto with = [&](const std::string& rows) {
    return error(R"j("row": {"type": "field", "rows": 40, "plants": 40},
                     "oak": {"type": "document", "file": "twig.json")j" +
                     rows + "}",
                 R"j([["row", "oak"]])j");
  };
  for (const char* rows : {"", R"(, "seed": "i")", R"(, "variants": 1000000)"}) {
    const std::string found = with(rows);
    const bool is_before_growth = rows[0] == 0;
    EXPECT_NE(found.find(is_before_growth ? "1600 different plants" : "more than 1000 different plants"),
              std::string::npos)
        << found;
    EXPECT_NE(found.find("variants"), std::string::npos) << found;
  }
}

// Tables of places.

constexpr const char* kChosen = R"j("street": {"type": "places", "table": "street.csv", "choose": "kind"},
    "oak": {"type": "document", "file": "twig.json", "set": {"age": "years"}, "seed": 1},
    "stone": {"type": "simple"})j";

TEST_F(Garden, ATableChoosesWhatStandsInEachRowAndGivesItsColumns) {
  write("street.csv", "x,y,kind,years\n0,0,oak,2\n5,1,stone,0\n10,2,oak,4\n15,3,oak,2\n");
  const auto grown = grow(read(kChosen));
  EXPECT_EQ(organs_of(grown.plant, "stone").size(), 1U);
  EXPECT_EQ(organs_of(grown.plant, "stone")[0].frame.origin, Vec3(5, 0, -1)) << "y of a map points to the north";
  ASSERT_EQ(grown.plant.plantings.size(), 2U) << "trees of 2 and of 4 years";
  EXPECT_EQ(grown.plant.plantings[0].places.size(), 2U);
  EXPECT_EQ(grown.plant.plantings[1].places.at(0).frame.origin, Vec3(10, 0, -2));
}

TEST_F(Garden, RejectsATableThatNamesNoComponent) {
  write("street.csv", "x,y,kind,years\n0,0,oka,2\n");
  const auto found = errors(kChosen);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nearest, "oak");
}

TEST_F(Garden, RejectsAColumnOfTextsInAnExpressionWithItsLine) {
  write("street.csv", "x,y,kind,years\n0,0,oak,2\n5,1,stone,old\n");
  const std::string found = error(kChosen);
  EXPECT_NE(found.find("'years' is a column of texts: 'old' stands in line 3 of 'street.csv'"), std::string::npos)
      << found;
}

TEST_F(Garden, RejectsAColumnWhereNoTableGivesIt) {
  write("street.csv", "x,y,kind,years\n0,0,oak,2\n0,0,stone,2\n");
  const auto found = errors(std::string(kChosen) + R"j(, "hut": {"type": "simple", "size": ["years", 1, 1]})j");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].path, "components.hut");
  EXPECT_NE(found[0].message.find("only components that stand on 'street' have"), std::string::npos)
      << found[0].message;
}

TEST_F(Garden, RejectsARowWithinAnObstacle) {
  write("street.csv", "x,y,kind,years\n0,0,oak,2\n5,1,stone,0\n10,2,oak,4\n");
  const std::string found = error(kChosen, "[]", R"j("scene": {"obstacles": [{"box": [[4, -1, -2], [6, 3, 0]]}]}, )j");
  EXPECT_NE(found.find("line 3 of 'street.csv' stands within an obstacle"), std::string::npos) << found;
}

// Variables of instances.

constexpr const char* kBed = R"j("bed": {"type": "field", "rows": 5, "plants": 10},
    "tulip": {"type": "hydra", "number": 6},
    "petal": {"type": "leaf", "length": "0.02 + 0.05*hue", "variety": 0})j";
constexpr const char* kBedLinks = R"j([["bed", "tulip"], ["tulip", "petal"]])j";

TEST_F(Garden, AVariableOfAnInstanceIsOneForAllThatHangsOnIt) {
  const auto grown = grow(read(kBed, kBedLinks, R"j("variables": {"hue": {"value": "rand()", "per": "tulip"}}, )j"));
  const std::vector<Organ> petals = organs_of(grown.plant, "petal");
  ASSERT_EQ(petals.size(), 300U);
  std::set<float> sizes;
  for (std::size_t k = 0; k < petals.size(); k += 6) {
    const float size = glm::length(petals[k].frame.heading());
    sizes.insert(size);
    for (std::size_t p = 1; p < 6; ++p) EXPECT_NEAR(glm::length(petals[k + p].frame.heading()), size, 1e-6F * size);
  }
  EXPECT_GT(sizes.size(), 45U) << "tulips differ";
}

TEST_F(Garden, AVariableOfAnInstanceStaysWhereOthersAreAdded) {
  const char* one = R"j("variables": {"hue": {"value": "rand()", "per": "tulip"}}, )j";
  const char* two = R"j("variables": {"age": {"value": "gauss(3, 1)", "per": "tulip"},
                                   "hue": {"value": "rand()", "per": "tulip"}}, )j";
  EXPECT_EQ(hash_of(grow(read(kBed, kBedLinks, one)).plant, "petal"),
            hash_of(grow(read(kBed, kBedLinks, two)).plant, "petal"));
}

TEST_F(Garden, AVariableOfAnInstanceMayUseOthers) {
  const auto grown = grow(read(kBed, kBedLinks,
                               R"j("variables": {"hue": {"value": "half + 0.5", "per": "tulip"},
                                               "half": {"value": "step(20, i)*0.5", "per": "tulip"}}, )j"));
  const std::vector<Organ> petals = organs_of(grown.plant, "petal");
  EXPECT_NEAR(glm::length(petals.back().frame.heading()) / glm::length(petals.front().frame.heading()), 0.07 / 0.045,
              0.05);
}

TEST_F(Garden, RejectsAVariableOfAnInstanceOfNoComponent) {
  const auto found = errors(kBed, kBedLinks, R"j("variables": {"hue": {"value": "rand()", "per": "tulpi"}}, )j");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nearest, "tulip");
  EXPECT_EQ(found[0].path, "variables.hue.per");
}

TEST_F(Garden, RejectsAVariableOfAnInstanceOutsideOfIt) {
  const auto found = errors(std::string(kBed) + R"j(, "stone": {"type": "simple", "size": ["hue", 1, 1]})j", kBedLinks,
                            R"j("variables": {"hue": {"value": "rand()", "per": "tulip"}}, )j");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].path, "components.stone");
}

TEST_F(Garden, RejectsVariablesOfInstancesThatNeedEachOther) {
  const std::string found = error(kBed, kBedLinks,
                                  R"j("variables": {"hue": {"value": "tone", "per": "tulip"},
                                                   "tone": {"value": "1 - hue", "per": "tulip"}}, )j");
  EXPECT_NE(found.find("hue -> tone -> hue"), std::string::npos) << found;
}

TEST_F(Garden, ItsLimitsHoldForPlacedPlantsToo) {
  const char* one = R"j("oak": {"type": "document", "file": "twig.json", "seed": 1})j";
  const std::string single = error(one, "[]", R"j("limits": {"instances": 5}, )j");
  EXPECT_NE(single.find("limits.instances"), std::string::npos) << single;
  const std::string nodes = error(one, "[]", R"j("limits": {"nodes": 5}, )j");
  EXPECT_NE(nodes.find("limits.nodes"), std::string::npos) << nodes;
}

TEST_F(Garden, ItsLimitsHoldForAllVariantsTogether) {
  const std::string row = std::string(kRow) + R"j("oak": {"type": "document", "file": "twig.json"})j";
  const std::string links = R"j([["row", "oak"]])j";
  const std::string found = error(row, links, R"j("limits": {"instances": 60}, )j");
  EXPECT_NE(found.find("the plants of other documents have more than 60 leaves"), std::string::npos) << found;
  EXPECT_EQ(error(row, links, R"j("limits": {"instances": 200}, )j"), "no fault");
}

}  // namespace meristem::sources_test
