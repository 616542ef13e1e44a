// SPDX-License-Identifier: Apache-2.0
// Indirect light comes to a surface from the sky and from other surfaces. It is the noisiest part of a picture, and yet
// varies little from pixel to pixel, unlike what surfaces give back of it. So each square of the film gathers the
// indirect light of those around it, over what surfaces gave back there, and more of it where surfaces face the same way
// and are as bright. Where squares differ by more than their noise explains, they keep that share of their own light:
// none on plain ground, much among leaves, and all of it in the end, with more and more samples. Ground and what stands
// on it gather by themselves.
//
// Based on: H. Dammertz, D. Sewtz, J. Hanika and H. Lensch: Edge-avoiding à-trous wavelet transform for fast global
// illumination filtering (2010); B. Efron and C. Morris: Stein's estimation rule and its competitors (1973).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/output/picture/path_tracer.h"

namespace meristem {

constexpr int kLayers = 2;  ///< 0: what stands on the ground, 1: the ground

template <class T>
using PerLayer = std::array<T, kLayers>;

/// The place of what is seen in a PerLayer.
constexpr int layer_of(Sight sight) { return sight == Sight::ground ? 1 : 0; }

/// Indirect light of a square, as sums over samples.
struct IndirectLight {
  PerLayer<Vec3> light{};
  PerLayer<Vec3> albedo{};
  Vec3 normal{0};  ///< of the surfaces of layer 0
  int met = 0;     ///< samples that met one of them
  int samples = 0;

  void add(const Seen& seen);
  Vec3 sum() const { return light[0] + light[1]; }
};

/// The samples of a square, and the first half of them.
struct HalvedLight {
  IndirectLight all;
  IndirectLight first;
};

/// What a square gathers.
struct GatheredLight {
  PerLayer<Vec3> irradiance{};  ///< over pi: times the albedo, it is the light that is seen
  float own = 0;                ///< the share of the square's own light that is kept, 0 to 1
};

/// What each of the squares gathers, `width` in a row. Those at the border have fewer around them.
std::vector<GatheredLight> gathered_light(std::span<const HalvedLight> squares, int width);

}  // namespace meristem
