// SPDX-License-Identifier: Apache-2.0
// Tables of crowns and points, checks of their parameters, and the crowns and points that they describe.
#include "meristem/components/parts/crown_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/scene/crown/combined_crown.h"
#include "meristem/scene/crown/crown_points.h"
#include "meristem/scene/crown/mesh_crown.h"
#include "meristem/scene/crown/profile_crown.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "meristem/scene/file/read_mesh.h"

namespace meristem {

namespace {

constexpr NumberRange kCoordinate{.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-10, 10}};
constexpr NumberRange kProfileRadius{.unit = Unit::metre, .min = 0, .max = 1e5, .usual = {0, 20}};
constexpr double kMaxProfileHeight = 1e5;  // metres above or below the root
constexpr UsualSpan kUsualProfileHeight{0, 20};
constexpr NumberRange kLength{.unit = Unit::metre, .min = 0, .max = 1e5, .usual = {0.1, 20}, .above_min = true};
constexpr std::size_t kMaxShares = 100;
constexpr double kFarthestPoint = 1e7;  // metres along an axis, enough for national grids

/// Returns the azimuth of a key of `profiles` in degrees.
std::optional<double> azimuth_of(const std::string& key) {
  double azimuth = 0;
  const auto parsed = std::from_chars(key.data(), key.data() + key.size(), azimuth);
  const bool is_whole = parsed.ec == std::errc() && parsed.ptr == key.data() + key.size();
  return is_whole && std::isfinite(azimuth) ? std::optional(azimuth) : std::nullopt;
}

bool check_profile(const std::vector<Vec2>& profile, const DocumentPath& path, ParameterReader& reader) {
  if (profile.size() < 2) {
    reader.add_error(path, "the profile has fewer than two points", "pairs [radius, height] with rising heights");
    return false;
  }
  for (std::size_t k = 0; k < profile.size(); ++k) {
    if (k > 0 && !(profile[k - 1].y < profile[k].y)) {
      reader.add_error(DocumentPath(path, k), fmt::format("the height {:.7g} does not rise", profile[k].y),
                       fmt::format("a height above {:.7g}", profile[k - 1].y));
      return false;
    }
  }
  return true;
}

bool check_profiles(const CrownParameters& crown, const DocumentPath& path, ParameterReader& reader) {
  std::vector<std::pair<double, std::string>> seen;
  for (const auto& [key, side] : crown.profiles) {
    const DocumentPath at(path, key);
    const std::optional<double> azimuth = azimuth_of(key);
    if (!azimuth) {
      reader.add_name_error(at, fmt::format("'{}' is not an azimuth", key),
                            "degrees from north over east, such as \"90\"", "");
      return false;
    }
    if (!check_profile(side.profile, at, reader)) return false;
    seen.emplace_back(wrapped_azimuth(radians(*azimuth)), key);
  }
  std::sort(seen.begin(), seen.end());
  for (std::size_t k = 1; k < seen.size(); ++k) {
    if (seen[k].first > seen[k - 1].first) continue;
    reader.add_name_error(DocumentPath(path, seen[k].second),
                          fmt::format("'{}' and '{}' are one azimuth", seen[k - 1].second, seen[k].second),
                          "a profile for each azimuth once", "");
    return false;
  }
  return true;
}

bool check_box(const Box& box, const DocumentPath& path, ParameterReader& reader) {
  constexpr const char* kAxes = "xyz";
  for (int k = 0; k < 3; ++k) {
    if (box.low[k] < box.high[k]) continue;
    reader.add_error(
        path, fmt::format("the box ends in {} at {:.7g}, where it begins at {:.7g}", kAxes[k], box.high[k], box.low[k]),
        "the lower corner first, and some size along each axis");
    return false;
  }
  return true;
}

void check_crown(const CrownParameters& crown, const DocumentPath& path, ParameterReader& reader) {
  if (!crown.profile.empty() && !check_profile(crown.profile, DocumentPath(path, "profile"), reader)) return;
  if (!check_profiles(crown, DocumentPath(path, "profiles"), reader)) return;
  if (crown.box && !check_box(*crown.box, DocumentPath(path, "box"), reader)) return;
  if (crown.half_space && crown.half_space->normal == Vec3(0)) {
    return reader.add_error(DocumentPath(DocumentPath(path, "half_space"), "normal"), "the normal has no length",
                            "a direction such as [0, 1, 0]");
  }
  if (crown.torus && crown.torus->tube > crown.torus->radius) {
    return reader.add_error(DocumentPath(DocumentPath(path, "torus"), "tube"),
                            fmt::format("the tube of {:.7g} m is thicker than the torus of {:.7g} m", crown.torus->tube,
                                        crown.torus->radius),
                            "at most the torus's radius");
  }
  const CrownPointer built = build_crown(crown);
  if (built == nullptr) {
    return reader.add_error(path, "the crown is empty: its list has no parts",
                            "at least one profile or crown in its list");
  }
  const auto is_zero = [](Vec2 point) { return point.x == 0; };
  if (!crown.profile.empty() && std::all_of(crown.profile.begin(), crown.profile.end(), is_zero)) {
    return reader.add_error(DocumentPath(path, "profile"), "the crown is empty: all its radii are 0",
                            "a radius above 0 somewhere");
  }
  if (!is_fillable(*built)) {
    reader.add_error(path, "the crown is empty, or nearly",
                     "a crown that fills at least a thousandth of the box around it");
  }
}

void check_points(const PointsParameters& points, const DocumentPath& path, ParameterReader& reader) {
  const DocumentPath shares(path, "shares");
  if (points.shares.size() > kMaxShares) {
    return reader.add_error(shares, fmt::format("{} shares are too many", points.shares.size()),
                            fmt::format("at most {}", kMaxShares));
  }
  double sum = 0;
  for (const ShareParameters& share : points.shares) sum += share.share;
  if (sum > 1 + 1e-9) {
    reader.add_error(shares, fmt::format("the shares sum to {:.7g}", sum), "shares that sum to at most 1");
  }
}

const ParameterTable& profile_table() {
  static const ParameterTable table =
      Table<ProfileParameters>("a profile", "Half of a crown's outline on one side.")
          .points("profile", &ProfileParameters::profile, kProfileRadius,
                  "Points [radius, height] of the crown's outline above the root, with rising heights.")
          .second(-kMaxProfileHeight, kMaxProfileHeight, kUsualProfileHeight)
          .together(PointsForm::silhouette)
          .in_space(InSpace::profile)
          .required()
          .shorthand("profile");
  return table;
}

const ParameterTable& ellipsoid_table() {
  static const ParameterTable table =
      Table<EllipsoidParameters>("an ellipsoid", "A ball stretched along the axes.")
          .vector("centre", &EllipsoidParameters::centre, kCoordinate, "Centre of the ellipsoid, relative to the root.")
          .in_space(InSpace::position)
          .required()
          .vector("radii", &EllipsoidParameters::radii, kLength, "Radii of the ellipsoid along x, y and z.")
          .in_space(InSpace::radii)
          .required();
  return table;
}

const ParameterTable& sphere_table() {
  static const ParameterTable table =
      Table<SphereParameters>("a sphere", "A ball.")
          .vector("centre", &SphereParameters::centre, kCoordinate, "Centre of the sphere, relative to the root.")
          .in_space(InSpace::position)
          .required()
          .number("radius", &SphereParameters::radius, kLength, "Radius of the sphere.")
          .in_space(InSpace::radius)
          .required();
  return table;
}

const ParameterTable& cone_table() {
  static const ParameterTable table =
      Table<ConeParameters>("a cone", "A cone with its apex up.")
          .vector("base", &ConeParameters::base, kCoordinate, "Centre of the cone's base, relative to the root.")
          .in_space(InSpace::position)
          .required()
          .number("radius", &ConeParameters::radius, kLength, "Radius of the cone's base.")
          .in_space(InSpace::radius)
          .required()
          .number("height", &ConeParameters::height, kLength, "Height of the cone from its base to its apex.")
          .in_space(InSpace::height)
          .required();
  return table;
}

const ParameterTable& cylinder_table() {
  static const ParameterTable table =
      Table<UprightCylinderParameters>("a cylinder", "An upright cylinder.")
          .vector("base", &UprightCylinderParameters::base, kCoordinate,
                  "Centre of the cylinder's base, relative to the root.")
          .in_space(InSpace::position)
          .required()
          .number("radius", &UprightCylinderParameters::radius, kLength, "Radius of the cylinder.")
          .in_space(InSpace::radius)
          .required()
          .number("height", &UprightCylinderParameters::height, kLength, "Height of the cylinder.")
          .in_space(InSpace::height)
          .required();
  return table;
}

const ParameterTable& pyramid_table() {
  static const ParameterTable table =
      Table<PyramidParameters>("a pyramid", "A pyramid on a square, with its apex up.")
          .vector("base", &PyramidParameters::base, kCoordinate, "Centre of the pyramid's base, relative to the root.")
          .in_space(InSpace::position)
          .required()
          .number("width", &PyramidParameters::width, kLength, "Length of each side of the pyramid's square base.")
          .in_space(InSpace::width)
          .required()
          .number("height", &PyramidParameters::height, kLength, "Height of the pyramid from its base to its apex.")
          .in_space(InSpace::height)
          .required();
  return table;
}

const ParameterTable& torus_table() {
  static const ParameterTable table =
      Table<TorusParameters>("a torus", "A ring that lies flat, such as a wreath.")
          .vector("centre", &TorusParameters::centre, kCoordinate, "Centre of the torus, relative to the root.")
          .in_space(InSpace::position)
          .required()
          .number("radius", &TorusParameters::radius, kLength,
                  "Radius of the circle in the middle of the torus's tube.")
          .in_space(InSpace::radius)
          .required()
          .number("tube", &TorusParameters::tube, kLength,
                  "Radius of the torus's tube, at most the torus's radius; raised, a thicker ring with a smaller hole.")
          .required();
  return table;
}

const ParameterTable& half_space_table() {
  static const ParameterTable table =
      Table<HalfSpaceParameters>("a half space", "All that lies on one side of a plane.")
          .vector("point", &HalfSpaceParameters::point, kCoordinate, "A position on the plane, relative to the root.")
          .in_space(InSpace::position)
          .required()
          .vector("normal", &HalfSpaceParameters::normal, {.min = -1e5, .max = 1e5, .usual = {-1, 1}},
                  "Direction from the plane out of the half space, of any length above 0; [0, 1, 0] keeps what lies "
                  "below the plane.")
          .in_space(InSpace::direction)
          .required();
  return table;
}

const ParameterTable& share_table() {
  static const ParameterTable table =
      Table<ShareParameters>("a share", "A share of the attraction points for a part of the crown.")
          .number("share", &ShareParameters::share, {.min = 0, .max = 1, .above_min = true},
                  "Share of all attraction points that goes to this part of the crown.")
          .required()
          .number("above", &ShareParameters::above, {.min = 0, .max = 0.999},
                  "Height at which this part of the crown begins, as a share of the crown's height; 0.4 takes the "
                  "upper 60 %.")
          .number("outer", &ShareParameters::outer, {.min = 0.001, .max = 1},
                  "Outer share of the crown's radius that belongs to this part; lowered, a thinner shell; 1 takes all "
                  "of it.");
  return table;
}

/// Moves the points in double precision, because scans may use coordinates of a national grid.
std::vector<Vec3> points_of_file(const CrownPointer& crown, const PointsParameters& form, const GrowContext& context) {
  const DFrame frame = form.file_place.frame();
  const auto refuse = [&](std::string message, std::string expected) {
    throw InputError(Diagnostic{.message = std::move(message),
                                .expected = std::move(expected),
                                .path = "components." + context.component + ".points.file"});
  };
  std::vector<Vec3> points;
  for (const DVec3 position : *form.file) {
    const DVec3 placed = frame.point(position);
    const Vec3 point(placed);
    if (crown != nullptr && !crown->contains(point)) continue;
    const DVec3 away = glm::abs(placed);
    if (!(std::max({away.x, away.y, away.z}) <= kFarthestPoint)) {
      refuse(fmt::format("a point of '{}' comes to lie at ({:.4g}, {:.4g}, {:.4g})", form.file.path, placed.x, placed.y,
                         placed.z),
             fmt::format("coordinates within {:.0f} m; scale and translate them", kFarthestPoint));
    }
    points.push_back(point);
  }
  if (points.empty()) {
    refuse(fmt::format("none of the points of '{}' lies in the crown", form.file.path),
           "points around the crown; scale, turn or translate them");
  }
  return points;
}

/// Reports shares whose part of the crown is empty.
void check_shares(const CrownParameters& crown, const PointsParameters& points, const DocumentPath& path,
                  ParameterReader& reader) {
  if (points.shares.empty()) return;
  const CrownPointer built = build_crown(crown);
  const DocumentPath points_place(path, "points");
  const DocumentPath shares(points_place, "shares");
  for (std::size_t k = 0; k < points.shares.size(); ++k) {
    const ShareParameters& share = points.shares[k];
    if (is_fillable(ZonedCrown(*built, {.above = share.above, .outer = share.outer}))) continue;
    return reader.add_error(DocumentPath(shares, k), "the share's part of the crown is empty, or nearly",
                            "a smaller 'above' or a larger 'outer'");
  }
}

}  // namespace

