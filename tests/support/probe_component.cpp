// SPDX-License-Identifier: Apache-2.0
#include "tests/support/probe_component.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace meristem::probe {

namespace {

struct Many : ComponentBase {};

Expansion expansion;
std::mutex mutex;
std::vector<Seen> sites_seen;

ComponentType probe_type(const std::string& name, bool makes_stems) {
  return define_component<Probe>({
      .traits = {.name = name, .doc = "What a test says.", .makes_stems = makes_stems, .stance = BranchStance::on_axis},
      .parameters = Table<Probe>("a probe", "What a test says.")
                        .number("size", &Probe::size, {.min = 0, .max = 100}, "Without effect.")
                        .number("age", &Probe::age, {.min = 0, .max = 100}, "Without effect."),
      .expand = [](const Probe& probe, const Site& site, Emitter& out) { expansion(probe, site, out); },
  });
}

ComponentType seer_type() {
  return define_component<Probe>({
      .traits = {.name = "seer", .doc = "Records its site.", .has_geometry = false},
      .parameters = Table<Probe>("a seer", "Records its site."),
      .expand =
          [](const Probe&, const Site& site, const InstanceContext& instance) {
            const std::lock_guard lock(mutex);
            sites_seen.push_back({site, instance.time(), instance.surroundings().directions != nullptr});
          },
  });
}

ComponentType many_type() {
  return define_component<Many>({
      .traits = {.name = "many", .doc = "Multiplies.", .has_geometry = false},
      .parameters = Table<Many>("many", "Multiplies."),
      .expand =
          [](const Many&, const Site&, SiteSink& sites) {
            for (int k = 0; k < 3; ++k) sites.add(shifted(static_cast<float>(k)));
          },
  });
}

ComponentType camera_type() {
  return define_component<Many>({
      .traits = {.name = "camera", .doc = "The root.", .is_camera = true, .bears_plants = true},
      .parameters = Table<Many>("a camera", "The root."),
      .expand = [](const Many&, const Site&) {},
  });
}

}  // namespace

const Registry& registry() {
  static const Registry made(
      {camera_type(), probe_type("probe", false), probe_type("stems", true), seer_type(), many_type()});
  return made;
}

GraphBuilder builder_of(const std::string& type, LinkKind kind) {
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("probe", type).component("seer", "seer");
  return builder.link("view", "probe").link("probe", "seer", kind);
}

GraphBuilder three_probes() {
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("many", "many").component("probe", "probe").component("seer", "seer");
  return builder.link("view", "many").link("many", "probe").link("probe", "seer");
}

Plant grow(const GraphBuilder& builder, Expansion with, double time) {
  expansion = std::move(with);
  sites_seen.clear();
  Plant plant = builder.grow(time);
  std::ranges::stable_sort(sites_seen, {}, [](const Seen& one) { return one.site.i; });
  return plant;
}

const std::vector<Seen>& seen() { return sites_seen; }

Mesh triangle() {
  return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .normals = {}, .uvs = {}, .triangles = {{0, 1, 2}}};
}

Frame shifted(float x) { return Frame{.origin = {x, 0, 0}}; }

Skeleton straight_stem(const Site& site) {
  Skeleton skeleton;
  for (int k = 0; k < 3; ++k) {
    skeleton.add_node(k == 0 ? kNoNode : static_cast<NodeIndex>(k - 1), site.frame.point({0, static_cast<float>(k), 0}),
                      0);
    skeleton.radius.back() = 0.01F;
  }
  return skeleton;
}

}  // namespace meristem::probe
