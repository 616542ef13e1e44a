// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/world.h"

#include <utility>

#include "meristem/scene/field/kept_out.h"

namespace meristem {

namespace {

const ParameterTable& avoid_table() {
  static const ParameterTable table =
      Table<AvoidParameters>("a body to avoid", "A body that the stems of trees and horns keep out of.")
          .object("body", &AvoidParameters::body, crown_table, "The body, in the frame of the world.")
          .required()
          .number("reach", &AvoidParameters::reach, {.unit = Unit::metre, .min = 1e-4, .max = 1000, .usual = {0.05, 2}},
                  "Distance from the body at which stems begin to turn aside; raised, they go around it in a wider "
                  "curve.");
  return table;
}

void expand(const World& world, const Site& site, const InstanceContext& instance, SiteSink& sites) {
  Surroundings said = instance.surroundings();
  const Directions above = world.off ? instance.scene().directions() : instance.directions();
  const auto sense = [&](const FieldSense& there, const std::optional<WorldField>& form, const char* name) {
    if (!form) return there;
    const FieldPlace place{.frame = site.frame,
                           .time = instance.time(),
                           .key = site.key.child(name),
                           .path = "components." + instance.component() + "." + name,
                           .what = std::string(name) + " field"};
    return there.with(build_field(*form, place), form->add);
  };
  Directions made = above.with(sense(above.light_sense(), world.light, "light"),
                               sense(above.gravity_sense(), world.gravity, "gravity"));
  if (world.avoid) {
    const double scale = glm::length(site.frame.heading());
    made = made.with(
        std::make_shared<const KeptOut>(build_crown(world.avoid->body), site.frame, scale * world.avoid->reach));
  }
  said.directions = std::make_shared<const Directions>(std::move(made));
  sites.surround(std::move(said));
}

}  // namespace

ComponentType world_component() {
  return define_component<World>({
      .traits = {.name = "world",
                 .doc = "Fields of light and gravity, and a body to grow around, for everything below it.",
                 .has_geometry = false,
                 .speaks_of_space = true},
      .parameters =
          Table<World>("a world", "Fields of light and gravity.")
              .object(
                  "light", &World::light, world_field_table,
                  "Field of light that the plants below the world perceive; by default, the field that holds above it.")
              .object("gravity", &World::gravity, world_field_table,
                      "Field of gravity that the plants below the world perceive; by default, the field that holds "
                      "above it.")
              .object("avoid", &World::avoid, avoid_table, "Body that stems keep out of and grow around.")
              .boolean("off", &World::off,
                       "Whether the worlds above this one end here, and the scene's own light and "
                       "gravity hold again."),
      .expand = expand,
  });
}

}  // namespace meristem
