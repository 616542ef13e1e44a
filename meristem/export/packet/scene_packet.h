// SPDX-License-Identifier: Apache-2.0
// Scenes as messages to a viewer. Each message contains only the changes since the message before.
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
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/scene/scene_keys.h"

namespace meristem {

/// Counts of the whole plant. A packet may show less of the plant.
struct PacketCounts {
  std::uint64_t triangles = 0;  ///< triangles of all instances
  std::uint64_t instances = 0;  ///< instances of meshes
  std::uint64_t nodes = 0;      ///< nodes of skeletons
};

/// The facts in a packet besides the scene.
struct PacketFacts {
  std::string hash;       ///< hash of the text that the packet shows
  bool is_draft = false;  ///< true if the packet shows less than it will once nothing moves; the viewer keeps earlier
                          ///< content during drafts
  bool fits = false;      ///< if true, the viewer fits its camera to the scene
  double share = 1;       ///< share of all triangles that was requested for the meshes
  PacketCounts all{};     ///< counts of the whole plant
};

/// The scene for a viewer.
struct PacketScene {
  const MeshScene* meshes = nullptr;  ///< textures must be painted; may be null
  const Plant* skeletons = nullptr;   ///< plant whose stems are drawn as lines; may be null
  std::size_t max_segments = 0;       ///< maximum number of drawn segments of all skeletons, the thickest first; 0: all
  /// Bodies around the plants, as obstacle_meshes() returns them; may be null. They do not count toward the shown
  /// triangles, and the bounds include them only if there are no plants.
  const MeshScene* obstacles = nullptr;
  const Scene* scene = nullptr;  ///< scene whose sun, lamps and supports are sent; null: nothing is sent
};

/// Makes the packets for one viewer. They are little-endian:
///
///   bytes 0 to 3  MSP1
///         4 to 7  u32, the bytes of the head, a multiple of 4
///         8 on    the head, JSON in UTF-8, padded with blanks; after it the arrays
///
/// The head identifies meshes, sets of instances, pictures and skeletons by keys of their content. It lists their users
/// by component and number, and names content that was removed. An array is [bytes from the first array, number of
/// values] and begins at a multiple of 4 bytes, so that a viewer uses it in place. apps/studio/protocol.md describes
/// all members. Equal scenes in equal order give equal bytes.
class PacketMaker {
 public:
  /// Returns the packet that changes the viewer's scene from the previous scene to this one. The first packet has a
  /// whole scene. If this throws (Cancelled, MachineError), the viewer's scene stays the previous one.
  std::string next(const PacketScene& scene, const PacketFacts& facts, const Progress& progress);
  /// Makes the next packet a whole scene.
  void forget() {
    shown_ = {};
    rest_ = {};
  }
  /// Returns the number of the last packet, from 1, or 0 if there was none.
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
    bool is_empty = true;  // true until the first packet
    std::map<BatchName, Batch> batches;
    std::vector<std::uint64_t> materials;
    std::vector<std::uint64_t> lines;
    std::uint64_t scene = 0;  // hash of the sent scene; 0 if none was sent
    Held held;
  };
  class Builder;

  SceneKeyMaker key_maker_;
  Shown shown_;
  Held rest_;  // content that the viewer keeps since the last packet that was not a draft
  std::uint64_t number_ = 0;
};

}  // namespace meristem
