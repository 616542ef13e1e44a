// SPDX-License-Identifier: Apache-2.0
// Takes samples adaptively: squares of the film continue until the noise around them is below the accepted noise. The
// noise of a square is estimated from the difference of two halves of its samples (sources in the header).
#include "meristem/output/picture/photographer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

constexpr float kSharpness = 0.6F;  // width of texture averages relative to a pixel; samples smooth the rest
constexpr int kNeighbours = 2;      // number of deciding squares to each side
constexpr int kFirstRound = 8;      // divisor: the first round takes this part of the samples
constexpr int kMinSamples = 4;
// The accepted noise after 16 of 64 samples, as a variance of the displayed brightness from 0 to 1. After 32 samples,
// twice as much is accepted, because each further sample removes half as much. After 8 samples, half as much is
// accepted among leaves, so that crowns do not stop after a few samples while the shade beside them takes all. Grain is
// visible on plain ground but not among leaves, so the accepted noise rises with the contrast between pixels.
constexpr float kUsualSamples = 16;
constexpr float kNoiseOfPlain = 0.0115F * 0.0115F;
constexpr float kNoiseByContrast = 0.11F;  // accepted noise as a share of the variance among squares
constexpr float kMaxNoise = 0.042F * 0.042F;
// Share of the noise of indirect light that remains after gathering.
constexpr float kNoiseAfterGathering = 0.4F;

struct Mean {
  float sum = 0;
  int count = 0;
  void add(float value) { sum += value, ++count; }
  float value() const { return count > 0 ? sum / static_cast<float>(count) : 0; }
};

}  // namespace

/// The square of the film that is nearer to the middle of one pixel than to other pixels.
struct Photographer::Square {
  /// The sum that a square's samples add to one pixel.
  struct Share {
    Vec3 direct{0};
    PerLayer<Vec3> albedo{};
    float cover = 0;
    float weight = 0;
  };
  std::array<Share, 9> shares;  // for the own pixel and the pixels around it, row by row
  // Sums over all samples, and over the first half.
  Vec3 direct{0};
  Vec3 first_direct{0};
  IndirectLight indirect;
  Vec3 first_indirect{0};
  float cover = 0;
  float first_cover = 0;
  int samples = 0;
  float brightness = 0;  // displayed brightness
  float noise = 0;       // variance of the brightness
  bool goes_on = true;
};

Photographer::Photographer(const PathTracer& tracer, const Camera& camera, const Settings& settings)
    : tracer_(tracer), camera_(camera), settings_(settings) {
  const float half_pixel = 1 / static_cast<float>(settings.height);
  pixel_angle_ = glm::distance(camera.direction({0, half_pixel}), camera.direction({0, -half_pixel}));
}

void Photographer::sample(int x, int y, int sample, Square& square) const {
  // Squares begin one pixel outside the picture.
  SampleStream samples(pixel_number(x + 1, y + 1), static_cast<std::uint32_t>(sample),
                       static_cast<std::uint32_t>(settings_.samples));
  const Vec2 at = samples.next();
  const Vec2 film(2 * (static_cast<float>(x) + at.x) / static_cast<float>(settings_.width) - 1,
                  1 - 2 * (static_cast<float>(y) + at.y) / static_cast<float>(settings_.height));
  const Ray ray{camera_.position(), camera_.direction(film), kSharpness * pixel_angle_};
  Seen seen = tracer_.trace(ray, samples);
  if (settings_.shows_sky) {
    if (seen.cover < 1) seen.direct += (1 - seen.cover) * tracer_.background(ray.direction);
    seen.cover = 1;
  }
  square.direct += seen.direct;
  square.indirect.add(seen);
  square.cover += seen.cover;
  // Distribute the sample among the four pixels whose middles lie around it.
  const Vec2 away(std::abs(at.x - 0.5F), std::abs(at.y - 0.5F));
  const int beside = at.x < 0.5F ? -1 : 1;
  const int below = at.y < 0.5F ? -3 : 3;
  const auto add = [&](int pixel, float weight) {
    Square::Share& share = square.shares[pixel];
    share.direct += weight * seen.direct;
    share.albedo[layer_of(seen.sight)] += weight * seen.albedo;
    share.cover += weight * seen.cover;
    share.weight += weight;
  };
  add(4, (1 - away.x) * (1 - away.y));
  add(4 + beside, away.x * (1 - away.y));
  add(4 + below, (1 - away.x) * away.y);
  add(4 + beside + below, away.x * away.y);
}

/// Adds the samples [begin, end) to the squares that continue.
void Photographer::sample(const Tile& tile, std::vector<Square>& squares, int begin, int end,
                          Progress& progress) const {
  Square* square = squares.data();
  for (int y = tile.top; y < tile.bottom; ++y) {
    progress.check();
    for (int x = tile.left; x < tile.right; ++x, ++square) {
      if (!square->goes_on) continue;
      for (int s = begin; s < end; ++s) {
        if (s % 256 == 0) progress.check();
        sample(x, y, s, *square);
      }
      square->samples = end;
    }
  }
}

