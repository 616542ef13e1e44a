// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees. Buds compete for light and space. The resource that they earn is divided among them from the
// root, and buds with enough resource grow metamers. The form results from this competition, so trees respond to
// neighbours, obstacles, light and cuts.
//
// Based on: W. Palubicki et al.: Self-organizing tree models for image synthesis (2009); J. Stevens: Automatische
// generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, chapter 4, with its adaptations for pruning.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/limits.h"
#include "meristem/base/random.h"
#include "meristem/grow/metamer/resource.h"
#include "meristem/grow/organize/sag.h"
#include "meristem/grow/prune/operation.h"
#include "meristem/grow/stand.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/scene/crown/crown.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// How the light of buds is computed.
struct BudLightModel {
  /// Where the light of a bud comes from.
  enum class Kind {
    shadow,   ///< the scene's light, reduced by the shade of all plants of the stand
    markers,  ///< the free space that a bud sees
  };
  Kind kind = Kind::shadow;  ///< shade, or space
  double full = 1;           ///< C: light of a bud without shade; in the marker model, light of a bud with free space

  // Shade.
  double voxel = 0;  ///< side of a voxel, metres; 0: the length of a metamer
  double a = 0.2;    ///< shade of a metamer in its own voxel; larger: sparser crowns
  double b = 2;      ///< divisor of the shade from voxel to voxel
  int depth = 3;     ///< number of voxels below a metamer that it shades
  int reach = 2;     ///< radius in voxels in which a bud searches for brighter directions
  double lean = 1;   ///< 0 to 1: from shade that falls vertically to shade along the scene's light

  // Markers. Distances are in lengths of a metamer.
  double spacing = 0.7;   ///< distance of markers
  double occupancy = 2;   ///< radius around a metamer in which it occupies markers
  double perception = 4;  ///< distance up to which a bud sees markers
  double cone = kPi / 2;  ///< full angle of a bud's view
  bool counts = false;    ///< true: the light is the number of the bud's markers; false: `full` for any number above 0
};

/// Weights of the directions that are summed to the direction of a new metamer. Each direction is a unit vector.
struct DirectionWeights {
  double persistence = 0.6;  ///< weight of the previous direction, or of the lateral bud's direction
  double light = 0.4;        ///< weight of the direction to light or space
  double up = 0;             ///< weight of straight up; negative: down
  double up_later = 0;       ///< limit of `up` after many iterations or orders
  double up_fade = 0.9;      ///< 0 to 1: factor on the difference from this limit after each iteration or order
  /// True: fades with the rank from leader to branch to twig (see leads.h); false: with iterations.
  bool fades_by_order = false;
};

/// The arrangement of lateral buds.
struct Phyllotaxis {
  /// How lateral buds follow each other along an axis.
  enum class Kind { spiral, alternate, decussate };
  Kind kind = Kind::spiral;                      ///< spiral, alternate or decussate
  double branching_angle = radians(55);          ///< between axis and lateral bud
  double divergence = radians(kGoldenAngleDeg);  ///< divergence angle of the spiral
  double jitter = radians(4);  ///< standard deviation of the direction of each new metamer and of its lateral bud
};

/// Shedding of branches without light or resource.
struct BranchShedding {
  double below = 0;     ///< a shoot is shed if its mean light per metamer is below this value; 0: no shedding by light
  double resource = 0;  ///< a shoot is shed if its resource per metamer is below this value; 0: no shedding by resource
  int after = 3;        ///< only shoots older than this number of iterations are shed
};

/// Fruits on dormant lateral buds. They take resource from the tree, and buds need resource to flower, so trees may
/// bear every other year.
struct FruitBearing {
  double cost = 0.5;       ///< resource that a fruit takes from the tree; larger: less growth and fewer flowers
  double threshold = 0.5;  ///< resource of a dormant lateral bud from which it flowers in the next iteration
  int age = 2;             ///< iterations from the growth of a bud until it may flower
};

/// Vigorous shoots from dormant buds below large cuts.
struct WaterShoots {
  double threshold = 1;  ///< resource at which dormant lateral buds near a cut open
  int cut = 5;           ///< smallest number of metamers that the cut has removed
  int within = 4;        ///< metamers from the cut toward the root whose buds may open
  int years = 2;         ///< iterations after the cut in which they may open
  double up = 1;         ///< weight of straight up in the directions of such shoots
};

