// SPDX-License-Identifier: Apache-2.0
// A crown has tens of thousands of leaves that all differ a little. Each leaf gets its exact length and width by
// scaling a shared blade whose proportion and angles are rounded, so that geometry stays small: widths over lengths to
// an eighth of an octave (the blade is then stretched by at most 4.4 %), angles to 5°, stalks to a twentieth of the
// length and half an octave of radius.
#include "meristem/components/leaf.h"

#include <cmath>

#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr double kAngleStep = 5 * kPi / 180;
constexpr double kStalkStep = 0.05;
constexpr double kProportionSteps = 8;   // an octave
constexpr double kStalkRadiusSteps = 2;  // an octave

double to_step(double value, double step) { return std::floor(value / step + 0.5) * step; }

/// To so many steps an octave.
double to_octaves(double value, double steps) {
  return math::pow(2, to_step(math::log(value) / math::log(2), 1 / steps));
}

/// The shared blade, of length 1.
LeafBlade shared_blade(const LeafBlade& exact) {
  LeafBlade blade = exact;
  blade.length = 1;
  blade.width = to_octaves(exact.width / exact.length, kProportionSteps);
  blade.curl = to_step(exact.curl, kAngleStep);
  blade.curl_across = to_step(exact.curl_across, kAngleStep);
  blade.fold = to_step(exact.fold, kAngleStep);
  blade.petiole = to_step(exact.petiole / exact.length, kStalkStep);
  // Without a stalk its radius must not tell shapes apart.
  blade.petiole_radius = blade.petiole > 0 ? to_octaves(exact.petiole_radius / exact.length, kStalkRadiusSteps) : 1;
  return blade;
}

void expand(const Leaf& leaf, const Site&, Emitter& out) {
  const LeafBlade blade = shared_blade(leaf.blade);
  Frame frame;
  frame.axes *= static_cast<float>(leaf.blade.length);
  frame.axes[0] *= static_cast<float>(leaf.blade.width / (leaf.blade.length * blade.width));
  const std::uint64_t key =
      shape_key({blade.width, blade.curl, blade.curl_across, blade.fold, blade.petiole, blade.petiole_radius,
                 static_cast<double>(blade.rows), static_cast<double>(blade.across)});
  out.organ(frame, key, [&] { return make_leaf_blade(blade); });
}

void check_outline(const LeafBlade& blade, const Place& place, ParameterReader& reader) {
  bool has_width = false;
  for (const Vec2& point : blade.outline.points()) {
    if (point.y < 0 || point.y > 1) {
      reader.fault(Place(place, "outline"), "the outline leaves the range from 0 to 1", "half widths from 0 to 1");
      return;
    }
    has_width = has_width || point.y > 0;
  }
  if (!has_width) reader.fault(Place(place, "outline"), "the outline is empty", "a half width above 0 somewhere");
  if (blade.across % 2 != 0) {
    reader.fault(Place(place, "across"), "'across' is odd", "an even number, so that a row of points is the midrib");
  }
}

const ParameterTable& blade_table() {
  static const ParameterTable table =
      Table<LeafBlade>("a leaf", "A leaf blade with its stalk.")
          .number("length", &LeafBlade::length, {.unit = Unit::metre, .min = 1e-4, .max = 100},
                  "Base to tip of the blade.")
          .number("width", &LeafBlade::width, {.unit = Unit::metre, .min = 1e-5, .max = 100},
                  "Across where it is widest.")
          .curve("outline", &LeafBlade::outline,
                 "Half width from base (0) to tip (1) as a share of the largest; the blade's edge.")
          .number("curl", &LeafBlade::curl, {.unit = Unit::degree, .min = -720, .max = 720},
                  "Bend of the midrib from base to tip; raised, the tip sinks more.")
          .number("curl_across", &LeafBlade::curl_across, {.unit = Unit::degree, .min = -350, .max = 350},
                  "Bend from edge to edge; raised, the edges sink more.")
          .number("fold", &LeafBlade::fold, {.unit = Unit::degree, .min = -85, .max = 85},
                  "Angle by which both halves rise about the midrib.")
          .number("petiole", &LeafBlade::petiole, {.unit = Unit::metre, .min = 0, .max = 100},
                  "Length of the stalk before the blade.")
          .number("petiole_radius", &LeafBlade::petiole_radius, {.unit = Unit::metre, .min = 1e-5, .max = 1},
                  "Of the stalk.")
          .integer("rows", &LeafBlade::rows, {.min = 1, .max = 256, .fixed = true},
                   "Quads from base to tip; raised, the outline is followed more closely.")
          .integer("across", &LeafBlade::across, {.min = 2, .max = 64, .fixed = true},
                   "Quads from edge to edge, an even number.");
  return table;
}

}  // namespace

ComponentType leaf_component() {
  return define_component<Leaf>({
      .name = "leaf",
      .doc = "A leaf blade with outline, curl, fold and stalk; it heads along y with its upper face to z.",
      .parameters = Table<Leaf>("a leaf", "A leaf blade with its stalk.")
                        .members(&Leaf::blade, blade_table())
                        .check([](const Leaf& leaf, const Place& place, ParameterReader& reader) {
                          check_outline(leaf.blade, place, reader);
                        }),
      .material = {.colour = {0.33F, 0.46F, 0.20F}, .roughness = 0.6F, .translucency = 0.35F, .two_sided = true},
      .variety = 0.12,
      .expand = expand,
  });
}

}  // namespace meristem
