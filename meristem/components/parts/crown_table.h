// SPDX-License-Identifier: Apache-2.0
// Crowns and their points as parameters of documents.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/graph/component.h"
#include "meristem/graph/import_table.h"
#include "meristem/scene/crown/crown.h"
#include "meristem/scene/file/read_points.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// A crown by its radius at each height, for one azimuth.
struct ProfileParameters {
  std::vector<Vec2> profile;  ///< (radius, height), metres above the root
};

/// An ellipsoid.
struct EllipsoidParameters {
  Vec3 centre{0};  ///< metres from the root
  Vec3 radii{1};   ///< half axes along x, y and z, metres
};

/// A sphere.
struct SphereParameters {
  Vec3 centre{0};     ///< metres from the root
  double radius = 1;  ///< metres
};

/// A cone on a horizontal disc.
struct ConeParameters {
  Vec3 base{0};       ///< middle of the disc, metres from the root
  double radius = 1;  ///< radius of the disc, metres
  double height = 2;  ///< of the apex above the disc, metres
};

/// An upright cylinder.
struct UprightCylinderParameters {
  Vec3 base{0};       ///< middle of the lower disc, metres from the root
  double radius = 1;  ///< metres
  double height = 2;  ///< metres
};

/// A pyramid on a horizontal square.
struct PyramidParameters {
  Vec3 base{0};       ///< middle of the square, metres from the root
  double width = 2;   ///< side of the square, metres
  double height = 2;  ///< of the apex above the square, metres
};

/// A ring around a vertical axis.
struct TorusParameters {
  Vec3 centre{0};      ///< metres from the root
  double radius = 1;   ///< of the circle in the middle of the tube, metres
  double tube = 0.25;  ///< radius of the tube, metres
};

/// All space on one side of a plane.
struct HalfSpaceParameters {
  Vec3 point{0};         ///< on the plane, metres from the root
  Vec3 normal{0, 1, 0};  ///< points out of the half space
};

/// Exactly one member must be set.
struct CrownParameters {
  std::vector<Vec2> profile;  ///< (radius, height), metres from the root; for all azimuths
  std::vector<std::pair<std::string, ProfileParameters>> profiles;  ///< by azimuth, degrees
  std::vector<CrownParameters> united;                              ///< crowns whose union is the crown
  std::vector<CrownParameters> intersected;                         ///< crowns whose intersection is the crown
  std::vector<CrownParameters> subtracted;                          ///< all others are subtracted from the first
  std::optional<EllipsoidParameters> ellipsoid;                     ///< an ellipsoid
  std::optional<SphereParameters> sphere;                           ///< a sphere
  std::optional<ConeParameters> cone;                               ///< a cone
  std::optional<UprightCylinderParameters> cylinder;                ///< an upright cylinder
  std::optional<PyramidParameters> pyramid;                         ///< a pyramid
  std::optional<TorusParameters> torus;                             ///< a torus
  std::optional<HalfSpaceParameters> half_space;                    ///< a half space
  std::optional<Box> box;                                           ///< corners in any order, metres from the root
  Asset<ClosedMesh> mesh;                                           ///< a closed mesh from a file
  ImportPose mesh_place;                                            ///< place of the mesh's file
};

/// A part of the points that fills a zone of the crown.
struct ShareParameters {
  double share = 0;  ///< share of the points, 0 to 1
  double above = 0;  ///< lower end of the zone, as a share of the crown's height
  double outer = 1;  ///< share of the radius that belongs to the zone, from outside
};

/// The attraction points of a tree.
struct PointsParameters {
  std::uint64_t count = 2400;           ///< number of points in the crown
  std::vector<ShareParameters> shares;  ///< zones with more points
  bool blue_noise = false;              ///< true: points keep a distance from each other
  Asset<PointCloud> file;               ///< replaces the members above
  ImportPose file_place;                ///< place of the file's points
};

const ParameterTable& crown_table();   ///< table of CrownParameters
const ParameterTable& points_table();  ///< table of PointsParameters

/// Reports a missing crown, shares with an empty part of the crown, and more points than allowed if the crown is filled
/// `times` times. `path` is the component's path; `component` is its name in messages, such as "a colonize".
void check_cloud(const std::optional<CrownParameters>& crown, const PointsParameters& points, std::size_t times,
                 std::string_view component, const DocumentPath& path, ParameterReader& reader);

/// Returns the crown of checked parameters; null if a list is empty.
CrownPointer build_crown(const CrownParameters& form);

/// The roots of trees and the crowns that they grow into.
struct RootsInCrowns {
  const std::optional<CrownParameters>& crown;  ///< form of the crown; unset: the points come from a file
  const PointsParameters& points;               ///< number, distribution or file of the points
  const std::vector<Vec3>& roots;               ///< in the component's frame
  bool one_crown;                               ///< true: one crown above the component's origin; false: one per root

  /// Returns true if all roots grow into common points.
  bool share_points() const { return one_crown || points.file; }
};

/// The attraction points of one root, in the component's frame. Points of the root's own crown are relative to the root
/// at `base`. Points shared by all roots belong to the first root.
struct PointsOfRoot {
  Vec3 base{0};              ///< position of the root, metres
  std::vector<Vec3> points;  ///< relative to `base`
};
/// Throws what make_points() throws.
std::vector<PointsOfRoot> points_of_roots(const RootsInCrowns& trees, RandomKey key, const GrowContext& context);

/// Returns the attraction points of one tree, relative to its root. If `points` names a file, these are the file's
/// points inside the crown. Otherwise the crown is filled as `points` defines. Throws InputError at the component's
/// crown or points.
std::vector<Vec3> make_points(const std::optional<CrownParameters>& crown, const PointsParameters& points,
                              RandomKey key, const GrowContext& context);

}  // namespace meristem
