// SPDX-License-Identifier: Apache-2.0
#include "tests/support/test_components.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "meristem/grow/stand.h"

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
            stems.add(std::move(skeleton), SurfaceOptions{});
          },
  });
}

/// Returns a vertical stem of two nodes from the origin of a frame.
Skeleton stem_of(const Frame& frame, double height) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, frame.origin, 0);
  skeleton.add_node(0, frame.point({0, static_cast<float>(height), 0}), 1);
  for (float& radius : skeleton.radius) radius = 0.01F;
  return skeleton;
}

constexpr int kSproutSteps = 2;

/// Height of a sprout after a number of steps.
double height_after(int steps, double whole) { return whole * steps / kSproutSteps; }

class SproutTrace final : public GrowthTrace {
 public:
  SproutTrace(const Frame& frame, double height) : frame_(frame), height_(height) {}

  int last_step() const override { return kSproutSteps; }
  std::uint64_t bytes() const override { return 0; }

 private:
  Skeleton standing_after(int step, const Scene&, Progress&) const override {
    return stem_of(frame_, height_after(step, height_));
  }
  StepMarks marks_of(int, TraceRequest, const Progress&) const override { return {}; }

  Frame frame_;
  double height_;
};

/// Counts the sprouts of a stand.
class SproutCount final : public StandCommons {
 public:
  int number = 0;

  void begin_round(Progress&) override {}
};

class SproutGrower final : public Grower {
 public:
  SproutGrower(double height, const GrowContext& context)
      : height_(height), is_traced_(context.request.any()), sprouts_(context.stand.commons<SproutCount>()) {
    ++sprouts_.number;
  }

  int step_limit() const override { return kSproutSteps; }
  bool step(Progress&) override {
    neighbours_ = sprouts_.number;
    return ++steps_ < kSproutSteps;
  }
  std::unique_ptr<GrowthTrace> take_trace() override {
    return is_traced_ ? std::make_unique<SproutTrace>(place, height_ / neighbours_) : nullptr;
  }
  Skeleton take_skeleton(Progress&) override { return stem_of(place, height_after(steps_, height_ / neighbours_)); }

 private:
  double height_;
  bool is_traced_;
  SproutCount& sprouts_;  // exists only during the growth
  int neighbours_ = 1;    // number of sprouts in the stand, itself included
  int steps_ = 0;
};

struct Sprout : GrowingComponent {
  double height = 1;
  bool watches = false;
};

ComponentType sprout() {
  return define_component<Sprout>({
      .traits = {.name = "sprout", .doc = "Grows a stem.", .makes_stems = true, .stance = BranchStance::on_axis},
      .parameters =
          Table<Sprout>("a sprout", "Grows a stem.")
              .number("height", &Sprout::height, {.unit = Unit::metre, .min = 0, .max = 100}, "Height if it is alone.")
              .boolean("watches", &Sprout::watches, "True: shows the growth of another component."),
      .expand = [](const Sprout&, const Site&, StemSink& stems) { stems.add(stems.take_grown(), SurfaceOptions{}); },
      .grow = [](const Sprout& sprout, const Site&, const GrowContext& context) -> std::unique_ptr<Grower> {
        return std::make_unique<SproutGrower>(sprout.height, context);
      },
      .watches_growth = [](const Sprout& sprout) { return sprout.watches; },
  });
}

struct Timer : ComponentBase {
  double delay = 0;
  double speed = 1;
};

ComponentType timer() {
  return define_component<Timer>({
      .traits = {.name = "timer", .doc = "Begins a clock.", .has_geometry = false, .begins_clock = true},
      .parameters = Table<Timer>("a timer", "Begins a clock.")
                        .number("delay", &Timer::delay, {.unit = Unit::second, .min = 0, .max = 100}, "Until it runs.")
                        .number("speed", &Timer::speed, {.min = 0.1, .max = 10}, "Relative to the clock above."),
      .expand = [](const Timer& timer, const Site&, SiteSink& sites) { sites.begin_clock(timer.delay, timer.speed); },
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
      sprout(),
      timer(),
      space(),
  });
  return registry;
}

}  // namespace meristem