/// Returns the approximate displayed brightness, in a fast form.
float Photographer::shown(Vec3 light, int samples) const {
  const float bright = std::max(0.0F, settings_.exposure * luminance(light) / static_cast<float>(samples));
  return std::sqrt(bright / (1 + bright));
}

/// Computes the brightness, and its variance from the difference of the halves. This difference reflects how evenly the
/// samples are spread.
void Photographer::judge(Square& square) const {
  const int half = square.samples / 2;
  // After gathering, indirect light keeps only a share of its noise.
  const Vec3 indirect = square.indirect.sum();
  const Vec3 even = 0.5F * (1 - kNoiseAfterGathering) * indirect;
  const Vec3 first = square.first_direct + even + kNoiseAfterGathering * square.first_indirect;
  const Vec3 all = square.direct + indirect;
  const float brightness = shown(first, half) - shown(all - first, half);
  const float cover = (2 * square.first_cover - square.cover) / static_cast<float>(half);
  square.noise = 0.25F * (brightness * brightness + cover * cover);
  square.brightness = shown(all, square.samples);
}

/// Stops the squares whose neighbours have accepted noise. Returns true if any square continues.
bool Photographer::stop_squares(int width, std::vector<Square>& squares) const {
  for (Square& square : squares) {
    if (square.goes_on) judge(square);
  }
  const int height = static_cast<int>(squares.size()) / width;
  const float scale = 64 / static_cast<float>(settings_.samples);
  bool any_goes_on = false;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Square& square = squares[y * width + x];
      if (!square.goes_on) continue;
      // The mean noise of the surrounding squares, and their variance.
      Mean noise;
      Mean brightness;
      Mean squared_brightness;
      for (int v = std::max(0, y - kNeighbours); v <= std::min(height - 1, y + kNeighbours); ++v) {
        for (int u = std::max(0, x - kNeighbours); u <= std::min(width - 1, x + kNeighbours); ++u) {
          if (u == x && v == y) continue;
          const Square& other = squares[v * width + u];
          noise.add(other.noise);
          brightness.add(other.brightness);
          squared_brightness.add(other.brightness * other.brightness);
        }
      }
      const float contrast =
          std::max(0.0F, squared_brightness.value() - brightness.value() * brightness.value() - noise.value());
      const float taken = scale * static_cast<float>(square.samples) / kUsualSamples;
      const float borne_here = (kNoiseOfPlain + kNoiseByContrast * contrast) * std::max(1.0F, taken);
      const float bearable = std::min(borne_here, kMaxNoise * taken);
      square.goes_on = noise.value() > scale * bearable;
      any_goes_on = any_goes_on || square.goes_on;
    }
  }
  return any_goes_on;
}

Exposure Photographer::expose(const Tile& tile, Progress& progress) const {
  // Pixels at the tile's border receive light from squares beyond it.
  const Tile around{tile.left - 1, tile.top - 1, tile.right + 1, tile.bottom + 1};
  const int width = around.right - around.left;
  std::vector<Square> squares(static_cast<std::size_t>(width) * (around.bottom - around.top));

  // Take the samples in rounds. Powers of 2 are spread evenly. The first round is taken in halves, and each later round
  // is the second half of all samples.
  const int max = settings_.samples;
  const int share = static_cast<int>(std::bit_floor(static_cast<unsigned>(max / kFirstRound)));
  int end = settings_.is_even ? max : std::min(max, std::max(kMinSamples, share));
  int begin = end / 2;
  sample(around, squares, 0, begin, progress);
  for (;;) {
    for (Square& square : squares) {
      if (!square.goes_on) continue;
      square.first_direct = square.direct;
      square.first_indirect = square.indirect.sum();
      square.first_cover = square.cover;
    }
    sample(around, squares, begin, end, progress);
    if (end == max || !stop_squares(width, squares)) break;
    begin = end;
    end = std::min(2 * end, max);
  }

  // Each pixel adds up the shares of its own square and of the squares around it.
  Exposure exposure;
  const std::size_t pixels = static_cast<std::size_t>(tile.right - tile.left) * (tile.bottom - tile.top);
  exposure.pixels.reserve(pixels);
  exposure.indirect.reserve(pixels);
  for (int y = 1; y <= tile.bottom - tile.top; ++y) {
    for (int x = 1; x <= tile.right - tile.left; ++x) {
      PixelExposure pixel;
      float weight = 0;
      for (int k = 0; k < 9; ++k) {
        const Square& square = squares[(y + k / 3 - 1) * width + x + k % 3 - 1];
        const Square::Share& seen = square.shares[8 - k];
        const float scale = 1 / static_cast<float>(square.samples);
        pixel.direct += scale * seen.direct;
        for (int layer = 0; layer < kLayers; ++layer) pixel.albedo[layer] += scale * seen.albedo[layer];
        pixel.cover += scale * seen.cover;
        weight += scale * seen.weight;
      }
      for (Vec3& albedo : pixel.albedo) albedo /= weight;
      exposure.pixels.push_back({pixel.direct / weight, pixel.albedo, pixel.cover / weight});
      exposure.indirect.push_back(squares[y * width + x].indirect);
    }
  }
  return exposure;
}

}  // namespace meristem
