// SPDX-License-Identifier: Apache-2.0
// Gathers indirect light, which is the light from the sky and from other surfaces. This light is the noisiest part of a
// picture, but it varies little from pixel to pixel, unlike the colours of surfaces. Each square of the film therefore
// averages the indirect light of the squares around it, divided by their albedo. Squares count more if their surfaces
// have equal normals, depths and brightness, and they count less as the square has more samples of its own. Ground and
// the objects on it are gathered separately.
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

constexpr int kReachOfGathering = 14;  ///< number of squares to each side
constexpr int kLayers = 2;             ///< 0: objects on the ground, 1: the ground

template <class T>
using PerLayer = std::array<T, kLayers>;

/// Returns the index in a PerLayer for the visible object.
constexpr int layer_of(Sight sight) { return sight == Sight::ground ? 1 : 0; }

/// Indirect light of a square, as sums over samples.
struct IndirectLight {
  PerLayer<Vec3> light{};
  PerLayer<Vec3> albedo{};
  // Surfaces of layer 0 that were hit:
  Vec3 normal{0};
  float depth = 0;  ///< logarithm of the distance
  int met = 0;      ///< number of samples that hit a surface
  int samples = 0;

  void add(const Seen& seen);
  Vec3 sum() const { return light[0] + light[1]; }
};

/// Returns the indirect light that falls on the surface in each square. Times the albedo, this is the visible light.
/// The squares are in rows of `width`, and `angle` (radians) is the width of a square as seen from the camera. Squares
/// at the border have fewer neighbours.
std::vector<PerLayer<Vec3>> gathered_irradiance(std::span<const IndirectLight> squares, int width, float angle);

}  // namespace meristem
