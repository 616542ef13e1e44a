// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees: buds compete for light and room, what they earn is divided among them from the root on, and
// those that get enough grow metamers. Form follows from that competition and not from a plan, so trees answer to
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

/// What light buds have.
struct BudLightModel {
  enum class Kind {
    shadow,   ///< what the shade of all plants of the stand leaves of the scene's light
    markers,  ///< the free room that a bud sees
  };
  Kind kind = Kind::shadow;
  double full = 1;  ///< C: light of a bud without any shade; in the marker model, light of a bud with room

  // Shade.
  double voxel = 0;  ///< metres; 0: the length of a metamer
  double a = 0.2;    ///< shade that a metamer casts where it is; raised, sparser crowns
  double b = 2;      ///< divisor of the shade from voxel to voxel
  int depth = 3;     ///< voxels below a metamer that it shades
  int reach = 2;     ///< voxels around a bud in which it feels where it gets brighter
  double lean = 1;   ///< 0 to 1: from shade that falls straight down to shade that falls as the scene's light does

  // Markers, their distances in lengths of a metamer.
  double spacing = 0.7;
  double occupancy = 2;   ///< around a metamer, where it takes the markers
  double perception = 4;  ///< how far a bud sees
  double cone = kPi / 2;  ///< full angle of what it sees
  bool counts = false;    ///< light is the number of markers that a bud has got, and not `full` for any
};

/// How a metamer's direction is made of several: each a unit vector times its weight.
struct DirectionWeights {
  double persistence = 0.6;     ///< weight of the direction so far, or of the lateral bud's direction
  double light = 0.4;           ///< weight of the direction to light or room
  double up = 0;                ///< weight of straight up; negative: down
  double up_later = 0;          ///< what that weight comes to with the iterations or orders
  double up_fade = 0.9;         ///< 0 to 1: what is left of the difference after each
  bool fades_by_order = false;  ///< from leader to branch to twig, by rank (see leads.h)
};

/// Where lateral buds stand.
struct Phyllotaxis {
  enum class Kind { spiral, alternate, decussate };
  Kind kind = Kind::spiral;
  double branching_angle = radians(55);          ///< between axis and lateral bud
  double divergence = radians(kGoldenAngleDeg);  ///< divergence angle of the spiral
  double jitter = radians(4);  ///< standard deviation of each new metamer's direction and of its lateral bud
};

/// Branches without light are shed.
struct Shedding {
  double below = 0;  ///< mean light a metamer below which a shoot is shed; 0: none is
  int after = 3;     ///< only shoots older than this number of iterations are
};

struct OrganizeParameters {
  int iterations = 20;
  int every = 1;           ///< rounds of the stand for each of them
  double length = 0.1;     ///< metres, of a metamer
  bool stretch = false;    ///< a shoot of n metamers is as long as its resource says, up to 10 n lengths, and not n
  int longest_shoot = 10;  ///< metamers that a bud grows in an iteration at most
  int maturity = 25;       ///< iterations at which curves over the age end
  BudLightModel light;
  ResourceModel resource;
  double terminal_threshold = 1;   ///< resource at which a terminal bud grows
  double lateral_threshold = 1.8;  ///< resource at which a lateral bud grows
  bool laterals_wait = true;       ///< a lateral bud opens with or after its terminal only
  bool damage = true;              ///< a cut bud is damaged for ever; else it may grow again
  double takeover = 0.5;           ///< weight of a cut terminal's direction in the first metamer of a lateral beside it
  DirectionWeights direction;
  std::optional<DirectionWeights> stem;  ///< weights of the stem and of what leads after it, where they differ
  Phyllotaxis phyllotaxis;
  Shedding shedding;
  std::optional<Sag> sag;
  PipeModel radii;
  double callus = 0;  ///< share of the sections of cuts that wood swells by about them; raised, thicker heads
  std::vector<Operation> operations;  ///< that act in this order
  std::vector<std::string> marks;     ///< words of the marks, by their numbers
  double summer = 0.5;        ///< 0 to 1: share of an iteration's growth that comes before its summer operations
  bool plans = false;         ///< what the last iteration's operations would do is told, and not done
  bool keeps_fallen = false;  ///< the skeleton has what was shed and cut as well, and when it went
  TraceWish wish;             ///< all but attraction points is recorded where it is asked for
  /// Directions of light and gravity: light that the scene does not have itself adds to the light that a bud finds, by
  /// its weight.
  std::optional<Directions> directions{};  ///< unset: the scene's
};

/// Where one tree begins. Its room is a crown over its root, or all space where there is none: markers exist in it
/// alone, and shoots of the shadow model end at its surface.
struct OrganizeSeed {
  Frame frame;  ///< heads where the stem begins to grow
  CrownPointer room;
  /// What stands there already and goes on growing, with its radii, which are above 0: a tree with one root at the
  /// origin, in metres along the axes of the world. Null: the seed alone.
  std::shared_ptr<const Skeleton> wood{};
};

/// Self-organizing trees in a stand, together one member of it and one skeleton: a node per metamer after the seeds'.
/// `component` is the id that errors name.
///
/// Columns of the skeleton: `metamer` (number on the axis, 0 for seeds), `light` and `resource` as they would be in the
/// next iteration, `lateral_resource` (what of it and of what is passed back the lateral bud or branch would get),
/// `terminal_bud` and `lateral_bud` (states: 0 open, 1 grown, 2 damaged, 3 dead), `bud_angle` (radians about the axis
/// from its upper side to the lateral bud, see bud_side), `shed` (tips lost); for trees with operations also `rank`
/// (see leads.h), `cut_at` (the last iteration in which something was cut off at its tip, 0 for never), what has been
/// cut off there in all, `cut_metamers`, `cut_length` (metres), `cut_wood` (cubic metres) and `cut_light`, `marked`, 1
/// on shoots with any mark, and the same for each word, as `mark_dead`. Skeleton::operations tells what each operation
/// has done. Trees that only plan have `plan_cut` as well: Operation::number of what would cut the metamer off, or 0.
///
/// Where an operation acts in summer, an iteration takes two rounds of the stand or more. Each shoot grows the share
/// `summer` of its metamers before it and the rest after it; what has been cut grows no further, but buds of the shoots
/// that were cut may open. Where the summer leaves a tree as it is, it grows as many metamers as without it.
///
/// Wood that stood already has birth 0 and keeps its radii, which grow by the tips that it gains. All of its buds are
/// open, unless its columns `terminal_bud` and `lateral_bud` tell their states and `bud_angle` where they stand.
///
/// Growth throws InputError where nodes exceed the limits, before it makes them; where an operation names a shoot that
/// none of its trees has; where a seed stands in an obstacle; and where nothing has grown at all. std::invalid_argument
/// for parameters out of their ranges. `scene` must outlive the growth.
std::unique_ptr<Grower> make_organizer(Stand& stand, std::vector<OrganizeSeed> seeds,
                                       const OrganizeParameters& parameters, RandomKey key, const Scene& scene,
                                       const Limits& limits, std::string component);

/// The unit vector toward a bud at `bud_angle` about an axis with that heading.
Vec3 bud_side(Vec3 heading, double bud_angle);

}  // namespace meristem
