// SPDX-License-Identifier: Apache-2.0
// The space that self-organizing plants compete for. Space is full of markers, one at a random position in each voxel.
// Shoots occupy the markers near them and release them when they are pruned. Buds search for free markers in a cone
// ahead. A marker that several buds see belongs to the nearest one. Shoots are counted at each marker. Their order
// therefore does not matter, and vacating is the exact inverse of occupying. Time and memory depend on shoots and buds,
// not on the size of the volumes.
//
// Based on: W. Palubicki et al.: Self-organizing tree models for image synthesis (2009), section 4.1, space
// colonization. In the source, shoots occupy markers permanently.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/base/vec.h"
#include "meristem/scene/crown/crown.h"
#include "meristem/scene/marker/marker_bricks.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

/// The density of markers, and the reach of shoots.
struct MarkerParameters {
  double spacing = 0.07;   ///< side of a voxel, metres; larger: coarser and cheaper
  double occupancy = 0.2;  ///< radius around a shoot in which markers are occupied, metres, up to 32 spacings

  bool operator==(const MarkerParameters&) const = default;
};

/// A bud that searches for space.
struct SpaceSeeker {
  Vec3 position{0};            ///< metres
  Vec3 direction{kUp};         ///< unit vector along the cone's axis
  std::uint32_t volume = 0;    ///< index from add_volume(); the seeker sees only markers of this volume
  float radius = 0.4F;         ///< length of the cone, metres, up to 32 spacings
  float cosine = 0.70710678F;  ///< cosine of half the cone's full angle; -1: sees all directions
  bool yields = false;         ///< true: the seeker gets only markers that no other seeker sees
};

/// The result of a seeker.
struct BudRoom {
  std::uint32_t count = 0;  ///< number of markers
  Vec3 way{0};              ///< sum of the unit vectors to these markers
};

struct LookedAt;  // the looks at each brick in a round

/// The markers of a scene, with the shoots that occupy them.
class MarkerField {
 public:
  /// Markers inside obstacles are never free. Throws std::invalid_argument for parameters out of range.
  MarkerField(const MarkerParameters& form, RandomKey key, Obstacles obstacles = {});

  /// Adds the space of a plant, a crown placed at `root`. A null crown means all of space. Volumes may overlap; a
  /// marker in several volumes is available to the buds of all of them.
  std::uint32_t add_volume(CrownPointer crown, Vec3 root);

  /// Returns true if a position is finite and at most 4 million spacings away from the origin along each axis.
  bool reaches(Vec3 position) const { return bricks_.reaches(position); }
  /// Occupies the markers around a shoot at `position`. vacate() of an equal position releases them exactly. Throws
  /// std::invalid_argument for positions out of range, and for vacating a position that was not occupied.
  void occupy(Vec3 position) { bricks_.occupy(position); }
  /// Releases the markers that occupy() has occupied for an equal position.
  void vacate(Vec3 position) { bricks_.vacate(position); }

  /// Assigns each free marker to the nearest seeker that sees it (tie: the first seeker). Seekers that yield come after
  /// all others. Writes the result of each seeker to `rooms`, which has one entry per seeker. The result does not
  /// depend on the number of threads. Throws std::invalid_argument for seekers out of range. Throws TooMuchMemory if
  /// the round would need more than `max_bytes` in addition to the field itself. Throws Cancelled. After TooMuchMemory
  /// or Cancelled, `rooms` is unchanged.
  void share_out(std::span<const SpaceSeeker> seekers, std::span<BudRoom> rooms, const Progress& progress,
                 std::uint64_t max_bytes = ~std::uint64_t{0});
  /// Thrown before a call would exceed its limit of memory.
  struct TooMuchMemory {};

  /// Returns the free markers of a volume in a box, in unspecified order, for pictures and tests. Cost: proportional to
  /// the box.
  std::vector<DVec3> free_markers(const Box& box, std::uint32_t volume) const;

  /// Returns a field with equal markers and volumes, but without shoots.
  MarkerField vacant() const;

  const MarkerParameters& form() const { return form_; }  ///< the parameters of the field
  /// Returns the memory kept between rounds: about 120 bytes per brick of 64 markers that a shoot or a cone has
  /// touched. During a round, each seeker takes about 50 bytes. A seeker that finds a free marker takes another 100
  /// bytes, plus 12 for each brick in the box around its cone.
  std::size_t bytes() const;

 private:
  struct Volume {
    CrownPointer crown;
    Vec3 root;
  };
  /// The markers of a brick that are in a volume and in no obstacle. Computed when a bud first looks, and then kept.
  struct Claim {
    std::uint64_t markers;
    std::uint32_t volume;
    std::uint32_t next;  // next claim of the brick
  };
  struct Tally;

  std::uint64_t find_claim(const MarkerBricks::Cell& brick, std::uint8_t pattern, const Volume& volume) const;
  const Claim* known_claim(const MarkerBricks::Brick& brick, std::uint32_t volume) const;
  std::uint64_t seen_by(const MarkerBricks::Brick& brick, std::uint32_t volume) const;
  void learn_claims(const LookedAt& looked, const Progress& progress);
  void limit(MarkerBricks::Brick& brick);
  void share_out_brick(const MarkerBricks::Brick& brick, const LookedAt& looked, std::span<const std::uint32_t> lookers,
                       std::vector<Tally>& got) const;
  DVec3 position(const MarkerBricks::Cell& brick, std::uint8_t pattern, std::uint32_t marker) const;

  MarkerParameters form_;
  RandomKey key_;
  Obstacles obstacles_;
  MarkerBricks bricks_;
  std::vector<Volume> volumes_;
  std::deque<Claim> claims_;
};

}  // namespace meristem
