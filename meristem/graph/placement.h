// SPDX-License-Identifier: Apache-2.0
// Places the children of a branch link along the axes of a skeleton.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/count.h"
#include "meristem/graph/table/facing.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/selection.h"
#include "meristem/graph/table/site.h"
#include "meristem/graph/table/varying.h"
#include "meristem/plant/skeleton.h"
#include "meristem/scene/directions.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The placement keys of a branch link. Angles in radians.
struct BranchPlacement {
  bool operator==(const BranchPlacement&) const = default;

  std::optional<double> density;                    ///< sites per metre of stem; 40 if neither density nor count is
                                                    ///< given
  std::optional<PartCount> count;                   ///< sites on a skeleton, shared out over its axes by length
  std::optional<SiteCondition> where;               ///< default: tip_distance < 0.4 on stems that have grown, else all
  int whorl = 1;                                    ///< children per site
  double divergence = kGoldenAngleDeg * kPi / 180;  ///< turn about the axis from site to site
  std::optional<double> roll;           ///< turn of the first site from the stem's upper side; unset: random
  PerChild angle = kPi / 4;             ///< between axis and organ
  std::optional<double> angle_tip;      ///< angle between axis and organ at the axis's tip, reached in even steps from
                                        ///< `angle`; unset: equal to `angle`
  double angle_spread = 0;              ///< largest random deviation of the angle, to both sides
  Curve size{{{0, 1}}};                 ///< scale over u; below 0 counts as 0
  Curve spread{{{0, 1}}};               ///< relative density over u; below 0 counts as 0
  double droop = 0;                     ///< share of the turn that brings the heading straight down
  std::optional<FacingDirection> face;  ///< direction to which the upper face turns, whatever the light; unset: no turn
  double face_share = 1;                ///< share of the turn to `face`
  double face_light = 0;                ///< share of the turn that brings the upper face to the light
  double start = 0;                     ///< share of each axis left free at its base
  double end = 1;                       ///< share of each axis where the sites end
};

/// Returns the rows of BranchPlacement.
const ParameterTable& placement_table();
/// Reports a density beside a count, and a start beyond the end. `path` is the path of the placement. For components
/// that have the rows of Placement as their own.
void check_placement(const BranchPlacement& placement, const DocumentPath& path, ParameterReader& reader);

/// Returns `own` with the members that `link` was given. A link with a density or a count replaces both of `own`, and a
/// link with an angle also replaces the angle at the tip.
BranchPlacement overridden(BranchPlacement own, const BranchPlacement& link, const GivenRows& given);

/// The position and direction in which a branch link places a component on a stem.
enum class BranchStance {
  on_bark,  ///< on the bark, heading away from the stem by the link's angle
  on_axis,  ///< on the stem's axis, heading away by the link's angle: for stems, which begin within their parent stem
  along_axis,  ///< on the axis and heading along it, unless the link gives an angle; the component's own form leads
               ///< away from the stem
};

/// The surroundings of a placement.
struct PlacementContext {
  Directions directions;  ///< directions of light and gravity
  BranchStance stance =
      BranchStance::on_bark;        ///< stance of the children; `along_axis` leaves the placement's angles aside
  bool has_twigs = true;            ///< by default children stand only on twigs
  std::uint64_t stem = kOnNoStem;   ///< id of the stem, for the sites
  Site parent;                      ///< site of the instance that made the stem; gives the sites their keys and depths
  std::optional<RandomKey> places;  ///< key for the sites' positions, unset: the parent's; equal keys give equal sites

  /// Returns the key from which the sites draw their positions.
  RandomKey key_of_places() const { return places.value_or(parent.key); }
  const SizeLimits* limits = nullptr;    ///< limits of the document; must not be null
  const Obstacles* obstacles = nullptr;  ///< children turn away from their surfaces; null: no obstacles
  const Scene* scene = nullptr;          ///< light for conditions on skeletons without light; null: it is 0 there
  double time = 0;                       ///< the document's time for expressions, seconds
  bool everywhere = false;               ///< true: all parts of the skeleton carry children, whatever the placement
                                         ///< selects
  std::string path;                      ///< path of the placement in the document, for errors: "links[1]"
};

/// Returns unit axes turned so that the heading comes nearer to the direction of gravity, or to its opposite if `droop`
/// is negative. At a gravity of strength 1, `droop` is the share of the turn.
Mat3 drooped(const Mat3& axes, double droop, const FieldPull& gravity);

/// Returns for every node 1 if the segment that ends in the node may carry children, else 0. Decides by `where`, twigs
/// and `everywhere` only, not by start, end and spread.
std::vector<std::uint8_t> bearing_nodes(const Skeleton& skeleton, const BranchPlacement& placement,
                                        const PlacementContext& context);

/// Returns the sites of `placement` on `skeleton`, axis by axis from base to tip; i, n and u count along each axis. A
/// count with a fraction gives each axis a number of places between the numbers of the whole counts below and above.
/// The last place is smaller, and the others make room for it, so that nothing jumps while a count rises or falls. An
/// organ's frame stands on the bark, heads away from the axis by the angle, and turns its upper face (z) toward the
/// axis's tip. A lateral axis begins at its parent's bark. A skeleton of one node has no axis and gets no sites. Throws
/// InputError past the limit of instances, and if children must face a surface but the scene has no obstacle.
std::vector<Site> place_along(const Skeleton& skeleton, const BranchPlacement& placement,
                              const PlacementContext& context);

/// Returns a site at the tip of every axis of `skeleton`, in the order of the axes. Every axis must have a node. The
/// site heads along the axis's last segment; on a single node it heads as the parent does. i and n count over all tips.
/// All sites have the parent's key, so the caller must set keys of their own. `stem` is the skeleton's id.
std::vector<Site> tip_sites(const Skeleton& skeleton, std::uint64_t stem, const Site& parent);

}  // namespace meristem