const ParameterTable& crown_table() {
  static const ParameterTable table =
      Table<CrownParameters>("a crown", "The envelope that attraction points fill.")
          .points("profile", &CrownParameters::profile, kProfileRadius,
                  "Points [radius, height] of the crown's outline above the root, with rising heights; a spline "
                  "through them is turned about the vertical.")
          .second(-kMaxProfileHeight, kMaxProfileHeight, kUsualProfileHeight)
          .together(PointsForm::silhouette)
          .in_space(InSpace::profile)
          .map("profiles", &CrownParameters::profiles, profile_table,
               "Outlines by azimuth in degrees from north over east, such as \"90\"; the radius changes evenly between "
               "them.")
          .list("union", &CrownParameters::united, crown_table,
                "Crowns that are joined: the space that lies in any of them.")
          .list("intersection", &CrownParameters::intersected, crown_table,
                "Crowns that are intersected: the space that lies in all of them.")
          .list("difference", &CrownParameters::subtracted, crown_table,
                "Crowns that are subtracted: the first crown without the space that lies in any of the others.")
          .object("ellipsoid", &CrownParameters::ellipsoid, ellipsoid_table,
                  "An ellipsoid along the axes, as the crown.")
          .object("sphere", &CrownParameters::sphere, sphere_table, "A sphere as the crown.")
          .object("cone", &CrownParameters::cone, cone_table, "A cone with its apex up, as the crown.")
          .object("cylinder", &CrownParameters::cylinder, cylinder_table, "An upright cylinder as the crown.")
          .object("pyramid", &CrownParameters::pyramid, pyramid_table,
                  "A pyramid with a square base and its apex up, as the crown.")
          .object("torus", &CrownParameters::torus, torus_table, "A torus that lies flat, as the crown.")
          .object("half_space", &CrownParameters::half_space, half_space_table,
                  "All that lies on one side of a plane, to be intersected with or subtracted from other crowns.")
          .box("box", &CrownParameters::box, kCoordinate,
               "Lower and upper corner of a box, relative to the root, as the crown.")
          .file("mesh", &CrownParameters::mesh, read_closed_mesh,
                "File with a closed mesh (OBJ, PLY or GLB) as the crown.")
          .members(&CrownParameters::mesh_place, import_table())
          .one_of({"profile", "profiles", "union", "intersection", "difference", "ellipsoid", "sphere", "cone",
                   "cylinder", "pyramid", "torus", "half_space", "box", "mesh"})
          .only_with("mesh", import_names())
          .check(check_crown);
  return table;
}

