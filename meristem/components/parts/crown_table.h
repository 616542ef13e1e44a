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

struct ProfileForm {
  std::vector<Vec2> profile;  ///< (radius, height), metres over the root
};

struct EllipsoidForm {
  Vec3 centre{0};
  Vec3 radii{1};
};

struct SphereForm {
  Vec3 centre{0};
  double radius = 1;
};

struct ConeForm {
  Vec3 base{0};
  double radius = 1;
  double height = 2;
};

/// Exactly one member is given.
struct CrownForm {
  std::vector<Vec2> profile;
  std::vector<std::pair<std::string, ProfileForm>> profiles;  ///< by azimuth, degrees
  std::vector<CrownForm> united;
  std::vector<CrownForm> intersected;
  std::vector<CrownForm> subtracted;  ///< all others from the first
  std::optional<EllipsoidForm> ellipsoid;
  std::optional<SphereForm> sphere;
  std::optional<ConeForm> cone;
  std::optional<Box> box;
  Asset<ClosedMesh> mesh;
  ImportPlace mesh_place;
};

struct ShareForm {
  double share = 0;
  double above = 0;
  double outer = 1;
};

struct PointsForm {
  std::uint64_t count = 2400;
  std::vector<ShareForm> shares;
  bool blue_noise = false;
  Asset<PointCloud> file;  ///< instead of the rows above
  ImportPlace file_place;
};

const ParameterTable& crown_table();   ///< of CrownForm
const ParameterTable& points_table();  ///< of PointsForm

/// Reports a crown that is missing, shares whose part of it is empty, and more points than allowed where it is filled
/// `times` times. `place` is the component's, `component` what messages call it: "a colonize".
void check_cloud(const std::optional<CrownForm>& crown, const PointsForm& points, std::size_t times,
                 std::string_view component, const Place& place, ParameterReader& reader);

/// The crown that a checked form means; null where its list is empty.
CrownPointer build_crown(const CrownForm& form);

/// The attraction points of one tree, relative to its root: those of the file that lie in the crown, if there is one,
/// else so many in the crown. Throws InputError at the component's crown or points.
std::vector<Vec3> make_points(const std::optional<CrownForm>& crown, const PointsForm& points, RandomKey key,
                              const GrowContext& context);

}  // namespace meristem
