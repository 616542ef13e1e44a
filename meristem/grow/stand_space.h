// SPDX-License-Identifier: Apache-2.0
// What the plants of a stand take from each other as they grow: light, by the shade that they cast, and room, by the
// markers that they stand on. All plants tell it where their shoots grow and where they lose them; what a plant feels
// of that is in a form of its own.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "meristem/grow/stand.h"
#include "meristem/scene/light/shadow_grid.h"
#include "meristem/scene/marker/marker_field.h"

namespace meristem {

/// A plant whose buds look for room.
class RoomSeeker {
 public:
  virtual ~RoomSeeker() = default;
  /// Told once when a round begins. Returns whether the plant looks for room in it; where none does, none is shared
  /// out.
  virtual bool begin_round() = 0;
  /// Adds its buds as they are now. It gets as many answers, in this order, by take_room().
  virtual void list_seekers(std::vector<Seeker>& seekers) const = 0;
  virtual void take_room(std::span<const Room> rooms) = 0;
};

/// Where a plant has grown leafy shoots and lost them, one after another.
class ShootChanges {
 public:
  /// A leafy shoot of `length` metres ends at a position (world space). One as long as a voxel casts one shade.
  void grow(Vec3 position, double length) { shoots_.push_back({position, length, false}); }
  /// One that was grown before is gone: light and room are as if it had never been.
  void lose(Vec3 position, double length) { shoots_.push_back({position, length, true}); }

 private:
  friend class StandSpace;
  struct Shoot {
    Vec3 position{0};
    double length = 0;
    bool is_lost = false;
  };
  std::vector<Shoot> shoots_;
};

/// What plants do in a round is felt from the next one on. Plants tell of it once their step is done; while they step
/// they only read.
class StandSpace : public Commons {
 public:
  /// The grid of a form, the same one for equal forms; it stays where it is. Growth throws InputError at `path`, a
  /// document path, where the grid would take more than `most_bytes`. To be called before the first round, as markers.
  const ShadowGrid& shade(const ShadowParameters& form, std::uint64_t most_bytes, std::string path);
  /// The field of a form, the same one for equal forms, in which `seeker`, which outlives the growth, looks for room.
  /// `key` is that of its markers where it is the first one; `obstacles` are the scene's.
  MarkerField& markers(const MarkerParameters& form, RandomKey key, const Obstacles& obstacles, RoomSeeker& seeker,
                       std::uint64_t most_bytes, std::string path);
  /// Whether anything is felt; if not, telling of shoots is lost work.
  bool is_felt() const { return !grids_.empty() || !fields_.empty(); }

  void grow_shoot(Vec3 position, double length) { changes_.grow(position, length); }
  void lose_shoot(Vec3 position, double length) { changes_.lose(position, length); }
  /// Takes note of all `changes`, and empties them.
  void take(ShootChanges& changes);

  void begin_round(Progress& progress) override;

 private:
  struct Grid {
    ShadowGrid grid;
    std::uint64_t most_bytes = 0;
    std::string path;
  };
  struct Field {
    MarkerField field;
    std::vector<RoomSeeker*> seekers;
    std::uint64_t most_bytes = 0;
    std::string path;
  };
  void cast_shade(Grid& grid, const Progress& progress) const;
  void take_markers(Field& field, const Progress& progress) const;
  static void share_out(Field& field, Progress& progress);

  std::deque<Grid> grids_;
  std::deque<Field> fields_;
  ShootChanges changes_;
};

}  // namespace meristem
