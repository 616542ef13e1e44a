// SPDX-License-Identifier: Apache-2.0
// The schema of documents, judged by valijson: it takes every good document, and what it refuses the reader refuses
// too.
#include "meristem/document/schema.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/json.h"
#include "meristem/graph/component.h"
#include "meristem/graph/table/kinds.h"

namespace meristem {
namespace {

using Json = nlohmann::json;

Json parse(const std::string& text) { return Json::parse(text, nullptr, true, /*ignore_comments=*/true); }

const Json& schema_json() {
  static const Json schema = parse(write_json(document_schema(builtin_components())));
  return schema;
}

class DocumentSchema {
 public:
  explicit DocumentSchema(const Json& json) {
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(json), schema_);
  }

  bool accepts(const Json& document) const {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
  }

 private:
  valijson::Schema schema_;
};

const DocumentSchema& schema() {
  static const DocumentSchema schema(schema_json());
  return schema;
}

/// The reader's faults, or nothing.
std::string errors_of(const std::string& text) {
  try {
    read_document(text, "document", builtin_components());
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Documents that use every form of value.
const std::vector<std::string>& good_documents() {
  static const std::vector<std::string> documents = {
      R"({"meristem": 1, "components": {"a": {"type": "simple"}}})",
      R"j({"meristem": "1", "seed": "3+4", "name": "n", "components": {
        "view": {"type": "camera", "field_of_view": 30, "position": [0, "1+1", 4], "background": "#00ff7F"},
        "leaf": {"type": "leaf", "length": [0.1, "0.2"], "width": {"range": [0.1, 0.2], "apply": "v*rand(1,2)"},
                 "curl": {"apply": "v + i"}, "fold": "2*u", "outline": {"curve": [[0, "0.5"], [1, 0]], "kind": "linear"},
                 "omit": [0, [2, "2+2"], "i % 3 == 0"], "colour": "#123456", "frame": {"rotate": [0, [1, 2], "i"]},
                 "recursion": 2, "hidden": true}},
        "links": [["view", "leaf"], {"from": "leaf", "to": "leaf", "kind": "leaf"}]})j",
      R"({"meristem": 1, "scene": {"latitude": -35, "sky": 0.2, "sun": {"days": [300, "50+10"], "every_days": 20,
        "every_hours": 2, "hour": 9}}, "components": {"a": {"type": "simple"}}})",
      R"({"meristem": 1, "variables": {"k": 40, "m": {"value": "2*3", "min": 1, "max": 9, "unit": "m", "doc": "d"},
           "p": {"value": "m/k", "private": true}},
        "scene": {"latitude": 51, "sun": {"day": 100, "hour": "9+3"}, "ground": {"colour": "#000000"},
                  "sky": "1/4", "lamps": [{"position": [0, "m", 2], "strength": 0.3}, {"position": [0, 1, 2]}]},
        "output": {"size": [10, "2*m"], "samples": 3, "lod": 8}, "limits": {"nodes": 1000},
        "components": {
          "tree": {"type": "colonize", "crown": {"profile": [[1, 0], ["2", 3]]}, "points": {"count": "k"},
                   "step": 0.05, "finish": {"decimate": 0, "relax": true}, "surface": {"style": "tubes", "sides": 8}},
          "bush": {"type": "colonize", "crown": {"profile": [[1, 0], [2, 3]]}, "points": "m*10"},
          "oval": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, "m", 0], "radii": [1, [1, 2], "1+i"]}},
                   "points": {"shares": [{"share": 0.2, "above": "1/4"}, {"share": 0.5, "outer": 0.2}], "blue_noise": true}},
          "odd": {"type": "colonize", "crown": {"difference": [
            {"union": [{"profiles": {"0": [[1, 0], [1, 3]], "90": {"profile": [[1, 0], [2, 3]]}}},
                       {"cone": {"base": [0, 3, 0], "radius": 1, "height": 1}}]},
            {"intersection": [{"sphere": {"centre": [0, 1, 0], "radius": 1}}, {"box": [[0, 0, 0], [1, "1+1", 1]]}]}]}},
          "box": {"type": "simple", "shape": "torus", "size": [1, 2, [1, 3]], "segments": 9}},
        "links": [["tree", "box"],
          {"from": "bush", "to": "box", "kind": "branch", "density": "k/2", "where": "order > 1", "divergence": 90,
           "size": {"curve": [[0, 1]]}, "face_light": 0.5, "start": 0.1, "end": 0.9, "whorl": 2}]})"};
  return documents;
}

void expect_accepted(const char* folder) {
  std::size_t documents = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++documents;
    EXPECT_TRUE(schema().accepts(parse(read_text_file(entry.path())))) << entry.path();
  }
  EXPECT_GT(documents, 0U);
}

