// SPDX-License-Identifier: Apache-2.0
// Scenes as messages to a viewer; each message holds only what has changed since the one before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/mesh_scene.h"
#include "meristem/shape/scene_keys.h"

namespace meristem {

/// What there is of a plant; a packet may show less of it.
struct PacketCounts {
  std::uint64_t triangles = 0;  ///< triangles of all instances
  std::uint64_t instances = 0;  ///< instances of meshes
  std::uint64_t nodes = 0;      ///< nodes of skeletons
};

/// What a packet says besides the scene.
struct PacketFacts {
  std::string hash;       ///< hash of the text that the packet shows
  bool is_draft = false;  ///< less than there will be once nothing moves; the viewer keeps what it had before drafts
  bool fits = false;      ///< the camera is to be fitted to it
  double share = 1;       ///< share of all triangles that was asked of the meshes
  PacketCounts all{};     ///< what there is in all
};

/// What a viewer is to show.
struct PacketScene {
  const MeshScene* meshes = nullptr;  ///< null: none; textures must be painted
  const Plant* skeletons = nullptr;   ///< whose stems are drawn as lines; null: none
  std::size_t most_segments = 0;      ///< segments that are drawn of all skeletons, the thickest ones; 0: all
  /// Bodies around the plants, as obstacle_meshes() makes them; null: none. They do not count as what is shown, and the
  /// bounds are theirs only where there are no plants.
  const MeshScene* obstacles = nullptr;
  const Scene* scene = nullptr;  ///< whose sun, lamps and supports are told; null: nothing is said of them
};

/// Makes the packets for one viewer. They are little-endian:
///
///   bytes 0 to 3  MSP1
///         4 to 7  u32, the bytes of the head, a multiple of 4
///         8 on    the head, JSON in UTF-8, filled up with blanks; behind it the arrays
///
/// The head names meshes, sets of instances, pictures and skeletons by keys of their content, what uses them by
/// component and number, and says what is gone; an array is [bytes from the first array, count of numbers] and begins
/// at a multiple of 4 bytes, so that a viewer uses it in place. apps/studio/protocol.md describes all members. The same
/// scenes in turn give the same bytes.
class PacketMaker {
 public:
  /// The packet that takes the viewer from the scene of the one before to this one; a whole scene at first. Where it
  /// throws (Cancelled, MachineError), the viewer's scene stays that of the packet before.
  std::string next(const PacketScene& scene, const PacketFacts& facts, const Progress& progress);
  /// Makes the next packet a whole scene.
  void forget() {
    shown_ = {};
    rest_ = {};
  }
  /// Number of the last packet, from 1; 0 before there was one.
  std::uint64_t number() const { return number_; }

 private:
  struct Batch {
    std::uint64_t mesh = 0;
    std::uint64_t instances = 0;
    std::uint32_t material = 0;

    bool operator==(const Batch&) const = default;
  };
  using BatchName = std::pair<std::string, std::uint32_t>;
  using Keys = std::set<std::uint64_t>;
  /// Content that the viewer has.
  struct Held {
    Keys meshes;
    Keys instances;
    Keys pictures;
    Keys skeletons;
  };
  struct Shown {
    bool is_empty = true;  // there was no packet
    std::map<BatchName, Batch> batches;
    std::vector<std::uint64_t> materials;
    std::vector<std::uint64_t> lines;
    std::uint64_t scene = 0;  // hash of what is told of it; 0: nothing
    Held held;
  };
  class Builder;

  SceneKeyMaker key_maker_;
  Shown shown_;
  Held rest_;  // what the viewer holds since the last packet that was no draft
  std::uint64_t number_ = 0;
};

}  // namespace meristem
