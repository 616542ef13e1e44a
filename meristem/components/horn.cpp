// SPDX-License-Identifier: Apache-2.0
// A cross-section or primitive along the curve of a stem. The section 'ring' is the stem itself. An outline or a
// line is lofted through the stem's nodes. Areas and primitives are placed on the ribs. All sections except rings have
// an invisible stem, so that links can place children along it.
#include "meristem/components/horn.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "meristem/base/math.h"
#include "meristem/components/parts/shared_shape.h"
#include "meristem/components/parts/surface_table.h"
#include "meristem/components/parts/unit_shape.h"
#include "meristem/shape/tube/loft.h"

namespace meristem {

namespace {

constexpr double kThinnest = 1e-6;     // relative to the length: thinner sections are points
constexpr double kRadiiAnOctave = 64;  // steps per octave for rounding the radii of outlines that share meshes
constexpr std::size_t kMaxRibs = 100'000;

/// A cross-section on the curve.
struct Rib {
  Frame frame;  ///< in world space, rotated by the twist
  float u = 0;
  float radius = 0;    ///< in the horn's own frame, metres
  float part = 1;      ///< scale of a rib that is still appearing; 1: complete
  NodeIndex node = 0;  ///< on the segment of the stem that ends in this node
  float along = 1;     ///< position on this segment, from 0 to 1
};

/// Returns a frame with perpendicular axes of equal length and nearly the original upper side.
Frame even_frame(const Frame& frame) {
  const float scale = glm::length(frame.heading());
  const Vec3 heading = normalized_or(frame.heading(), kUp);
  const Vec3 right =
      normalized_or(frame.right() - glm::dot(frame.right(), heading) * heading, any_perpendicular(heading));
  return {scale * Mat3(right, heading, glm::cross(right, heading)), frame.origin};
}

Frame twisted(Frame frame, double angle) {
  frame.axes = frame.axes * rotation(kUp, angle);
  return frame;
}

double radius_at(const StemParameters& stem, double u) { return std::max(0.0, stem.taper(u)) * stem.radius; }

Rib rib_at(const Horn& horn, const StemPath& path, double u) {
  const double place = u * static_cast<double>(path.frames.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), path.frames.size() - 2);
  const auto share = static_cast<float>(place - static_cast<double>(below));
  const Frame& low = path.frames[below];
  const Frame& high = path.frames[below + 1];
  const Frame between =
      even_frame({low.axes * (1 - share) + high.axes * share, glm::mix(low.origin, high.origin, share)});
  Frame frame = between;
  frame.axes *= glm::length(low.heading()) / glm::length(between.heading());
  return {.frame = twisted(frame, horn.twist * u),
          .u = static_cast<float>(u),
          .radius = static_cast<float>(radius_at(horn.stem, u)),
          .node = static_cast<NodeIndex>(below + 1),
          .along = share};
}

/// The part of the curve that is left by the surroundings.
struct CurveLeft {
  float share = 1;    ///< share of the length
  bool fits = false;  ///< true: the radii of the whole curve are compressed to the remaining length