TEST(Schema, AcceptsEveryShippedModel) { expect_accepted(MERISTEM_MODELS); }

TEST(Schema, AcceptsEveryFigureOfTheManual) { expect_accepted(MERISTEM_FIGURES); }

TEST(Schema, AcceptsWhatTheReaderAccepts) {
  for (const std::string& document : good_documents()) {
    EXPECT_EQ(errors_of(document), "");
    EXPECT_TRUE(schema().accepts(parse(document))) << document;
  }
}

TEST(Schema, RejectsWhatTheReaderRejects) {
  for (
      const char* document : {
          R"([])",
          R"({"components": {"a": {"type": "simple"}}})",
          R"({"meristem": 2, "components": {"a": {"type": "simple"}}})",
          R"({"meristem": 1})",
          R"({"meristem": 1, "components": {}})",
          R"({"meristem": 1, "components": {"a-b": {"type": "simple"}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simpel"}}})",
          R"({"meristem": 1, "components": {"a": {}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple", "sise": 3}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple", "size": [1, 2]}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple", "shape": "ball"}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple", "colour": "#12345"}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple", "segments": 2}}})",
          R"({"meristem": 1, "components": {"a": {"type": "leaf", "length": [1, 2, 3]}}})",
          R"({"meristem": 1, "components": {"a": {"type": "leaf", "length": {"rang": [1, 2]}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "leaf", "rows": [1, 2]}}})",
          R"({"meristem": 1, "components": {"a": {"type": "leaf", "outline": {"kind": "linear"}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "points": {"up": "z"}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "points": {"file": "a.xyz", "count": 3}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "crown": {"mesh": 3}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "crown": {}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "crown": {"union": [{}]}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "crown": {"sphere": {"centre": [0, 1, 0]}}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "crown": {"box": [[0, 1, 0]]}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "crown": {"profiles": {"0": 3}}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "colonize", "crown": {"profile": [[1, 0], [1, 1]]}, "step": 0}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple", "recursion": 3}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple", "recursion": 3}}, "links": []})",
          R"({"meristem": 1, "components": {"a": {"type": "organize", "operations": [{"do": "prune"}]}}})",
          R"({"meristem": 1, "components": {"a": {"type": "organize", "operations": [{"do": "cut", "every": 2}]}}})",
          R"({"meristem": 1, "components": {"a": {"type": "organize", "operations": [{"iteration": 2}]}}})",
          R"({"meristem": 1, "components": {"a": {"type": "grassleaf", "fit": {"width_smoothing": 0.1}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "grassleaf", "exact": true, "vary": {"bend": 1, "variants": 3}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "tree", "surface": {"style": "blend"}, "texture": {"bark": {}}}}})",
          R"({"meristem": 1, "components": {"a": {"type": "tree"}, "b": {"type": "simple"}},
              "links": [{"from": "a", "to": "b", "density": 3}]})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "links": [["a"]]})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "links": [{"from": "a"}]})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "variables": {"v": {"min": 0}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "scene": {"latitude": 91}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "scene": {"lamps": [{"strength": 3}]}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "scene": {"sun": {"day": 1, "days": [2, 3]}}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "output": {"size": [1]}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "output": {"lod": 9}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "output": {"lod": -1}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "limits": {"nodes": 0}})",
          R"({"meristem": 1, "components": {"a": {"type": "simple"}}, "seed": -1})",
      }) {
    EXPECT_FALSE(schema().accepts(parse(document))) << document;
    EXPECT_NE(errors_of(document), "") << document;
  }
}

struct Snip {
  double length = 1;
};
struct Bend {
  double angle = 1;
};
struct Hedge : ComponentBase {
  std::vector<std::variant<Snip, Bend>> work;
};

TEST(Schema, AListOfKindsTakesEachKindWithItsOwnRowsAlone) {
  static const auto snip_table = []() -> const ParameterTable& {
    static const ParameterTable table =
        Table<Snip>("a snip", "Takes off.").number("length", &Snip::length, {.max = 9}, "How much.").elsewhere({"do"});
    return table;
  };
  static const auto bend_table = []() -> const ParameterTable& {
    static const ParameterTable table =
        Table<Bend>("a bend", "Turns.").number("angle", &Bend::angle, {.max = 9}, "How far.").elsewhere({"do"});
    return table;
  };
  static const auto work_kinds = []() -> const ElementKinds& {
    static const ElementKinds kinds{
        "a piece of work", "What is done.", "do", "Its kind.", {{"snip", snip_table}, {"bend", bend_table}}};
    return kinds;
  };
  static const auto work_table = []() -> const ParameterTable& {
    static const ParameterTable table = table_of_kinds(work_kinds());
    return table;
  };
  const Registry registry({define_component<Hedge>(
      {.traits = {.name = "hedge", .doc = "A hedge."},
       .parameters = Table<Hedge>("a hedge", "A hedge.")
                         .list_of_kinds("work", &Hedge::work, +work_kinds, +work_table, "What is done to it."),
       .expand = [](const Hedge&, const Site&) {}})});
  const DocumentSchema own(parse(write_json(document_schema(registry))));
  const auto accepts = [&](const std::string& work) {
    return own.accepts(parse(R"({"meristem": 1, "components": {"a": {"type": "hedge", "work": [)" + work + "]}}}"));
  };
  EXPECT_TRUE(accepts(R"({"do": "snip", "length": 2}, {"do": "bend", "angle": 3})"));
  EXPECT_FALSE(accepts(R"({"do": "snip", "angle": 2})")) << "a row of another kind";
  EXPECT_FALSE(accepts(R"({"length": 2})"));
  EXPECT_FALSE(accepts(R"({"do": "mow"})"));
}

