// SPDX-License-Identifier: Apache-2.0
// Crowns and their points as documents write them.
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

struct ProfileParameters {
  std::vector<Vec2> profile;  ///< (radius, height), metres over the root
};

struct EllipsoidParameters {
  Vec3 centre{0};
  Vec3 radii{1};
};

struct SphereParameters {
  Vec3 centre{0};
  double radius = 1;
};

struct ConeParameters {
  Vec3 base{0};
  double radius = 1;
  double height = 2;
};

struct UprightCylinderParameters {
  Vec3 base{0};
  double radius = 1;
  double height = 2;
};

struct PyramidParameters {
  Vec3 base{0};
  double width = 2;
  double height = 2;
};

struct HalfSpaceParameters {
  Vec3 point{0};
  Vec3 normal{0, 1, 0};
};

/// Exactly one member is given.
struct CrownParameters {
  std::vector<Vec2> profile;
  std::vector<std::pair<std::string, ProfileParameters>> profiles;  ///< by azimuth, degrees
  std::vector<CrownParameters> united;
  std::vector<CrownParameters> intersected;
  std::vector<CrownParameters> subtracted;  ///< all others from the first
  std::optional<EllipsoidParameters> ellipsoid;
  std::optional<SphereParameters> sphere;
  std::optional<ConeParameters> cone;
  std::optional<UprightCylinderParameters> cylinder;
  std::optional<PyramidParameters> pyramid;
  std::optional<HalfSpaceParameters> half_space;
  std::optional<Box> box;
  Asset<ClosedMesh> mesh;
  ImportPose mesh_place;
};

struct ShareParameters {
  double share = 0;
  double above = 0;
  double outer = 1;
};

struct PointsParameters {
  std::uint64_t count = 2400;
  std::vector<ShareParameters> shares;
  bool blue_noise = false;
  Asset<PointCloud> file;  ///< instead of the rows above
  ImportPose file_place;
};

const ParameterTable& crown_table();   ///< the rows of CrownParameters
const ParameterTable& points_table();  ///< the rows of PointsParameters

/// Reports a crown that is missing, shares whose part of it is empty, and more points than allowed where it is filled
/// `times` times. `path` is the component's, `component` what messages call it: "a colonize".
void check_cloud(const std::optional<CrownParameters>& crown, const PointsParameters& points, std::size_t times,
                 std::string_view component, const DocumentPath& path, ParameterReader& reader);

/// The crown that a checked form means; null where its list is empty.
CrownPointer build_crown(const CrownParameters& form);

/// Where trees stand, and what they grow into.
struct RootsInCrowns {
  const std::optional<CrownParameters>& crown;
  const PointsParameters& points;
  const std::vector<Vec3>& roots;  ///< in the component's frame
  bool one_crown;                  ///< over the component's origin, instead of one per root

  /// Whether all roots grow into the same points.
  bool share_points() const { return one_crown || points.file; }
};

/// The attraction points of one root, in the component's frame. The points of a crown of its own stand around the root,
/// over `base`; points that all roots share belong to the first root.
struct PointsOfRoot {
  Vec3 base{0};
  std::vector<Vec3> points;  ///< relative to it
};
/// Throws as make_points does.
std::vector<PointsOfRoot> points_of_roots(const RootsInCrowns& trees, RandomKey key, const GrowContext& context);

/// The attraction points of one tree, relative to its root: the points of the file that lie in the crown, where
/// `points` names a file, else as many points in the crown as `points` asks for. Throws InputError at the component's
/// crown or points.
std::vector<Vec3> make_points(const std::optional<CrownParameters>& crown, const PointsParameters& points,
                              RandomKey key, const GrowContext& context);

}  // namespace meristem
