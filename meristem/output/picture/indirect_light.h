// SPDX-License-Identifier: Apache-2.0
// Indirect light comes to a surface from the sky and from other surfaces. It is the noisiest part of a picture, and yet
// varies little from pixel to pixel, unlike what surfaces give back of it. So each square of the film gathers the
// indirect light of those around it, over what surfaces gave back there: more of it where surfaces face the same way,
// lie as deep and are as bright, and less of it the more samples a square has of its own. Ground and what stands on it
// gather by themselves.
//
// Based on: H. Dammertz, D. Sewtz, J. Hanika and H. Lensch: Edge-avoiding à-trous wavelet transform for fast global
// illumination filtering (2010).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/output/picture/path_tracer.h"

namespace meristem {

constexpr int kReachOfGathering = 14;  ///< squares to each side
constexpr int kLayers = 2;             ///< 0: what stands on the ground, 1: the ground

template <class T>
using PerLayer = std::array<T, kLayers>;

/// The place of what is seen in a PerLayer.
constexpr int layer_of(Sight sight) { return sight == Sight::ground ? 1 : 0; }

/// Indirect light of a square, as sums over samples.
struct IndirectLight {
  PerLayer<Vec3> light{};
  PerLayer<Vec3> albedo{};
  // What was met of layer 0:
  Vec3 normal{0};
  float depth = 0;  ///< logarithm of the distance
  int met = 0;      ///< samples that met a surface
  int samples = 0;

  void add(const Seen& seen);
  Vec3 sum() const { return light[0] + light[1]; }
};

/// The indirect light that falls on what each of the squares shows, `width` in a row and each as wide as `angle`
/// (radians) is from the camera: times the albedo, it is the light that is seen. Squares at the border have fewer
/// around them.
std::vector<PerLayer<Vec3>> gathered_irradiance(std::span<const IndirectLight> squares, int width, float angle);

}  // namespace meristem
