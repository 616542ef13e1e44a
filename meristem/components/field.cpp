// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/field.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/math.h"

namespace meristem {

namespace {

/// Indices of a plant's random numbers.
enum Draw : std::uint64_t { along, across, turn, gap };

void expand(const Field& field, const Site& site, SiteSink& sites) {
  sites.no_children();
  const auto rows = static_cast<std::uint64_t>(field.rows), plants = static_cast<std::uint64_t>(field.plants);
  sites.expect(rows * plants);
  const RandomKey places = site.key.child("places");
  const double right = 0.5 * (field.plants - 1) * field.spacing, front = 0.5 * (field.rows - 1) * field.row_spacing;
  for (std::uint64_t row = 0; row < rows; ++row) {
    const double moved = field.stagger ? (row % 2 == 0 ? -0.25 : 0.25) * field.spacing : 0;
    for (std::uint64_t plant = 0; plant < plants; ++plant) {
      const RandomKey place = places.child(row * plants + plant);
      if (field.gaps > 0 && place.uniform(gap) < field.gaps) continue;
      const double x = static_cast<double>(plant) * field.spacing - right + moved +
                       field.scatter * field.spacing * place.uniform(along, -1, 1);
      const double z = static_cast<double>(row) * field.row_spacing - front +
                       field.scatter * field.row_spacing * place.uniform(across, -1, 1);
      Frame frame;
      if (field.turned) {
        const double angle = place.uniform(turn, 0, 2 * kPi);
        const auto sine = static_cast<float>(math::sin(angle)), cosine = static_cast<float>(math::cos(angle));
        frame.axes = Mat3(Vec3(cosine, 0, -sine), Vec3(0, 1, 0), Vec3(sine, 0, cosine));
      }
      frame.origin = Vec3(x, 0, z);
      sites.add(frame);
    }
  }
}

}  // namespace

ComponentType field_component() {
  return define_component<Field>({
      .traits = {.name = "field",
                 .doc = "Sites in rows on a level plain, for a crop, an orchard or an avenue.",
                 .has_geometry = false,
                 .bears_plants = true},
      .parameters =
          Table<Field>("a field", "Sites in rows.")
              .integer("rows", &Field::rows, {.min = 1, .max = 1e6, .usual = {1, 100}, .fixed = true},
                       "Number of rows, one behind the other along z.")
              .integer("plants", &Field::plants, {.min = 1, .max = 1e6, .usual = {1, 100}, .fixed = true},
                       "Number of plants in each row, along x.")
              .number("row_spacing", &Field::row_spacing, {.unit = Unit::metre, .min = 0, .max = 1e5},
                      "Distance from row to row.")
              .number("spacing", &Field::spacing, {.unit = Unit::metre, .min = 0, .max = 1e5, .usual = {0, 5}},
                      "Distance from plant to plant within a row.")
              .number(
                  "scatter", &Field::scatter, {.min = 0, .max = 1, .usual = {0, 0.5}},
                  "Largest random offset of a plant, as a share of both spacings; raised, the field is less regular.")
              .boolean("stagger", &Field::stagger, "Whether every other row is offset by half the spacing.")
              .number("gaps", &Field::gaps, {.min = 0, .max = 1}, "Share of the sites that stay empty.")
              .boolean("turned", &Field::turned,
                       "Whether each plant faces a random direction; otherwise all face in one direction."),
      .expand = expand,
      .minimum_counts =
          [](const Field& field, const KnownMembers& known) {
            if (known.varies(member_of(field, &Field::gaps))) return MinimumCounts();
            const double sites = 1.0 * field.rows * field.plants;
            // The number of gaps is binomial. Ten standard deviations above the mean are certain, and ten more if gaps
            // are so rare that their number has a long tail.
            const double below = field.gaps > 0 ? 10 * std::sqrt(sites * field.gaps * (1 - field.gaps)) + 10 : 0;
            return MinimumCounts{.children = std::max(0.0, std::floor((1 - field.gaps) * sites - below))};
          },
  });
}

}  // namespace meristem
