// SPDX-License-Identifier: Apache-2.0
// The light and the space that the plants of a stand compete for. Plants cast shade and occupy markers. All plants
// report where their shoots grow and where they are lost. Each plant has its own parameters for the shade and the
// markers that affect it.
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

/// A plant whose buds search for space.
class RoomSeeker {
 public:
  virtual ~RoomSeeker() = default;
  /// Called once at the begin of a round. Returns true if the plant searches for space in this round. If no plant does,
  /// nothing is shared out.
  virtual bool begin_round() = 0;
  /// Appends the plant's current buds. take_room() later receives one result per bud, in this order.
  virtual void list_seekers(std::vector<SpaceSeeker>& seekers) const = 0;
  /// Receives the results of this round, one per bud that list_seekers() has listed.
  virtual void take_room(std::span<const BudRoom> rooms) = 0;
};

/// The leafy shoots that a plant has grown and lost, in order.
class ShootChanges {
 public:
  /// Adds a leafy shoot of `length` metres that ends at `position` (world space). A shoot as long as a voxel casts one
  /// shade.
  void grow(Vec3 position, double length) { shoots_.push_back({position, length, false}); }
  /// Removes a shoot that was grown before. Light and space are then as if it had never grown.
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

/// Changes of a round take effect in the next round. Plants report changes after their steps. During steps they only
/// read.
class StandSpace : public StandCommons {
 public:
  /// Returns the shade grid for these parameters; equal parameters share one grid. References stay valid. Growth throws
  /// InputError at the document path `path` if the grid would need more than `max_bytes`. Call it before the first
  /// round, like markers().
  const ShadowGrid& shade(const ShadowParameters& form, std::uint64_t max_bytes, std::string path);
  /// Returns the marker field for these parameters; equal parameters share one field. Registers `seeker`, which
  /// searches for space in the field and must outlive the growth. `key` is the random key of the markers and is used
  /// only when the field is created. `obstacles` must be the scene's.
  MarkerField& markers(const MarkerParameters& form, RandomKey key, const Obstacles& obstacles, RoomSeeker& seeker,
                       std::uint64_t max_bytes, std::string path);
  /// Returns true if any plant uses shade or markers. Otherwise reports of shoots have no effect.
  bool is_felt() const { return !grids_.empty() || !fields_.empty(); }

  /// Reports a leafy shoot that has grown, as ShootChanges::grow().
  void grow_shoot(Vec3 position, double length) { changes_.grow(position, length); }
  /// Reports a leafy shoot that was lost, as ShootChanges::lose().
  void lose_shoot(Vec3 position, double length) { changes_.lose(position, length); }
  /// Adds all `changes`, and clears them.
  void take(ShootChanges& changes);

  void begin_round(Progress& progress) override;

 private:
  struct Grid {
    ShadowGrid grid;
    std::uint64_t max_bytes = 0;
    std::string path;
  };
  struct Field {
    MarkerField field;
    std::vector<RoomSeeker*> seekers;
    std::uint64_t max_bytes = 0;
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
