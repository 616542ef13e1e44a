// SPDX-License-Identifier: Apache-2.0
// A mesh scene that moves, for programs that play it: a plant at several times, the keys, with each part identified at
// all of them. Between two keys, everything moves at constant speed.
//
// Parts are identified by the names that the graph gives to organs and axes. A rigid part moves by its frames. A part
// whose shape changes, but not its triangles, has a shape per key. A part whose triangles change is shown with the mesh
// of each key from that key until the next. A tube keeps the rings of the key at which it has the most rings. Rings
// that have not grown yet lie together at its tip, and a tube that does not exist yet lies at its base, so that it
// grows out of nothing.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/matrix.hpp>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The motion of the instances of one mesh of a moving scene.
struct MeshMotion {
  /// What changes from key to key.
  enum class Kind {
    still,  ///< nothing
    rigid,  ///< frames of instances, each in a node of its own
    shape,  ///< vertices of all instances
    shown,  ///< nothing, but the instances exist only from the key `shown_at` until the next
  };
  Kind kind = Kind::still;  ///< what changes
  /// For each key, the mesh with the triangles of the scene's mesh. Empty: always the scene's mesh.
  std::vector<std::shared_ptr<const Mesh>> meshes;
  /// For each key, one frame per instance, with size 0 if the instance does not exist. Empty: always the frames of the
  /// scene.
  std::vector<std::vector<Frame>> frames;
  /// For each key, factors on the scene's colours, one per instance. Empty: always the tints of the scene.
  std::vector<std::vector<Vec3>> tints;
  bool turns = false;        ///< true if normals change as well as positions
  std::size_t shown_at = 0;  ///< index of a key
};

/// Returns true if a frame of a motion has a size, which means that its instance exists.
inline bool is_there(const Frame& frame) { return std::abs(glm::determinant(frame.axes)) > 0; }

/// A moving scene. The scene is the state at the last key. Parts that have vanished by then have size 0.
struct MovingScene {
  MeshScene scene;                  ///< state at the last key
  std::vector<double> times;        ///< of the keys, seconds, ascending; at least two
  std::vector<MeshMotion> motions;  ///< one per mesh of the scene
};

/// Limits of a moving scene.
struct MovingLimits {
  std::uint64_t bytes = 500'000'000;     ///< changing positions, normals and colours at all keys, bytes
  std::uint64_t part_keys = 20'000'000;  ///< organs and bodies, times the keys at which each is recorded
  std::size_t rigid_instances = 1000;    ///< instances that move as nodes; if there are more, they move by their
                                         ///< vertices
};

/// Builds a moving scene from a plant at several times.
class MovingSceneMaker {
 public:
  /// `limits` are the limits of meshes. `keys` is the number of keys, at least two.
  MovingSceneMaker(const SizeLimits& limits, const MovingLimits& moving, std::size_t keys);
  ~MovingSceneMaker();

  /// Adds the plant at one of the keys. Each key must be added once, in any order. The plant must have pictures in its
  /// materials and no plantings (`expanded`). Throws like make_mesh_scene, and InputError at the key "animation" if the
  /// moving data exceed a limit. If the first and the last key are added first, most such errors are found after two
  /// plants.
  void add(std::size_t key, double time, const Plant& plant, Progress& progress);

  /// Returns the scene after the plants of all keys were added. Throws InputError like add().
  MovingScene take(Progress& progress);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace meristem
