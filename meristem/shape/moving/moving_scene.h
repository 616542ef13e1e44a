// SPDX-License-Identifier: Apache-2.0
// A mesh scene that moves, for programs that play it: what a plant is at some times, its keys, and for each part which
// is the same one at all of them. Between two keys everything moves evenly.
//
// Parts are told apart by the names that the graph gives to organs and axes. A part that is rigid moves by its frames;
// one whose shape changes, but not its triangles, has a shape per key; of one whose triangles change, each key's is
// shown from that key up to the next. A tube keeps the rings of the key at which it has most of them: what has not
// grown yet lies together at its tip, and what is not there at its base, so that it grows out of nothing.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/matrix.hpp>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// How the instances of one mesh of a moving scene move.
struct MeshMotion {
  /// What changes from key to key.
  enum class Kind {
    still,  ///< not at all
    rigid,  ///< each instance by its frames, in a node of its own
    shape,  ///< by the vertices of all instances
    shown,  ///< not at all, and they are there from the key `shown_at` up to the next
  };
  Kind kind = Kind::still;  ///< what changes
  /// By key: the mesh, with the triangles of the scene's; empty: always that.
  std::vector<std::shared_ptr<const Mesh>> meshes;
  /// By key: one frame per instance, without size where it is not there; empty: always those of the scene.
  std::vector<std::vector<Frame>> frames;
  /// By key: the factors on the scene's colours, one per instance; empty: always those of the scene.
  std::vector<std::vector<Vec3>> tints;
  bool turns = false;        ///< normals change, not positions alone
  std::size_t shown_at = 0;  ///< key
};

/// Whether a frame of a motion has a size, so that its instance is there.
inline bool is_there(const Frame& frame) { return std::abs(glm::determinant(frame.axes)) > 0; }

/// The scene is what stands at the last key, and what has gone by then without size.
struct MovingScene {
  MeshScene scene;                  ///< state at the last key
  std::vector<double> times;        ///< of the keys, seconds, rising; two at least
  std::vector<MeshMotion> motions;  ///< one per mesh of the scene
};

/// What a moving scene may take.
struct MovingLimits {
  std::uint64_t bytes = 500'000'000;     ///< of positions, normals and colours that change, with all keys
  std::uint64_t part_keys = 20'000'000;  ///< organs and bodies, times the keys at which each is noted
  std::size_t rigid_instances = 1000;    ///< that move as nodes; more of them move by their vertices
};

/// Puts a moving scene together from a plant at one time after another.
class MovingSceneMaker {
 public:
  /// `limits` are those of meshes. There will be `keys` of them, two at least.
  MovingSceneMaker(const Limits& limits, const MovingLimits& moving, std::size_t keys);
  ~MovingSceneMaker();

  /// The plant at one of the keys, each once and in any order, with pictures in its materials and without plantings
  /// (`expanded`). Throws as make_mesh_scene does, and InputError at the key "animation" where what moves takes more
  /// than it may: most is told after two plants where the first and the last come first.
  void add(std::size_t key, double time, const Plant& plant, Progress& progress);

  /// The scene, once the plants of all keys have been added. Throws InputError as add() does.
  MovingScene take(Progress& progress);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace meristem
