// SPDX-License-Identifier: Apache-2.0
// How much light comes to each pixel of a tile. Samples are spread over squares around the pixels' middles, and each
// counts in the four pixels that it lies between, as much as it is near (a tent): so a pixel is the mean of more than
// twice the paths that are followed for it. They are taken in rounds, each as many as all before. After a round a
// square goes on if the first and the second half of the samples of those around it differ, as the eye sees it, by so
// much that more samples are worth their time: even sky and sunlit ground end early, and crowns take what they need. A
// square has no say in its own case: one that by chance has missed the few bright paths would stop too early, and the
// picture would darken. As squares will gather the indirect light of those around them, it counts with a part of its
// noise only.
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

/// What a pixel is exposed to but for indirect light, which is its albedo times what its square gathers.
struct PixelExposure {
  Vec3 direct{0};  ///< weighted by how much of it hides the background, as the others are
  PerLayer<Vec3> albedo{};
  float cover = 0;
};

/// What a tile is exposed to, row by row.
struct Exposure {
  std::vector<PixelExposure> pixels;
  std::vector<IndirectLight> indirect;  ///< of the pixels' squares
};

/// The pixels [left, right) x [top, bottom) of a picture.
struct Tile {
  int left, top, right, bottom;
};

class Photographer {
 public:
  struct Settings {
    int width = 0;  ///< pixels of the whole picture
    int height = 0;
    int samples = 64;       ///< most paths a pixel; the noise that is borne goes down with its root
    float exposure = 1;     ///< factor on light before it is shown
    bool shows_sky = true;  ///< behind what is seen; covers are 1 then
    bool is_even = false;   ///< every pixel takes all samples
  };

  /// `tracer` and `camera` must outlive this.
  Photographer(const PathTracer& tracer, const Camera& camera, const Settings& settings);

  /// Radians from pixel to pixel in the middle of the picture.
  float pixel_angle() const { return pixel_angle_; }
  /// A function of the picture and the tile alone. Throws Cancelled.
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