const ParameterTable& points_table() {
  static const ParameterTable table =
      Table<PointsParameters>("points", "The attraction points in the crown.")
          .integer("count", &PointsParameters::count, {.min = 1, .max = 1e15, .usual = {100, 50000}},
                   "Number of attraction points; raised, more and finer branches and slower growth.")
          .list(
              "shares", &PointsParameters::shares, share_table,
              "Shares of the attraction points for parts of the crown; the remaining points are uniform in all of it.")
          .boolean("blue_noise", &PointsParameters::blue_noise,
                   "Whether neighbouring points keep a distance from each other; branches are then spread more evenly.")
          .file("file", &PointsParameters::file, read_points,
                "File with the points of a scan, relative to the root (PLY, or text with one point per line); a crown "
                "removes those outside it.")
          .members(&PointsParameters::file_place, import_table())
          .never_with("file", {"count", "shares", "blue_noise"})
          .only_with("file", import_names())
          .shorthand("count")
          .check(check_points);
  return table;
}

void check_cloud(const std::optional<CrownParameters>& crown, const PointsParameters& points, std::size_t times,
                 std::string_view component, const DocumentPath& path, ParameterReader& reader) {
  if (!crown && !points.file) {
    reader.add_error(path, fmt::format("{} has no 'crown'", component), "a 'crown', or 'points' with a 'file'");
  }
  const CrownPointer built = crown ? build_crown(*crown) : nullptr;
  if (built != nullptr && !points.file && is_endless(*built)) {
    reader.add_error(DocumentPath(path, "crown"), "the crown has no end, so its points cannot be spread over it",
                     "an 'intersection' of the half space with another crown");
  } else if (crown) {
    check_shares(*crown, points, path, reader);
  }
  const double count = static_cast<double>(points.count) * static_cast<double>(times);
  if (count > static_cast<double>(reader.limits().points)) {
    reader.add_limit_error(DocumentPath(path, "points"), "attraction points", count, reader.limits().points, "points");
  }
}

