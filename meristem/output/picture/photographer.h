// SPDX-License-Identifier: Apache-2.0
// Exposes the pixels of a tile. Samples are spread over squares around the middles of pixels. Each sample counts in the
// four nearest pixels by its distance (tent filter), so a pixel is the mean of more than twice the paths that are
// followed for it. Samples are taken in rounds, each as many as all rounds before. After a round, a square continues if
// the first and the second half of its neighbours' samples differ visibly, so that more samples are worth their time.
// Even sky and sunlit ground end early, and crowns take what they need. A square's own samples do not decide. If they
// did, squares that missed the few bright paths by chance would stop too early, and the picture would darken. Indirect
// light is gathered later over many squares, so only a part of its noise counts.
//
// Based on: F. Rousselle, C. Knaus and M. Zwicker: Adaptive rendering with non-local means filtering (2012) for the two
// halves; D. Kirk and J. Arvo: Unbiased sampling techniques for image synthesis (1991) for the bias.
#pragma once

#include <vector>

#include "meristem/base/progress.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/indirect_light.h"
#include "meristem/output/picture/path_tracer.h"

namespace meristem {

/// The exposure of a pixel without indirect light. Indirect light is the albedo times what the pixel's square gathers.
struct PixelExposure {
  Vec3 direct{0};  ///< all members are weighted by how much of the background is hidden
  PerLayer<Vec3> albedo{};
  float cover = 0;
};

/// The exposure of a tile, row by row.
struct Exposure {
  std::vector<PixelExposure> pixels;
  std::vector<IndirectLight> indirect;  ///< of the squares of the pixels
};

/// The pixels [left, right) x [top, bottom) of a picture.
struct Tile {
  int left, top, right, bottom;
};

class Photographer {
 public:
  struct Settings {
    int width = 0;  ///< width of the whole picture, pixels
    int height = 0;
    int samples = 64;       ///< maximum number of paths per pixel; the accepted noise falls with its root
    float exposure = 1;     ///< factor on light before it is shown
    bool shows_sky = true;  ///< if true, the sky is visible in the background and all covers are 1
    bool is_even = false;   ///< if true, every pixel takes all samples
  };

  /// `tracer` and `camera` must outlive this object.
  Photographer(const PathTracer& tracer, const Camera& camera, const Settings& settings);

  /// Returns the angle between pixels in the middle of the picture, radians.
  float pixel_angle() const { return pixel_angle_; }
  /// Returns the exposure of a tile, which depends only on the picture and the tile. Throws Cancelled.
  Exposure expose(const Tile& tile, Progress& progress) const;

 private:
  struct Square;

  void sample(const Tile& tile, std::vector<Square>& squares, int begin, int end, Progress& progress) const;
  void sample(int x, int y, int sample, Square& square) const;
  void judge(Square& square) const;
  bool stop_squares(int width, std::vector<Square>& squares) const;
  float shown(Vec3 light, int samples) const;

  const PathTracer& tracer_;
  const Camera& camera_;
  Settings settings_;
  float pixel_angle_;
};

}  // namespace meristem