  /// Returns the position on the whole curve with the form at `u`.
  double thick_as(double u) const { return fits && share > 0 ? u / share : u; }
  /// Returns the factor of all radii.
  float thickness() const { return fits ? share : 1; }
};

/// Returns the remaining ribs for primitives.
std::vector<Rib> ribs_left(const Horn& horn, const StemPath& path, const std::vector<Rib>& ribs, CurveLeft left) {
  std::vector<Rib> stay;
  for (const Rib& rib : ribs) {
    if (left.share == 1) {
      stay.push_back(rib);
    } else if (left.fits) {
      stay.push_back(rib_at(horn, path, rib.u * left.share));
      stay.back().radius = rib.radius * left.thickness();
      stay.back().part = rib.part;
    } else if (rib.u <= left.share) {
      stay.push_back(rib);
    }
  }
  return stay;
}

/// While the last rib appears at the tip, the earlier ribs move together.
std::vector<Rib> ribs_of(const Horn& horn, const StemPath& path) {
  std::vector<Rib> ribs;
  const double spaces = horn.ribs.value - 1;
  for (std::uint32_t k = 0; k < horn.ribs.parts(); ++k) {
    ribs.push_back(rib_at(horn, path, k == 0 ? 0 : std::min(1.0, static_cast<double>(k) / spaces)));
  }
  if (!ribs.empty()) ribs.back().part = static_cast<float>(horn.ribs.last());
  return ribs;
}

Mesh make_outline_mesh(const Horn& horn, const StemParameters& stem, const StemPath& path, CurveLeft left) {
  std::vector<LoftSection> sections;
  const auto add = [&](const Frame& frame, double u) {
    const double radius = left.thickness() * radius_at(stem, left.thick_as(u));
    LoftSection& section = sections.emplace_back(LoftSection{.is_closed = horn.section == Horn::Section::outline});
    if (radius < kThinnest * stem.length) {
      section.points.push_back(frame.origin);
      return;
    }
    for (const Vec2 point : horn.outline) {
      section.points.push_back(frame.point(static_cast<float>(radius) * Vec3(point.x, 0, point.y)));
    }
  };
  for (std::size_t k = 0; k < path.frames.size(); ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(path.frames.size() - 1);
    if (u > left.share) break;
    add(twisted(path.frames[k], horn.twist * u), u);
  }
  if (left.share < 1) add(rib_at(horn, path, left.share).frame, left.share);
  return make_loft(sections).mesh;
}

/// Returns the curve of a horn of length 1 in the horn's own frame. Gravity, light and obstacles act on it as on a horn
/// of length `length` at its site.
StemPath unit_path(const StemParameters& unit, float length, const Site& site, StemTropisms tropisms) {
  Site own;
  own.key = site.key;
  if (!tropisms.act()) return grow_stem(unit, own, {});
  const Frame frame = even_frame(site.frame);
  const Mat3 back = glm::transpose(frame.axes / glm::length(frame.heading()));
  own.frame.axes = glm::transpose(back);
  tropisms.origin = frame.origin;
  tropisms.stretch = length * glm::length(frame.heading());
  StemPath path = grow_stem(unit, own, tropisms);
  for (Frame& each : path.frames) each = {back * each.axes, back * each.origin};
  return path;
}

/// Returns a key for the effect of the world on the curve of a horn at a site.
std::uint64_t world_key(const Site& site, const StemTropisms& tropisms, const Surroundings& surroundings) {
  if (!tropisms.act()) return 0;
  const Mat3 axes = even_frame(site.frame).axes / glm::length(site.frame.heading());
  const Vec3 right = axes[0], heading = axes[1];
  const std::uint64_t key = shape_key(
      {tropisms.gravitropism, tropisms.phototropism, right.x, right.y, right.z, heading.x, heading.y, heading.z});
  return RandomKey(key).child(tropisms.directions->key_at(site.frame.origin)).child(surroundings.hash).bits();
}

void emit_outline(const Horn& horn, const Site& site, const StemTropisms& tropisms, CurveLeft left,
                  const InstanceContext& instance, OrganSink& organs) {
  if (left.share == 0) return;
  StemParameters unit = horn.stem;
  unit.radius = to_octaves(horn.stem.radius / horn.stem.length, kRadiiAnOctave);
  unit.length = 1;
  const std::uint64_t form = shape_key({unit.radius, unit.curl, unit.spiral, unit.gnarl, unit.gnarl_waves, horn.twist});
  const std::uint64_t chance = unit.gnarl == 0 ? 0 : site.key.bits();
  const std::uint64_t trimmed = left.share == 1 ? 0 : shape_key({left.share, left.fits ? 1.0 : 0.0});
  const std::uint64_t key =
      RandomKey(form).child(chance).child(world_key(site, tropisms, instance.surroundings())).child(trimmed).bits();
  Frame frame{glm::inverse(site.frame.axes) * even_frame(site.frame).axes, Vec3(0)};
  const auto length = static_cast<float>(horn.stem.length);
  frame.axes *= length;
  organs.add(frame, key, [&] { return make_outline_mesh(horn, unit, unit_path(unit, length, site, tropisms), left); });
}

/// Returns the filled outline of radius 1, across the heading.
Mesh make_area(const std::vector<Vec2>& outline) {
  LoftSection section;
  for (const Vec2 point : outline) section.points.emplace_back(point.x, 0, point.y);
  return make_loft({{section}}).mesh;
}

/// Emits a flat area at each rib.
void emit_areas(const Horn& horn, const Site& site, const std::vector<Rib>& ribs, OrganSink& organs) {
  const Mat3 back = glm::inverse(site.frame.axes);
  for (const Rib& rib : ribs) {
    if (rib.radius < kThinnest * horn.stem.length) continue;
    Frame local{back * rib.frame.axes, back * (rib.frame.origin - site.frame.origin)};
    local.axes *= rib.radius * rib.part;
    organs.add(local, shape_key({-1}), [&] { return make_area(horn.outline); });
  }
}

/// Emits a primitive at each rib: as wide and high as the curve there, and centred on it.
void emit_primitives(const Horn& horn, const Site& site, const std::vector<Rib>& ribs, OrganSink& organs) {
  const auto shape = static_cast<UnitShape>(static_cast<int>(horn.section) - static_cast<int>(Horn::Section::box));
  const Mat3 back = glm::inverse(site.frame.axes);
  const std::uint64_t key = shape_key({static_cast<double>(shape), static_cast<double>(horn.around)});
  for (const Rib& rib : ribs) {
    if (rib.radius < kThinnest * horn.stem.length) continue;
    const float width = 2 * rib.radius * rib.part;
    const float height = shape == UnitShape::torus ? kTorusTube * width : width;
    const Frame local{back * rib.frame.axes, back * (rib.frame.origin - site.frame.origin)};
    const Frame lowered{Mat3(1), {0, -0.5F * height, 0}};
    organs.add(local * lowered * unit_shape_frame(shape, {width, height, width}), key,
               [&] { return make_unit_shape(shape, horn.around); });
  }
}

void expand(const Horn& horn, const Site& site, const InstanceContext& instance, OrganSink& organs, StemSink& stems,
            SiteSink& sites) {
  const StemTropisms tropisms{&instance.directions(), horn.gravitropism, horn.phototropism};
  StemPath path = grow_stem(horn.stem, site, tropisms);
  sites.expect_parts(member_of(horn, &Horn::ribs));
  const std::vector<Rib> ribs = ribs_of(horn, path);
  if (horn.section == Horn::Section::ring) {
    stems.add(std::move(path.skeleton), horn.surface, {.trim = horn.trim});
  } else {
    stems.add_unseen(std::move(path.skeleton), horn.trim);
    const CurveLeft left{stems.length_left(), horn.trim == TrimMode::fit};
    if (horn.section == Horn::Section::outline || horn.section == Horn::Section::line) {
      emit_outline(horn, site, tropisms, left, instance, organs);
    } else if (horn.section == Horn::Section::area) {
      emit_areas(horn, site, ribs_left(horn, path, ribs, left), organs);
    } else {
      emit_primitives(horn, site, ribs_left(horn, path, ribs, left), organs);
    }
  }
  const float scale = glm::length(site.frame.heading());
  for (const Rib& rib : ribs) {
    sites.add_on_stem(rib.frame, rib.u, path.length, scale * rib.radius, {rib.node, rib.along});
  }
  sites.add_at_tip(twisted(path.frames.back(), horn.twist), path.length,
                   scale * static_cast<float>(radius_at(horn.stem, 1)));
}

/// Returns true if the section is made of the points of `outline`.
bool has_outline(Horn::Section section) {
  return section == Horn::Section::outline || section == Horn::Section::line || section == Horn::Section::area;
}

void check_horn(const Horn& horn, const DocumentPath& place, ParameterReader& reader) {
  check_stem_form(horn.stem, place, reader);
  const DocumentPath outline(place, "outline");
  if (!has_outline(horn.section)) return;
  LoftSection section{.is_closed = horn.section != Horn::Section::line};
  for (const Vec2 point : horn.outline) section.points.emplace_back(point.x, 0, point.y);
  const auto error = find_error(section);
  if (error && error->point) {
    reader.add_error(DocumentPath(outline, *error->point), error->message, error->expected);
  } else if (error) {
    reader.add_error(outline, error->message, error->expected);
  } else if (section.is_point()) {
    reader.add_error(outline, "the outline is a single point",
                     section.is_closed ? "at least 3 points" : "at least 2 points");
  }
}

}  // namespace

