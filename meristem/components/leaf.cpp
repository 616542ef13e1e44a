// SPDX-License-Identifier: Apache-2.0
// Leaves with shared blades, because a crown has tens of thousands of slightly different leaves. Each leaf gets its
// exact length and width by scaling a shared blade with rounded proportion and angles. The ratio of width to length is
// rounded to an eighth of an octave, so the blade is stretched by at most 4.4 %. Angles are rounded to 5°, and stalks
// to a twentieth of the length and half an octave of radius. Angles and stalks that are equal for all leaves are exact.
#include "meristem/components/leaf.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "meristem/components/parts/shared_shape.h"
#include "meristem/graph/table/curve_range.h"
#include "meristem/shape/leaf/leaf_outline.h"

namespace meristem {

namespace {

constexpr double kStalkStep = 0.05;
constexpr double kLeafProportionSteps = 8;  // per octave
constexpr double kStalkRadiusSteps = 2;     // per octave
constexpr std::size_t kMaxCorners = 500;

/// Shape parameters that vary between instances, rounded, for a leaf of length 1.
struct SharedNumbers {
  double width, petiole;
  double curl, curl_across, fold;
  double petiole_radius = 1;  // constant without a stalk, so that it does not distinguish shapes

  /// `varies(&LeafBlade::curl)` returns true if this number of the blade differs between instances.
  template <class Varies>
  SharedNumbers(const Leaf& leaf, const Varies& varies)
      : width(to_octaves(leaf.blade.width / leaf.blade.length, kLeafProportionSteps)),
        petiole(leaf.blade.petiole / leaf.blade.length) {
    const LeafBlade& exact = leaf.blade;
    const auto angle = [&](double LeafBlade::*member) {
      return varies(member) ? to_step(exact.*member, kShapeAngleStep) : exact.*member;
    };
    curl = angle(&LeafBlade::curl);
    curl_across = angle(&LeafBlade::curl_across);
    fold = angle(&LeafBlade::fold);
    if (varies(&LeafBlade::length) || varies(&LeafBlade::petiole)) petiole = to_step(petiole, kStalkStep);
    if (petiole <= 0) return;
    petiole_radius = exact.petiole_radius / exact.length;
    if (varies(&LeafBlade::length) || varies(&LeafBlade::petiole_radius)) {
      petiole_radius = to_octaves(petiole_radius, kStalkRadiusSteps);
    }
  }
};

/// Returns the shared blade, of length 1.
LeafBlade shared_blade(const LeafBlade& exact, const SharedNumbers& numbers) {
  LeafBlade blade = exact;
  blade.length = 1;
  blade.width = numbers.width;
  blade.curl = numbers.curl;
  blade.curl_across = numbers.curl_across;
  blade.fold = numbers.fold;
  blade.petiole = numbers.petiole;
  blade.petiole_radius = numbers.petiole_radius;
  return blade;
}

void expand(const Leaf& leaf, const Site&, const InstanceContext& instance, OrganSink& organs) {
  // Most leaves reuse an existing blade.
  const ComponentMember<LeafBlade> blade = member_of(leaf, &Leaf::blade);
  const SharedNumbers shared(leaf, [&](double LeafBlade::*number) { return instance.varies(blade.part(number)); });
  Frame frame;
  frame.axes *= static_cast<float>(leaf.blade.length);
  frame.axes[0] *= static_cast<float>(leaf.blade.width / (leaf.blade.length * shared.width));
  const std::uint64_t key =
      shape_key({shared.width, shared.curl, shared.curl_across, shared.fold, shared.petiole, shared.petiole_radius,
                 static_cast<double>(leaf.blade.rows), static_cast<double>(leaf.blade.across)});
  organs.add(frame, key, [&] { return make_leaf_blade(shared_blade(leaf.blade, shared)); });
}

/// If leaves differ, at least two triangles of each are certain: rows where the outline is 0 have none.
double minimum_triangles(const Leaf& leaf, const KnownMembers& known) {
  if (known.varies(member_of(leaf, &Leaf::blade))) return 2;
  const SharedNumbers shared(leaf, [](double LeafBlade::*) { return false; });
  return static_cast<double>(leaf_blade_triangles(shared_blade(leaf.blade, shared)));
}

void check_curve(const LeafBlade& blade, const DocumentPath& path, ParameterReader& reader) {
  bool has_width = false;
  for (const Vec2& point : blade.outline.points()) {
    if (point.y < 0 || point.y > 1) {
      reader.add_error(DocumentPath(path, "outline"), "the outline leaves the range from 0 to 1",
                       "half widths from 0 to 1");
      return;
    }
    has_width = has_width || point.y > 0;
  }
  if (!has_width)
    reader.add_error(DocumentPath(path, "outline"), "the outline is empty", "a half width above 0 somewhere");
}

void check_polygon(const LeafBlade& blade, const DocumentPath& path, ParameterReader& reader) {
  const DocumentPath polygon(path, "polygon");
  if (blade.polygon.size() > kMaxCorners) {
    reader.add_error(polygon, fmt::format("the polygon has {} points", blade.polygon.size()),
                     fmt::format("at most {}", kMaxCorners));
    return;
  }
  if (std::ranges::none_of(blade.polygon, [](Vec2 point) { return point.x > 0; })) {
    reader.add_error(polygon, "the polygon is empty", "a half width above 0 somewhere");
  } else if (polygon_crosses_itself(blade)) {
    reader.add_error(polygon, "the polygon crosses or touches itself or the midrib",
                     "the right edge in its order from the joint [0, 0] to the tip [0, 1]");
  }
}

void check_leaf(const Leaf& leaf, const DocumentPath& path, ParameterReader& reader) {
  if (leaf.blade.polygon.empty()) {
    check_curve(leaf.blade, path, reader);
  } else {
    check_polygon(leaf.blade, path, reader);
  }
  if (leaf.blade.across % 2 != 0) {
    reader.add_error(DocumentPath(path, "across"), "'across' is odd",
                     "an even number, so that a row of points is the midrib");
  }
  const TextureParameters& texture = leaf.texture;
  const bool cuts = texture.leaf || texture.petal || (texture.picture && texture.picture->masked);
  if (leaf.blade.edge == LeafBlade::Edge::picture && !cuts) {
    reader.add_error(DocumentPath(path, "edge"), "no texture cuts out the edge",
                     "a 'texture' that is a leaf, a petal or a masked picture, or the edge 'shape'");
  }
}

Table<LeafBlade> with_outline(Table<LeafBlade> table) {
  return std::move(table)
      .number("length", &LeafBlade::length, {.unit = Unit::metre, .min = 1e-4, .max = 100, .usual = {0.005, 0.5}},
              "Length of the midrib, from the joint with the stalk to the tip.")
      .number("width", &LeafBlade::width, {.unit = Unit::metre, .min = 1e-5, .max = 100, .usual = {0.005, 0.2}},
              "Width of the blade at its widest.")
      .curve("outline", &LeafBlade::outline,
             "Half width of the blade from base (0) to tip (1), as a share of the largest half width.")
      .points("polygon", &LeafBlade::polygon, {.min = 0, .max = 1},
              "Points [half width, distance from the base] of the right edge, as shares of the largest half width and "
              "of the length, for lobes that overhang; replaces 'outline'.")
      .second(-2, 2, {0, 1})
      .together(PointsForm::silhouette)
      .choice("corners", &LeafBlade::corners, {"sharp", "round"},
              "Whether the corners of the polygon are sharp or round.")
      .never_with("polygon", {"outline"})
      .only_with("polygon", {"corners"})
      .number("heart", &LeafBlade::heart, {.min = 0, .max = 1, .usual = {0, 0.4}, .fixed = true},
              "Distance that the base reaches back beside the stalk, as a share of the length; raised, a deeper heart "
              "shape.")
      .integer("teeth", &LeafBlade::teeth, {.min = 0, .max = 200, .usual = {0, 60}, .fixed = true},
               "Number of teeth along each edge; they get smaller toward base and tip.")
      .number("teeth_depth", &LeafBlade::teeth_depth, {.min = 0, .max = 0.9, .usual = {0, 0.4}, .fixed = true},
              "Depth of the largest tooth, as a share of the half width; raised, the edge is cut deeper.")
      .number("teeth_lean", &LeafBlade::teeth_lean, {.min = 0, .max = 1, .fixed = true},
              "Lean of the teeth toward the tip: 0 makes both sides of a tooth equal, 1 makes the side toward the tip "
              "steep.")
      .only_with("teeth", {"teeth_depth", "teeth_lean"});
}

Table<LeafBlade> with_bends(Table<LeafBlade> table) {
  return std::move(table)
      .number("curl", &LeafBlade::curl, {.unit = Unit::degree, .min = -720, .max = 720},
              "Bend of the midrib from base to tip; raised, the tip sinks more.")
      .number("curl_across", &LeafBlade::curl_across, {.unit = Unit::degree, .min = -350, .max = 350},
              "Bend of the blade from edge to edge; raised, the edges sink more.")
      .number("fold", &LeafBlade::fold, {.unit = Unit::degree, .min = -85, .max = 85},
              "Angle that each half of the blade is raised about the midrib; raised, a steeper V.")
      .curve("profile", &LeafBlade::profile,
             "Height of the blade's surface from midrib (0) to edge (1), as a share of the half width; needs 'across' "
             "above 2.")
      .integer("waves", &LeafBlade::waves, {.min = 0, .max = 32, .fixed = true},
               "Number of waves along each edge; each wave needs at least four rows of quads.")
      .number("waves_depth", &LeafBlade::waves_depth, {.min = -1, .max = 1, .usual = {0, 0.5}, .fixed = true},
              "Height of the waves' crests at the edge, as a share of the half width.")
      .only_with("waves", {"waves_depth"})
      .number("petiole", &LeafBlade::petiole, {.unit = Unit::metre, .min = 0, .max = 100, .usual = {0, 0.2}},
              "Length of the petiole, the stalk below the blade; 0 makes none.")
      .number("petiole_radius", &LeafBlade::petiole_radius,
              {.unit = Unit::metre, .min = 1e-5, .max = 1, .usual = {0.0002, 0.005}}, "Radius of the petiole.")
      .only_with("petiole", {"petiole_radius"});
}

const ParameterTable& leaf_blade_table() {
  static const ParameterTable table = with_curve_range(
      with_bends(with_outline(Table<LeafBlade>("a leaf", "A leaf blade with its stalk.")))
          .integer("rows", &LeafBlade::rows, {.min = 1, .max = 256, .usual = {1, 32}, .fixed = true},
                   "Number of quads from base to tip; raised, the mesh follows outline and curl more closely.")
          .integer("across", &LeafBlade::across, {.min = 2, .max = 64, .usual = {2, 16}, .fixed = true},
                   "Number of quads from edge to edge, which must be even; raised, bends across are smoother.")
          .choice("edge", &LeafBlade::edge, {"shape", "picture"},
                  "How the edge is made: with 'shape', the mesh follows the outline; with 'picture', the texture cuts "
                  "the outline out of a simple hull."),
      "outline", 0, 1);
  return table;
}

}  // namespace

ComponentType leaf_component() {
  return define_component<Leaf>({
      .traits =
          {.name = "leaf",
           .doc = "A leaf blade with its stalk; it heads along y with its upper face to z.",
           .material = {.colour = {0.33F, 0.46F, 0.20F}, .roughness = 0.6F, .translucency = 0.35F, .two_sided = true},
           .variety = 0.12,
           .tropism = Tropism::face},
      .parameters = Table<Leaf>("a leaf", "A leaf blade with its stalk.")
                        .members(&Leaf::blade, leaf_blade_table())
                        .check(check_leaf),
      .expand = expand,
      .texture_shape = [](const Leaf& leaf) { return leaf_texture_shape(leaf.blade); },
      .minimum_triangles = minimum_triangles,
  });
}

}  // namespace meristem
