// SPDX-License-Identifier: Apache-2.0
// Draws two scenes as silhouettes from many directions and compares the covered pixels. Directions run in parallel.
#include "meristem/shape/outline/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/outline/outline_raster.h"

namespace meristem {

namespace {

constexpr double kBallMargin = 1.2;  // radii of the ball around the plant to the picture's border, with a margin for
                                     // protruding parts
constexpr std::size_t kDrawnBetweenChecks = 100'000;

/// Returns the covered samples of a picture with as many samples along each side as given by the view.
std::vector<std::uint8_t> covered_samples(const MeshScene& scene, const OutlineView& view, Progress& progress) {
  const auto side = static_cast<std::size_t>(view.size);
  std::vector<std::uint8_t> samples(side * side);
  std::vector<glm::dvec2> corners;
  std::size_t unchecked = 0;
  for (const MeshInstances& part : scene.meshes) {
    corners.resize(part.mesh->vertex_count());
    for (std::size_t i = 0; i < part.count(); ++i) {
      const Frame frame = part.frame(i);
      for (std::size_t v = 0; v < corners.size(); ++v) corners[v] = view.pixel(frame.point(part.mesh->positions[v]));
      for (const auto& [a, b, c] : part.mesh->triangles) {
        cover_triangle(corners[a], corners[b], corners[c], view.size, [&](int row, int first, int end) {
          const std::size_t start = static_cast<std::size_t>(row) * side;
          std::fill(samples.begin() + static_cast<std::ptrdiff_t>(start) + first,
                    samples.begin() + static_cast<std::ptrdiff_t>(start) + end, std::uint8_t{1});
        });
      }
      unchecked += part.mesh->triangle_count();
      if (unchecked < kDrawnBetweenChecks) continue;
      progress.check();
      unchecked = 0;
    }
  }
  return samples;
}

/// Returns the number of covered samples of each pixel.
std::vector<int> covered_pixels(const MeshScene& scene, const OutlineView& view, int samples, Progress& progress) {
  const std::vector<std::uint8_t> fine = covered_samples(scene, view, progress);
  const int size = view.size / samples;
  std::vector<int> pixels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int y = 0; y < view.size; ++y) {
    for (int x = 0; x < view.size; ++x) {
      pixels[static_cast<std::size_t>(y / samples) * static_cast<std::size_t>(size) +
             static_cast<std::size_t>(x / samples)] +=
          fine[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size) + static_cast<std::size_t>(x)];
    }
  }
  return pixels;
}

struct Compared {
  std::int64_t both = 0;   // sum of the smaller number of covered samples of each pixel
  std::int64_t any = 0;    // sum of the larger number
  std::int64_t whole = 0;  // covered samples
  std::int64_t level = 0;
};

Compared compare(const std::vector<int>& whole, const std::vector<int>& level) {
  Compared sums;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    sums.both += std::min(whole[k], level[k]);
    sums.any += std::max(whole[k], level[k]);
    sums.whole += whole[k];
    sums.level += level[k];
  }
  return sums;
}

double share(std::int64_t part, std::int64_t all) {
  return all == 0 ? 1 : static_cast<double>(part) / static_cast<double>(all);
}

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return 1;
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

double OutlineOverlap::min() const {
  return of_direction.empty() ? 1 : *std::min_element(of_direction.begin(), of_direction.end());
}

double OutlineOverlap::mean() const { return mean_of(of_direction); }

double OutlineOverlap::mean_growth() const { return mean_of(growth); }

std::vector<Vec3> outline_directions(int count) {
  std::vector<Vec3> directions;
  for (int k = 0; k < count; ++k) {
    const double height = (k + 0.5) / count;
    const double turn = k * kGoldenAngleDeg * (kPi / 180);
    const double radius = std::sqrt(1 - height * height);
    directions.emplace_back(static_cast<float>(radius * math::cos(turn)), static_cast<float>(height),
                            static_cast<float>(radius * math::sin(turn)));
  }
  return directions;
}

OutlineOverlap outline_overlap(const MeshScene& whole, const MeshScene& level, const OutlineOptions& options,
                               Progress& progress) {
  if (options.directions < 1 || options.size < 1 || options.samples < 1)
    throw std::invalid_argument("outlines need a direction, a pixel and a sample");
  const Box box = whole.bounds();
  OutlineOverlap overlap;
  if (box.is_empty()) return overlap;
  const int size = options.size * options.samples;
  const double radius = std::max(0.5 * static_cast<double>(glm::length(box.size())), 1e-9);
  const std::vector<Vec3> directions = outline_directions(options.directions);
  overlap.of_direction.resize(directions.size());
  overlap.growth.resize(directions.size());
  parallel_for(directions.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const OutlineView view =
          view_along(directions[k], DVec3(box.centre()), 0.5 * size / (kBallMargin * radius), size);
      const Compared sums = compare(covered_pixels(whole, view, options.samples, progress),
                                    covered_pixels(level, view, options.samples, progress));
      overlap.of_direction[k] = share(sums.both, sums.any);
      overlap.growth[k] = share(sums.level, sums.whole);
    }
  });
  return overlap;
}

}  // namespace meristem
