// SPDX-License-Identifier: Apache-2.0
// Smooths indirect light by an à-trous filter that respects edges: several passes of a small kernel with growing gaps.
// Weights fall where normals, brightness or depth differ (source in the header).
#include "meristem/output/picture/indirect_light.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

// Three passes of five by five squares, each with twice the step of the pass before. With two passes, plain surfaces
// still show patches.
constexpr int kPasses = 3;
static_assert(kReachOfGathering == 2 * ((1 << kPasses) - 1));
constexpr float kSpline[] = {0.0625F, 0.25F, 0.375F, 0.25F, 0.0625F};
// How fast weights fall with differences between surfaces: with the squared distance of the mean normals, with the
// squared relative difference of brightness, and with the squared difference of depth. Without the last one, light
// leaks from the outer leaves of a crown into its dark inside.
constexpr float kFacingAway = 6;
constexpr float kBrighter = 32;
constexpr float kDeeper = 0.0006F;
// Number of own samples at which other squares count half. At twice as many samples they count a fifth.
constexpr float kManySamples = 48;

/// The data that decide how similar two squares are.
struct Look {
  Vec3 normal{0};
  float brightness = 0;
  float depth = 0;   ///< depth in squares
  float others = 1;  ///< weight of other squares, relative to their weight for a square with few samples
};

struct Given {
  PerLayer<Vec3> light{};
  PerLayer<Vec3> albedo{};
};

Look look_of(const IndirectLight& square, float angle) {
  Look look;
  const float many = static_cast<float>(square.samples) / kManySamples;
  look.others = 1 / (1 + many * many);
  if (square.met == 0) return look;
  const float scale = 1 / static_cast<float>(square.met);
  look.normal = scale * square.normal;
  look.brightness = scale * luminance(square.albedo[0]);
  look.depth = scale * square.depth / angle;
  return look;
}

float in_common(const Look& a, const Look& b) {
  const Vec3 turned = a.normal - b.normal;
  const float brighter = (a.brightness - b.brightness) / (a.brightness + b.brightness + 0.01F);
  const float deeper = a.depth - b.depth;
  return 1 / ((1 + kFacingAway * glm::dot(turned, turned)) * (1 + kBrighter * brighter * brighter) *
              (1 + kDeeper * deeper * deeper));
}

/// Returns the sums over each square and its neighbours at one and two steps.
std::vector<Given> spread(const std::vector<Given>& given, const std::vector<Look>& looks, int width, int step) {
  const int height = static_cast<int>(given.size()) / width;
  std::vector<Given> sums(given.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int here = y * width + x;
      Given& sum = sums[here];
      for (int j = 0; j < 5; ++j) {
        const int v = y + (j - 2) * step;
        if (v < 0 || v >= height) continue;
        for (int i = 0; i < 5; ++i) {
          const int u = x + (i - 2) * step;
          if (u < 0 || u >= width) continue;
          const int there = v * width + u;
          const float near = (there == here ? 1 : looks[here].others) * kSpline[i] * kSpline[j];
          const Given& other = given[there];
          if (other.albedo[0] != Vec3(0)) {
            const float alike = near * in_common(looks[here], looks[there]);
            sum.light[0] += alike * other.light[0];
            sum.albedo[0] += alike * other.albedo[0];
          }
          if (other.albedo[1] != Vec3(0)) {
            sum.light[1] += near * other.light[1];
            sum.albedo[1] += near * other.albedo[1];
          }
        }
      }
    }
  }
  return sums;
}

}  // namespace

void IndirectLight::add(const Seen& seen) {
  ++samples;
  if (seen.sight == Sight::nothing) return;
  const int layer = layer_of(seen.sight);
  light[layer] += seen.indirect;
  albedo[layer] += seen.albedo;
  if (layer != 0) return;
  normal += seen.normal;
  depth += std::log(seen.distance);
  ++met;
}

std::vector<PerLayer<Vec3>> gathered_irradiance(std::span<const IndirectLight> squares, int width, float angle) {
  std::vector<Look> looks;
  std::vector<Given> given;
  looks.reserve(squares.size());
  given.reserve(squares.size());
  for (const IndirectLight& square : squares) {
    looks.push_back(look_of(square, angle));
    given.push_back({square.light, square.albedo});
  }
  for (int pass = 0; pass < kPasses; ++pass) given = spread(given, looks, width, 1 << pass);

  std::vector<PerLayer<Vec3>> irradiance(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    for (int layer = 0; layer < kLayers; ++layer) {
      irradiance[i][layer] = given[i].light[layer] / glm::max(given[i].albedo[layer], Vec3(1e-6F));
    }
  }
  return irradiance;
}

}  // namespace meristem
