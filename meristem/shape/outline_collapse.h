// SPDX-License-Identifier: Apache-2.0
// Fewer triangles for a plant of few, by what can be seen of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Triangles between points that they share.
struct FaceSoup {
  struct Face {
    std::array<std::uint32_t, 3> points;
    std::array<std::uint32_t, 3> corners;  ///< numbers of what the corners wear, which only the caller knows
    std::uint32_t group = 0;               ///< has outlines of its own; the faces of a point have one group
    std::uint32_t look = 0;                ///< a number whose meaning only the caller knows
  };
  std::vector<Vec3> points;
  std::vector<Face> faces;
  std::vector<Vec3> corner_normals;  ///< unit, by the number of what a corner wears
  std::vector<Vec2> corner_uvs;      ///< by the number of what a corner wears
};

/// Takes away faces in the order in which the outlines suffer least.
class OutlineCollapse {
 public:
  /// Draws the outlines that are to be kept. Throws Cancelled.
  OutlineCollapse(FaceSoup soup, Progress& progress);
  ~OutlineCollapse();

  /// Goes on until there are at most this many faces, or none can go; then moves points to where the outlines fit best.
  void run(std::size_t faces, Progress& progress);
  std::size_t face_count() const;
  /// What is left; points and corners keep their numbers.
  FaceSoup soup() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace meristem