CrownPointer build_crown(const CrownParameters& form) {
  if (!form.profile.empty()) return std::make_shared<ProfileCrown>(form.profile);
  if (!form.profiles.empty()) {
    ProfileCrown::Sides sides;
    for (const auto& [key, side] : form.profiles) sides.push_back({radians(*azimuth_of(key)), side.profile});
    return std::make_shared<ProfileCrown>(sides);
  }
  if (form.ellipsoid) return std::make_shared<EllipsoidCrown>(form.ellipsoid->centre, form.ellipsoid->radii);
  if (form.sphere) return std::make_shared<EllipsoidCrown>(form.sphere->centre, Vec3(form.sphere->radius));
  if (form.cone) return std::make_shared<ConeCrown>(form.cone->base, form.cone->radius, form.cone->height);
  if (form.cylinder) {
    return std::make_shared<CylinderCrown>(form.cylinder->base, form.cylinder->radius, form.cylinder->height);
  }
  if (form.pyramid) {
    return std::make_shared<PyramidCrown>(form.pyramid->base, form.pyramid->width, form.pyramid->height);
  }
  if (form.torus) return std::make_shared<TorusCrown>(form.torus->centre, form.torus->radius, form.torus->tube);
  if (form.half_space) return std::make_shared<HalfSpaceCrown>(form.half_space->point, form.half_space->normal);
  if (form.box) return std::make_shared<BoxCrown>(*form.box);
  if (form.mesh) return std::make_shared<MeshCrown>(form.mesh.content, form.mesh_place.frame());

  const auto combined = [](CombineKind kind, const std::vector<CrownParameters>& forms) {
    std::vector<CrownPointer> crowns;
    crowns.reserve(forms.size());
    for (const CrownParameters& each : forms) crowns.push_back(build_crown(each));
    return std::make_shared<CombinedCrown>(kind, std::move(crowns));
  };
  if (!form.united.empty()) return combined(CombineKind::unite, form.united);
  if (!form.intersected.empty()) return combined(CombineKind::intersect, form.intersected);
  if (!form.subtracted.empty()) return combined(CombineKind::subtract, form.subtracted);
  return nullptr;
}

std::vector<PointsOfRoot> points_of_roots(const RootsInCrowns& trees, RandomKey key, const GrowContext& context) {
  std::vector<PointsOfRoot> all(trees.roots.size());
  if (trees.share_points()) {
    all[0].points = make_points(trees.crown, trees.points, key, context);
    return all;
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k] = {trees.roots[k], make_points(trees.crown, trees.points, k == 0 ? key : key.child(k), context)};
  }
  return all;
}

std::vector<Vec3> make_points(const std::optional<CrownParameters>& crown, const PointsParameters& points,
                              RandomKey key, const GrowContext& context) {
  if (points.file) return points_of_file(crown ? build_crown(*crown) : nullptr, points, context);
  PointDistribution distribution{.count = points.count, .blue_noise = points.blue_noise};
  for (const ShareParameters& share : points.shares) {
    distribution.shares.push_back({share.share, {.above = share.above, .outer = share.outer}});
  }
  const std::string path = "components." + context.component;
  return place_points(*build_crown(*crown), distribution, key, context.progress, path + ".crown", path + ".points");
}

}  // namespace meristem
