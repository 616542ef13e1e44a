// SPDX-License-Identifier: Apache-2.0
// The truth behind a picture: how far away each pixel's surface is, which way it faces, and whose it is. One ray goes
// through the middle of each pixel, where render_still spreads many over it; so edges are sharp, and a pixel belongs to
// one thing. What stands in the picture hides here as well: obstacles, and the ground.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/document/grow.h"
#include "meristem/output/picture/camera.h"
#include "meristem/scene/scene.h"
#include "meristem/scene/view.h"

namespace meristem {

/// What a mask tells apart.
enum class TruthLevel {
  organ,  ///< each leaf, flower or fruit, and the wood of each shoot
  shoot,  ///< each axis with the organs on it
  plant,  ///< each plant
};
inline constexpr int kTruthLevels = 3;  ///< number of values of TruthLevel

/// Something that is seen in a picture.
struct SeenThing {
  std::string component;    ///< id in the document: of the organ, of what made the shoot, of the plant
  bool is_organ = false;    ///< on the level of organs: not the wood of a shoot
  std::uint32_t shoot = 0;  ///< number of its shoot, on the level of organs; 0: none
  std::uint32_t plant = 0;  ///< number of its plant; 0: none
  int order = -1;           ///< branching order of its axis, of shoots and their wood; -1: not known
};

/// One level's mask: the number of what is seen in each pixel, 0 for none, 1 for the first of `things`.
struct TruthMask {
  std::vector<std::uint32_t> number;  ///< row by row from the top
  std::vector<SeenThing> things;      ///< those that are seen, in the order of their first pixels
};

/// The surface behind each pixel, row by row from the top.
struct Truth {
  int width = 0;             ///< pixels
  int height = 0;            ///< pixels
  std::vector<float> depth;  ///< metres along the way that the camera looks; infinite for the sky
  /// Unit, on the side that is seen, in the camera's own frame: x to the right, y up, z toward the camera; 0 for the
  /// sky.
  std::vector<Vec3> normal;
  TruthMask masks[kTruthLevels];  ///< by TruthLevel
  Camera camera;                  ///< which sees it: that of take_picture for the same view and size

  /// Returns the mask of a level.
  const TruthMask& mask(TruthLevel level) const { return masks[static_cast<int>(level)]; }
};

/// Size of the picture, and what it shows.
struct TruthOptions {
  int width = 1200;          ///< pixels
  int height = 1200;         ///< pixels
  bool transparent = false;  ///< without ground and obstacles, as in StillOptions
};

/// The truth behind the picture that render_still makes of what has grown, up to meshes; where textures have holes,
/// these must be painted (has_holes, foliage.h). A shoot's wood is told by the axis whose surface is nearest, an
/// organ's shoot by the axis nearest to its base. The same on any number of threads. Throws InputError for sizes
/// outside 1 to 16384, Cancelled.
Truth see_truth(const GrownDocument& grown, const Limits& limits, const Scene& scene, const View& view,
                const TruthOptions& options, Progress& progress);

}  // namespace meristem
