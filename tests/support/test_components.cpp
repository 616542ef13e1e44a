// SPDX-License-Identifier: Apache-2.0
#include "tests/support/test_components.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace meristem {
namespace {

struct Stick : ComponentBase {
  double length = 1;
  float width = 0.1F;
  int sides = 3;
};

ComponentType stick() {
  return define_component<Stick>({
      .traits = {.name = "stick", .doc = "A triangle."},
      .parameters = Table<Stick>("a stick", "A triangle.")
                        .number("length", &Stick::length, {.unit = Unit::metre, .min = 0, .max = 10}, "Height.")
                        .number("width", &Stick::width, {.unit = Unit::metre, .min = 0, .max = 10}, "Width.")
                        .integer("sides", &Stick::sides, {.min = 3, .max = 8}, "Without effect on the shape."),
      .expand =
          [](const Stick& stick, const Site&, OrganSink& organs, SiteSink& sites) {
            const auto length = static_cast<float>(stick.length);
            organs.add(Frame{}, shape_key({stick.length, stick.width, static_cast<double>(stick.sides)}), [&] {
              return Mesh{.positions = {{0, 0, 0}, {stick.width, 0, 0}, {0, length, 0}},
                          .normals = {},
                          .uvs = {},
                          .triangles = {{0, 1, 2}}};
            });
            sites.add(Frame{.axes = Mat3(1), .origin = {0, length, 0}}, length, stick.width);
          },
  });
}

struct Star : ComponentBase {
  int number = 3;
  double step = 1;
};

ComponentType star() {
  return define_component<Star>({
      .traits = {.name = "star", .doc = "Multiplies."},
      .parameters = Table<Star>("a star", "Multiplies.")
                        .integer("number", &Star::number, {.min = 0, .max = 2e9}, "Children.")
                        .number("step", &Star::step, {.unit = Unit::metre, .min = 0, .max = 10}, "Between children."),
      .expand =
          [](const Star& star, const Site&, SiteSink& sites) {
            sites.no_children();
            for (int k = 0; k < star.number; ++k) {
              sites.add(Frame{.axes = Mat3(1), .origin = {static_cast<float>(k * star.step), 0, 0}});
            }
          },
  });
}

struct Ribs : ComponentBase {
  int number = 3;
};

ComponentType ribs() {
  return define_component<Ribs>({
      .traits = {.name = "ribs",
                 .doc = "Multiplies the children of branch links.",
                 .makes_stems = true,
                 .stance = BranchStance::on_axis},
      .parameters =
          Table<Ribs>("ribs", "Multiplies.").integer("number", &Ribs::number, {.min = 0, .max = 100}, "Ribs."),
      .expand =
          [](const Ribs& ribs, const Site&, SiteSink& sites) {
            for (int k = 0; k < ribs.number; ++k) {
              const auto y = static_cast<float>(k);
              sites.add_for_branches(Frame{.axes = Mat3(1), .origin = {0, y, 0}}, y / static_cast<float>(ribs.number),
                                     1, 0);
            }
            sites.add(Frame{.axes = Mat3(1), .origin = {0, static_cast<float>(ribs.number), 0}});
          },
  });
}

struct Pole : ComponentBase {
  double height = 2;
  int nodes = 21;
};

ComponentType pole() {
  return define_component<Pole>({
      .traits = {.name = "pole", .doc = "A straight stem.", .makes_stems = true, .stance = BranchStance::on_axis},
      .parameters =
          Table<Pole>("a pole", "A straight stem.")
              .number("height", &Pole::height, {.unit = Unit::metre, .min = 0, .max = 100}, "Height of the tip.")
              .integer("nodes", &Pole::nodes, {.min = 1, .max = 1000}, "Along it."),
      .expand =
          [](const Pole& pole, const Site& site, StemSink& stems) {
            Skeleton skeleton;
            for (int k = 0; k < pole.nodes; ++k) {
              const auto y = static_cast<float>(pole.height * k / std::max(1, pole.nodes - 1));
              skeleton.add_node(k == 0 ? kNoNode : static_cast<NodeIndex>(k - 1), site.frame.point({0, y, 0}),
                                static_cast<float>(k));
              skeleton.radius.back() = 0.01F;
            }
            stems.add(std::move(skeleton), Surface{});
          },
  });
}

struct Space : ComponentBase {
  std::optional<Vec3> down;
};

ComponentType space() {
  return define_component<Space>({
      .traits = {.name = "space", .doc = "Says which way gravity pulls.", .has_geometry = false},
      .parameters = Table<Space>("a space", "Says which way gravity pulls.")
                        .vector("down", &Space::down, {.min = -1, .max = 1}, "Unset: as in the scene."),
      .expand =
          [](const Space& space, const Site&, const InstanceContext& instance, SiteSink& sites) {
            Surroundings said = instance.surroundings();
            said.directions = space.down ? std::make_shared<const Directions>(kUp, *space.down) : nullptr;
            sites.surround(std::move(said));
          },
  });
}

struct Root : ComponentBase {};

}  // namespace

const Registry& test_components() {
  static const Registry registry({
      define_component<Root>({
          .traits = {.name = "camera", .doc = "The root.", .is_camera = true},
          .parameters = Table<Root>("a camera", "The root."),
          .expand = [](const Root&, const Site&) {},
      }),
      stick(),
      star(),
      ribs(),
      pole(),
      space(),
  });
  return registry;
}

}  // namespace meristem