TEST(Schema, DescribesEveryParameter) {
  for (const Json& type : schema_json()["properties"]["components"]["additionalProperties"]["oneOf"]) {
    for (const auto& [name, parameter] : type["properties"].items()) {
      EXPECT_TRUE(name == "type" || parameter.contains("description")) << name;
    }
  }
}

TEST(Schema, AcceptsItsOwnDefaults) {
  const ComponentType& leaf = *builtin_components().find("leaf");
  const std::vector<Value> defaults = leaf.parameters.defaults();
  int accepted = 0;
  for (std::size_t k = 0; k < defaults.size(); ++k) {
    if (defaults[k].is_null()) continue;
    const std::string& name = leaf.parameters.parameters[k].name;
    const Json component = {{"type", "leaf"}, {name, parse(write_json(defaults[k]))}};
    const Json document = {{"meristem", 1}, {"components", {{"leaf", component}}}};
    // A row that means something only beside others is no fault for its value.
    const std::string errors = errors_of(document.dump());
    if (errors.empty()) {
      EXPECT_TRUE(schema().accepts(document)) << document;
    }
    EXPECT_TRUE(errors.empty() || errors.find("no meaning") != std::string::npos) << errors;
    accepted += errors.empty() ? 1 : 0;
  }
  EXPECT_GT(accepted, 15);
}

std::vector<Json*> nodes_of(Json& root) {
  std::vector<Json*> nodes{&root};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (!nodes[k]->is_structured()) continue;
    for (Json& child : *nodes[k]) nodes.push_back(&child);
  }
  return nodes;
}

/// Replaces, removes, renames or copies one part of a document.
void mutate(Json& document) {
  const std::vector<Json*> nodes = nodes_of(document);
  Json& target = *nodes[*rc::gen::inRange<std::size_t>(0, nodes.size())];
  const int kind = *rc::gen::inRange(0, 4);
  if (kind == 0 && target.is_structured() && !target.empty()) {
    auto member = target.begin();
    std::advance(member, *rc::gen::inRange<std::size_t>(0, target.size()));
    target.erase(member);
  } else if (kind == 1 && target.is_object()) {
    target[*rc::gen::element<std::string>("type", "curve", "value", "range", "count", "x")] = 1;
  } else if (kind == 2) {
    Json copy = *nodes[*rc::gen::inRange<std::size_t>(0, nodes.size())];
    target = std::move(copy);
  } else {
    // Whole numbers are written as such: to draft 7 a 1e9 is an integer, to valijson it is not. An index is drawn and
    // not the value, because RapidCheck cannot show one.
    static const std::vector<Json> replacements = {nullptr,
                                                   true,
                                                   0,
                                                   -1,
                                                   0.5,
                                                   3,
                                                   1000000000,
                                                   "",
                                                   "1",
                                                   "leaf",
                                                   "#123456",
                                                   Json::array(),
                                                   Json::object(),
                                                   Json::array({1, 2}),
                                                   Json::array({1, 2, 3})};
    target = replacements[*rc::gen::inRange<std::size_t>(0, replacements.size())];
  }
}

TEST(Schema, RejectsNothingThatTheReaderAccepts) {
  int rejected = 0;
  EXPECT_TRUE(rc::check([&rejected] {
    Json document = parse(good_documents()[*rc::gen::inRange<std::size_t>(0, good_documents().size())]);
    const int changes = *rc::gen::inRange(1, 3);
    for (int k = 0; k < changes; ++k) mutate(document);
    if (schema().accepts(document)) return;
    ++rejected;
    if (errors_of(document.dump()).empty()) RC_FAIL("the reader accepts " + document.dump());
  }));
  EXPECT_GT(rejected, 10) << "changes that the schema sees";
}

}  // namespace
}  // namespace meristem
