// SPDX-License-Identifier: Apache-2.0
// The room that self-organizing plants compete for. Space is full of markers, one in each voxel, somewhere within it;
// shoots take the markers near them, and give them back when they are pruned; buds look for free ones in a cone ahead.
// A marker that several buds see goes to the nearest. Shoots are counted, so their order does not matter and vacating
// is the exact inverse of occupying. Time and memory go with shoots and buds, however large the volumes are.
//
// Based on: W. Palubicki et al.: Self-organizing tree models for image synthesis (2009), section 4.1, space
// colonization. There shoots take markers for good.
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

struct MarkerParameters {
  double spacing = 0.07;   ///< metres per voxel's side; raised, room is coarser and costs less
  double occupancy = 0.2;  ///< metres around a shoot within which markers are taken, up to 32 spacings

  bool operator==(const MarkerParameters&) const = default;
};

/// A bud that looks for room.
struct Seeker {
  Vec3 position{0};
  Vec3 direction{kUp};         ///< unit vector along the cone's axis
  std::uint32_t volume = 0;    ///< by add_volume; it sees the markers of this volume alone
  float radius = 0.4F;         ///< metres, up to 32 spacings
  float cosine = 0.70710678F;  ///< cosine of half the cone's full angle; -1 sees all around
  bool yields = false;         ///< true: the seeker gets only what no other seeker sees
};

/// What it found.
struct Room {
  std::uint32_t count = 0;  ///< number of markers
  Vec3 way{0};              ///< sum of the unit vectors to them
};

struct LookedAt;  // the lookers at each brick, in a round

class MarkerField {
 public:
  /// Obstacles take the markers inside them. Throws std::invalid_argument for a form out of range.
  MarkerField(const MarkerParameters& form, RandomKey key, Obstacles obstacles = {});

  /// A plant's own space: a crown, placed at its root; without one, all of space. Volumes may overlap: a marker in
  /// several may go to the buds of any.
  std::uint32_t add_volume(CrownPointer crown, Vec3 root);

  /// Whether a position is finite and at most 4 million spacings away from the origin, along each axis.
  bool reaches(Vec3 position) const { return bricks_.reaches(position); }
  /// A shoot at `position` takes the markers around it; vacate() of the same position gives them back exactly. Throws
  /// std::invalid_argument for positions out of reach, and for vacating where nothing was occupied.
  void occupy(Vec3 position) { bricks_.occupy(position); }
  void vacate(Vec3 position) { bricks_.vacate(position); }

  /// Gives each free marker to the nearest seeker that sees it, and among equally near seekers to the first; seekers
  /// that yield come after all others. Writes to `rooms`, one per seeker, what each got, equal on any number of
  /// threads. Throws std::invalid_argument for seekers out of range, TooMuchMemory where that would take more than
  /// `most_bytes` beside the field's own, and Cancelled; then `rooms` is untouched.
  void share_out(std::span<const Seeker> seekers, std::span<Room> rooms, const Progress& progress,
                 std::uint64_t most_bytes = ~std::uint64_t{0});
  struct TooMuchMemory {};

  /// The free markers of a volume in a box, in no special order; for pictures and tests. Time goes with the box.
  std::vector<DVec3> free_markers(const Box& box, std::uint32_t volume) const;

  /// The same markers and volumes without any shoots.
  MarkerField vacant() const;

  const MarkerParameters& form() const { return form_; }
  /// Kept between rounds: some 120 per brick of 64 markers that a shoot or a cone has touched. A round takes, for its
  /// time, about 50 a seeker, and for each that finds a free marker about 100 and 12 for each brick in the box around
  /// its cone.
  std::size_t bytes() const;

 private:
  struct Volume {
    CrownPointer crown;
    Vec3 root;
  };
  /// Which markers of a brick are in a volume and in no obstacle. Kept from the first time that a bud looks.
  struct Claim {
    std::uint64_t markers;
    std::uint32_t volume;
    std::uint32_t next;  // next marker of the brick
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