/// Parameters of self-organizing trees, for one plant.
struct OrganizeParameters {
  int iterations = 20;  ///< number of iterations
  int every = 1;        ///< rounds of the stand per iteration
  double length = 0.1;  ///< length of a metamer, metres
  /// True: the length of a new shoot follows its resource, up to 10 n metamer lengths for n metamers; false: n lengths.
  bool stretch = false;
  int longest_shoot = 10;          ///< largest number of metamers that a bud grows in an iteration
  int maturity = 25;               ///< iteration at which curves over the age end
  BudLightModel light;             ///< how the light of buds is computed
  ResourceModel resource;          ///< how the resource is made and divided
  double terminal_threshold = 1;   ///< resource at which a terminal bud grows
  double lateral_threshold = 1.8;  ///< resource at which a lateral bud grows
  bool laterals_wait = true;       ///< true: a lateral bud opens with or after its terminal bud only
  bool damage = true;              ///< true: a cut bud is damaged permanently; false: it may grow again
  double takeover = 0.5;       ///< weight of a cut terminal's direction in the first metamer of the lateral beside it
  DirectionWeights direction;  ///< directions of new metamers
  std::optional<DirectionWeights> stem;     ///< weights of the leading stem, if different
  Phyllotaxis phyllotaxis;                  ///< directions of lateral buds
  BranchShedding shedding;                  ///< branches that are shed
  std::optional<BranchSag> sag;             ///< bending under load; unset: no bending
  PipeModel radii;                          ///< radii of the finished skeleton
  std::optional<FruitBearing> bearing;           ///< fruits; unset: none
  std::optional<WaterShoots> water_shoots;  ///< shoots below cuts; unset: buds there open like others
  std::optional<double> closure;            ///< shrinkage of a wound's radius per iteration, metres; unset: unknown
  double callus = 0;  ///< swelling around cuts, as a share of the cut sections; larger: thicker heads
  std::vector<TreeOperation> operations;  ///< applied in this order
  std::vector<std::string> marks;         ///< names of the marks, by number
  double summer = 0.5;                    ///< 0 to 1: share of an iteration's growth before its summer operations
  bool plans = false;                     ///< true: the operations of the last iteration are only planned and reported
  bool keeps_fallen = false;  ///< true: the skeleton also contains shed and cut shoots, with the time of their loss
  TraceRequest request;       ///< parts to record; everything except attraction points is supported
  /// Directions of light and gravity. Light fields that are not the scene's own are added to the light direction of a
  /// bud.
  std::optional<Directions> directions{};  ///< unset: the scene's
};

/// The begin of one tree. Its space is a crown above its root, or all of space if null. Markers exist only in it, and
/// shoots do not leave it. With markers, a stem may grow to it from outside.
struct OrganizeSeed {
  Frame frame;        ///< heading: the first growth direction of the stem
  CrownPointer room;  ///< relative to the root; null: all of space
  /// An existing tree that continues to grow: a tree with one root at the origin, in metres, in world axes, with all
  /// radii above 0. Null: only the seed.
  std::shared_ptr<const Skeleton> wood{};
};

/// Makes self-organizing trees in a stand. Together they are one member of the stand and one skeleton, with one node
/// per metamer, after the nodes of the seeds. `component` is the id in error messages.
///
/// Columns of the skeleton: `metamer` is the number on the axis, 0 for seeds. `light` and `resource` are the values for
/// the next iteration. `lateral_resource` is the resource for the lateral bud or branch, including resource passed
/// back. `terminal_bud` and `lateral_bud` are states: 0 open, 1 grown, 2 damaged, 3 dead. `bud_angle` is the angle in
/// radians about the axis from its upper side to the lateral bud (see bud_side). `shed` is the number of lost tips.
///
/// Trees with operations have more columns. `rank` is described in leads.h. `cut_at` is the last iteration of a cut at
/// the node's tip, 0 for never. `cut_metamers`, `cut_length` (metres), `cut_wood` (cubic metres) and `cut_light` are
/// the sums of everything cut off there. `marked` is 1 on shoots with any mark, and each mark has its own column, such
/// as `mark_dead`. Skeleton::operations lists the effects of all operations. Trees that only plan also have `plan_cut`:
/// the Operation::number that would cut the metamer off, or 0. With OrganizeParameters::closure, `wound` is the radius
/// of the open wound in metres. With OrganizeParameters::bearing, `fruit` is 1 if the lateral bud bears in the next
/// iteration.
///
/// If an operation acts in summer, an iteration takes two rounds of the stand or more. Each shoot grows the share
/// `summer` of its metamers before the operation and the rest after it. A cut shoot grows no further, but its buds may
/// open. If the summer does not change a tree, the tree grows as many metamers as without a summer.
///
/// Existing wood has birth 0. It keeps its radii, which grow with the tips that it gains. All of its buds are open,
/// unless its columns `terminal_bud` and `lateral_bud` contain their states and `bud_angle` their positions.
///
/// Growth throws InputError before making nodes that exceed the limits, and if an operation names a shoot that none of
/// its trees has. Throws it also if a seed is in an obstacle, and if nothing has grown at all. Throws
/// std::invalid_argument for parameters out of range. `scene` must outlive the growth.
std::unique_ptr<Grower> make_organizer(Stand& stand, std::vector<OrganizeSeed> seeds,
                                       const OrganizeParameters& parameters, RandomKey key, const Scene& scene,
                                       const SizeLimits& limits, std::string component);

/// Returns the unit vector toward a bud at `bud_angle` about an axis with this heading.
Vec3 bud_side(Vec3 heading, double bud_angle);

}  // namespace meristem
