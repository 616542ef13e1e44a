// SPDX-License-Identifier: Apache-2.0
// The proof that the graph carries components it has never heard of: one is written here, and documents can use it.
#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/components/camera.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/document/schema.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::component_in_a_test {

/// A cone that carries a ring of children near its apex.
struct Spike : ComponentBase {
  double length = 1;
  double radius = 0.05;
  int number = 3;
  double opening = radians(40);
};

ComponentType spike_component() {
  return define_component<Spike>({
      .traits = {.name = "spike", .doc = "A cone with a ring of children near its apex."},
      .parameters =
          Table<Spike>("a spike", "A cone with a ring of children near its apex.")
              .number("length", &Spike::length, {.unit = Unit::metre, .min = 0, .max = 100, .above_min = true},
                      "Base to apex.")
              .number("radius", &Spike::radius, {.unit = Unit::metre, .min = 1e-6, .max = 10}, "Radius of the base.")
              .integer("number", &Spike::number, {.min = 0, .max = 1000}, "Children in the ring.")
              .number("opening", &Spike::opening, {.unit = Unit::degree, .min = 0, .max = 180},
                      "Between axis and child."),
      .expand =
          [](const Spike& spike, const Site&, OrganSink& organs, SiteSink& sites) {
            Frame stretched;
            stretched.axes *= static_cast<float>(spike.length);
            organs.add(stretched, shape_key({spike.radius / spike.length}),
                       [&] { return make_cone(spike.radius / spike.length, 1, 8); });
            sites.no_children();
            for (int k = 0; k < spike.number; ++k) {
              Frame child;
              child.axes = rotation({0, 1, 0}, 2 * kPi * k / spike.number) * rotation({1, 0, 0}, spike.opening);
              child.origin.y = static_cast<float>(0.9 * spike.length);
              sites.add(child, static_cast<float>(spike.length));
            }
          },
  });
}

const Registry& registry() {
  static const Registry registry({camera_component(), spike_component()});
  return registry;
}

Document read(std::string text) { return read_document(std::move(text), "spike.json", registry()); }

std::vector<Diagnostic> errors_of(std::string text) {
  try {
    read(std::move(text));
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

TEST(ComponentInATest, MultipliesAndRecursesFromADocument) {
  const Document document = read(R"({
    "meristem": 1,
    "variables": {"arms": 4},
    "components": {
      "view": {"type": "camera"},
      "tree": {"type": "spike", "number": "arms", "recursion": 4, "length": "0.5 ^ depth", "radius": [0.02, 0.05]}
    },
    "links": [["view", "tree"], ["tree", "tree"]]
  })");
  Progress progress;
  const GrownDocument grown = grow_document(document, progress);
  EXPECT_EQ(grown.plant.organs.size(), 1U + 4 + 16 + 64);
  // The opening is 40 degrees from spike to spike.
  const Vec3 heading = grown.plant.organs[1].frame.heading();
  EXPECT_NEAR(heading.y, 0.5 * math::cos(radians(40)), 1e-6);
  EXPECT_NEAR(grown.plant.organs[1].frame.origin.y, 0.9, 1e-6);
  EXPECT_EQ(grown.meshes.instance_count(), 85U);
}

TEST(ComponentInATest, ItsFaultsAreFoundByItsTable) {
  const auto errors = errors_of(R"({"meristem": 1, "components": {
    "a": {"type": "spike", "lenght": 2},
    "b": {"type": "spike", "opening": 181},
    "c": {"type": "spkie"}
  }})");
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0].nearest, "length");
  EXPECT_EQ(errors[0].line, 2);
  EXPECT_EQ(errors[1].path, "components.b.opening");
  EXPECT_EQ(errors[2].nearest, "spike");
}

TEST(ComponentInATest, StandsInTheSchema) {
  EXPECT_NE(write_json(document_schema(registry())).find("\"spike\""), std::string::npos);
}

}  // namespace meristem::component_in_a_test
