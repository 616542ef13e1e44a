// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/indirect_light.h"

#include <algorithm>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

// Two passes of five squares across and five down, the second at twice the step, reach six squares to each side. A third
// leaves ground smoother and leaves paler, for as much noise.
constexpr int kPasses = 2;
constexpr float kSpline[] = {0.0625F, 0.25F, 0.375F, 0.25F, 0.0625F};
// How much less surfaces give that face another way, as a factor on the squared distance of the mean normals; and that
// are brighter or darker, on the square of the difference over the sum.
constexpr float kFacingAway = 6;
constexpr float kBrighter = 32;
constexpr int kReachOfNoise = 3;  // squares to each side that tell the noise

/// What decides how much squares have in common.
struct Look {
  Vec3 normal{0};
  float brightness = 0;
};

struct Given {
  PerLayer<Vec3> light{};
  PerLayer<Vec3> albedo{};
};

Look look_of(const IndirectLight& square) {
  if (square.met == 0) return {};
  const float scale = 1 / static_cast<float>(square.met);
  return {scale * square.normal, scale * luminance(square.albedo[0])};
}

float in_common(const Look& a, const Look& b) {
  const Vec3 turned = a.normal - b.normal;
  const float brighter = (a.brightness - b.brightness) / (a.brightness + b.brightness + 0.01F);
  return 1 / ((1 + kFacingAway * glm::dot(turned, turned)) * (1 + kBrighter * brighter * brighter));
}

/// What each square and those at two steps around it gave.
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
          const float near = kSpline[i] * kSpline[j];
          const float alike = near * in_common(looks[here], looks[there]);
          sum.light[0] += alike * given[there].light[0];
          sum.albedo[0] += alike * given[there].albedo[0];
          sum.light[1] += near * given[there].light[1];
          sum.albedo[1] += near * given[there].albedo[1];
        }
      }
    }
  }
  return sums;
}

/// How far a square's own light is from what it gathers, and how far noise alone takes it, both squared.
struct Strays {
  float all = 0;
  float by_noise = 0;
};

float beyond(const IndirectLight& square, const GatheredLight& gathered) {
  Vec3 rest(0);
  for (int layer = 0; layer < kLayers; ++layer) {
    rest += square.light[layer] - square.albedo[layer] * gathered.irradiance[layer];
  }
  return luminance(rest);
}

Strays strays_of(const HalvedLight& square, const GatheredLight& gathered) {
  const auto samples = static_cast<float>(square.all.samples);
  const auto first_samples = static_cast<float>(square.first.samples);
  const float second_samples = samples - first_samples;
  if (first_samples == 0 || second_samples == 0) return {};
  const float all = beyond(square.all, gathered);
  const float first = beyond(square.first, gathered);
  const float mean = all / samples;
  const float difference = first / first_samples - (all - first) / second_samples;
  return {mean * mean, difference * difference * first_samples * second_samples / (samples * samples)};
}

float own_share(const std::vector<Strays>& strays, int width, int x, int y) {
  const int height = static_cast<int>(strays.size()) / width;
  Strays sum;
  for (int v = std::max(0, y - kReachOfNoise); v <= std::min(height - 1, y + kReachOfNoise); ++v) {
    for (int u = std::max(0, x - kReachOfNoise); u <= std::min(width - 1, x + kReachOfNoise); ++u) {
      sum.all += strays[v * width + u].all;
      sum.by_noise += strays[v * width + u].by_noise;
    }
  }
  return sum.all > 0 ? std::max(0.0F, 1 - sum.by_noise / sum.all) : 0.0F;
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
  ++met;
}

std::vector<GatheredLight> gathered_light(std::span<const HalvedLight> squares, int width) {
  std::vector<Look> looks;
  std::vector<Given> given;
  looks.reserve(squares.size());
  given.reserve(squares.size());
  for (const HalvedLight& square : squares) {
    looks.push_back(look_of(square.all));
    given.push_back({square.all.light, square.all.albedo});
  }
  for (int pass = 0; pass < kPasses; ++pass) given = spread(given, looks, width, 1 << pass);

  std::vector<GatheredLight> gathered(squares.size());
  std::vector<Strays> strays;
  strays.reserve(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    for (int layer = 0; layer < kLayers; ++layer) {
      gathered[i].irradiance[layer] = given[i].light[layer] / glm::max(given[i].albedo[layer], Vec3(1e-6F));
    }
    strays.push_back(strays_of(squares[i], gathered[i]));
  }
  for (std::size_t i = 0; i < squares.size(); ++i) {
    gathered[i].own = own_share(strays, width, static_cast<int>(i) % width, static_cast<int>(i) / width);
  }
  return gathered;
}

}  // namespace meristem
