// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/simple.h"

#include <algorithm>

#include "meristem/base/math.h"
#include "meristem/components/parts/unit_shape.h"
#include "meristem/shape/mesh/shading.h"
#include "meristem/shape/tube/loft.h"

namespace meristem {

namespace {

bool is_section(Simple::Shape shape) { return shape == Simple::Shape::area || shape == Simple::Shape::tube; }

/// Returns the section of an area or tube. An outline from the document has its own size. Default sections have width
/// and depth 1 and are stretched to the size.
LoftSection make_section(const Simple& simple) {
  const bool is_tube = simple.shape == Simple::Shape::tube;
  LoftSection section{.is_closed = is_tube, .is_round = is_tube && simple.outline.empty()};
  for (const Vec2 point : simple.outline) section.points.emplace_back(point.x, 0, point.y);
  if (!simple.outline.empty()) return section;
  if (!is_tube) {
    section.points = {{-0.5F, 0, 0}, {0.5F, 0, 0}};
    return section;
  }
  for (int k = 0; k < simple.segments; ++k) {
    const double angle = 2 * kPi * k / simple.segments;
    section.points.emplace_back(0.5 * math::sin(angle), 0, 0.5 * math::cos(angle));
  }
  return section;
}

/// Returns the section in counter-clockwise order seen from above, so that any two tubes can be joined.
LoftSection make_even_section(const Simple& simple) {
  LoftSection section = make_section(simple);
  double area = 0;
  for (std::size_t k = 0; k < section.points.size(); ++k) {
    const Vec3 a = section.points[k], b = section.points[(k + 1) % section.points.size()];
    area += double{a.z} * b.x - double{a.x} * b.z;
  }
  if (section.is_closed && area < 0) std::reverse(section.points.begin() + 1, section.points.end());
  return section;
}

void emit_section(const Simple& simple, OrganSink& organs) {
  const bool is_own = !simple.outline.empty();
  Frame frame;
  if (!is_own) frame.axes = Mat3(simple.size.x, 0, 0, 0, 1, 0, 0, 0, simple.size.z);
  const double segments = is_own ? 0 : simple.segments;
  organs.add_section(frame, shape_key({static_cast<double>(simple.shape), segments}), simple.cap,
                     [&] { return make_even_section(simple); });
}

/// The enumerators of primitives have the order of UnitShape.
void emit_primitive(const Simple& simple, const InstanceContext& instance, OrganSink& organs) {
  const auto shape = static_cast<UnitShape>(simple.shape);
  const bool is_flat = simple.shading == Simple::Shading::flat;
  // Smoothly shaded primitives keep the key that they had before the parameter existed.
  const auto number = static_cast<double>(simple.shape);
  const double segments = simple.segments;
  const std::uint64_t key = is_flat ? shape_key({number, segments, 1}) : shape_key({number, segments});
  organs.add(unit_shape_frame(shape, simple.size), key, [&] {
    const Mesh mesh = make_unit_shape(shape, simple.segments);
    return is_flat ? flat_shaded(mesh, instance.progress()) : mesh;
  });
}

void expand(const Simple& simple, const Site&, const InstanceContext& instance, OrganSink& organs, SiteSink& sites) {
  if (is_section(simple.shape)) {
    emit_section(simple, organs);
  } else if (simple.shape != Simple::Shape::none) {
    emit_primitive(simple, instance, organs);
  }
  Frame top;
  top.origin.y = simple.size.y;
  sites.add(top, simple.size.y, 0.5F * simple.size.x);
}

double minimum_triangles(const Simple& simple, const KnownMembers& known) {
  if (is_section(simple.shape) || simple.shape == Simple::Shape::none) return 0;
  const int segments = std::max(3, static_cast<int>(known.minimum(member_of(simple, &Simple::segments))));
  return unit_shape_triangles(static_cast<UnitShape>(simple.shape), segments);
}

void check_outline(const Simple& simple, const DocumentPath& path, ParameterReader& reader) {
  if (simple.outline.empty()) return;
  const DocumentPath outline(path, "outline");
  if (const auto error = find_error(make_section(simple))) {
    if (error->point) {
      reader.add_error(DocumentPath(outline, *error->point), error->message, error->expected);
    } else {
      reader.add_error(outline, error->message, error->expected);
    }
  }
}

}  // namespace

ComponentType simple_component() {
  return define_component<Simple>({
      .traits =
          {.name = "simple",
           .doc =
               "A box, sphere, cylinder, cone or torus that stands on its frame, or a section of a surface that joins "
               "the sections of its children. Children stand on top.",
           .material = {.colour = {0.69F, 0.66F, 0.61F}, .roughness = 0.8F}},
      .parameters =
          Table<Simple>("a simple", "A primitive that stands on its frame, or a section of a surface.")
              .choice("shape", &Simple::shape, {"box", "sphere", "cylinder", "cone", "torus", "none", "area", "tube"},
                      "Kind of shape: a primitive, 'none', or a section of a surface, which is an open row of points "
                      "('area') or a closed ring ('tube').")
              .vector("size", &Simple::size, {.unit = Unit::metre, .min = 1e-6, .max = 1e4, .usual = {0.001, 0.5}},
                      "Width (x), height (y) and depth (z) of the shape.")
              .integer("segments", &Simple::segments, {.min = 3, .max = 512, .usual = {3, 64}},
                       "Number of corners around the shape; raised, rounder, with more triangles.")
              .choice("shading", &Simple::shading, {"smooth", "flat"},
                      "Shading of a primitive: 'smooth' hides the edges between triangles, 'flat' shows each triangle "
                      "as a plane, the low-poly look.")
              .points("outline", &Simple::outline, {.unit = Unit::metre, .min = -1e4, .max = 1e4},
                      "Points [x, z] of an area or tube in the plane across the heading; a single point makes a tip. "
                      "By default, a line over the width, or an ellipse over width and depth.")
              .boolean("cap", &Simple::cap, "Whether a tube is closed where its surface ends.")
              .only_where({{"shape", {"area", "tube"}}}, {"outline"})
              .only_where({{"shape", {"sphere", "cylinder", "cone", "torus", "tube"}}}, {"segments"})
              .only_where({{"shape", {"sphere", "cylinder", "cone", "torus"}}}, {"shading"})
              .never_with("outline", {"segments"})
              .only_where({{"shape", {"tube"}}}, {"cap"})
              .only_where({{"shape", {"box", "sphere", "cylinder", "cone", "torus", "area", "tube"}}}, look_names())
              .check(check_outline),
      .expand = expand,
      .minimum_counts = [](const Simple&, const KnownMembers&) { return MinimumCounts{.children = 1}; },
      .minimum_triangles = minimum_triangles,
  });
}

}  // namespace meristem