ComponentType horn_component() {
  return define_component<Horn>({
      .traits = {.name = "horn",
                 .doc = "A cross-section or a row of primitives along a curve. Branch links without placement set "
                        "children on its "
                        "ribs, child links at its tip.",
                 .material = {.colour = {0.48F, 0.44F, 0.34F}, .roughness = 0.7F},
                 .makes_stems = true,
                 .has_ribs = true,
                 .stance = BranchStance::on_axis,
                 .tropism = Tropism::none},
      .parameters =
          Table<Horn>("a horn", "A cross-section or a row of primitives along a curve.")
              .members(&Horn::stem, stem_form_table())
              .choice("section", &Horn::section,
                      {"ring", "outline", "line", "area", "box", "sphere", "cylinder", "cone", "torus"},
                      "What follows the curve: 'ring', a stem that other stems can join; 'outline' and 'line', a "
                      "closed or open surface; 'area', the filled outline on each rib; or a primitive on each rib.")
              .points("outline", &Horn::outline, {.min = -1e4, .max = 1e4},
                      "Points [x, z] of the cross-section for the sections 'outline', 'line' and 'area', as shares of "
                      "the radius.")
              .together(PointsForm::polygon)
              .number("twist", &Horn::twist, {.unit = Unit::degree, .min = -36000, .max = 36000, .usual = {-720, 720}},
                      "Twist of section and ribs about the curve from base to tip.")
              .count("ribs", &Horn::ribs, {.min = 1, .max = kMaxRibs, .usual = {1, 60}},
                     "Number of ribs evenly along the curve, both ends included; they bear primitives and the children "
                     "of branch links. With a fraction, the last one has that much of its size.")
              .integer("around", &Horn::around, {.min = 3, .max = 512, .usual = {3, 64}, .fixed = true},
                       "Number of corners around each primitive; raised, rounder, with more triangles.")
              .object("surface", &Horn::surface, surface_table, "How the stem of the section 'ring' becomes a surface.")
              .choice("trim", &Horn::trim, trim_modes(), kTrimDoc)
              .only_where({{"section", {"outline", "line", "area"}}}, {"outline"})
              .only_where({{"section", {"sphere", "cylinder", "cone", "torus"}}}, {"around"})
              .only_where({{"section", {"ring"}}}, {"surface"})
              .only_where({{"surface.style", {"tubes"}}}, {"texture"})
              .only_where({{"section", {"outline", "line", "area", "box", "sphere", "cylinder", "cone", "torus"}}},
                          names_off_stems())
              .check(check_horn),
      .expand = expand,
      .is_sheet =
          [](const Horn& horn) { return horn.section == Horn::Section::line || horn.section == Horn::Section::area; },
  });
}

}  // namespace meristem
