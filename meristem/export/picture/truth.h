// SPDX-License-Identifier: Apache-2.0
// Ground truth of a picture: the distance of each pixel's surface, its normal and its object. One ray goes through the
// middle of each pixel, while render_still spreads many rays over it. Edges are therefore sharp, and a pixel belongs to
// one object. Obstacles and the ground also hide surfaces here.
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

/// The objects that a mask distinguishes.
enum class TruthLevel {
  organ,  ///< each leaf, flower or fruit, and the wood of each shoot
  shoot,  ///< each axis with the organs on it
  plant,  ///< each plant
};
inline constexpr int kTruthLevels = 3;  ///< number of values of TruthLevel

/// An object that is visible in a picture.
struct SeenThing {
  std::string component;    ///< id in the document of the organ, of the shoot's origin, or of the plant
  bool is_organ = false;    ///< at the level of organs: true unless the object is the wood of a shoot
  std::uint32_t shoot = 0;  ///< number of its shoot, at the level of organs; 0 if it has no shoot
  std::uint32_t plant = 0;  ///< number of its plant; 0 if it has no plant
  int order = -1;           ///< branching order of the axis, for shoots and their wood; -1 if unknown
};

/// The mask of one level: the number of the visible object in each pixel. 0 is no object, 1 the first of `things`.
struct TruthMask {
  std::vector<std::uint32_t> number;  ///< row by row from the top
  std::vector<SeenThing> things;      ///< visible objects, in the order of their first pixels
};

/// The surface behind each pixel, row by row from the top.
struct PictureTruth {
  int width = 0;             ///< pixels
  int height = 0;            ///< pixels
  std::vector<float> depth;  ///< metres along the viewing direction of the camera; infinite for the sky
  /// Unit normal on the visible side, in the camera's frame: x to the right, y up, z toward the camera. 0 for the sky.
  std::vector<Vec3> normal;
  TruthMask masks[kTruthLevels];  ///< indexed by TruthLevel
  Camera camera;                  ///< camera of the picture, as take_picture uses it for this view and size

  /// Returns the mask of a level.
  const TruthMask& mask(TruthLevel level) const { return masks[static_cast<int>(level)]; }
};

/// Size and content of the picture.
struct TruthOptions {
  int width = 1200;          ///< pixels
  int height = 1200;         ///< pixels
  bool transparent = false;  ///< without ground and obstacles, as in StillOptions
};

/// Returns the truth of the picture that render_still makes of a grown document, which must be grown up to meshes.
/// Textures with holes must be painted (has_holes, foliage.h). Wood belongs to the shoot whose axis has the nearest
/// surface, and an organ to the shoot whose axis is nearest to its base. The result is equal on any number of threads.
/// Throws InputError for sizes outside 1 to 16384, Cancelled.
PictureTruth see_truth(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene, const CameraView& view,
                       const TruthOptions& options, Progress& progress);

}  // namespace meristem
