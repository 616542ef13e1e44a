// SPDX-License-Identifier: Apache-2.0
// Reduces the triangles of a small plant by what is visible of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Triangles between common points.
struct FaceSoup {
  struct Face {
    std::array<std::uint32_t, 3> points;
    std::array<std::uint32_t, 3> corners;  ///< numbers of the corners' attributes, which only the caller knows
    std::uint32_t group = 0;               ///< group with its own outlines; all faces of a point have one group
    std::uint32_t look = 0;                ///< a number whose meaning only the caller knows
  };
  std::vector<Vec3> points;
  std::vector<Face> faces;
  std::vector<Vec3> corner_normals;  ///< unit normals, by the number of a corner's attributes
  std::vector<Vec2> corner_uvs;      ///< uvs, by the number of a corner's attributes
};

/// Removes faces in the order in which the outlines suffer least.
class OutlineCollapse {
 public:
  /// Draws the outlines that must be kept. Throws Cancelled.
  OutlineCollapse(FaceSoup soup, Progress& progress);
  ~OutlineCollapse();

  /// Continues until there are at most this many faces, or until no face can be removed. Then moves points to positions
  /// where the outlines fit best.
  void run(std::size_t faces, Progress& progress);
  std::size_t face_count() const;
  /// Returns the remaining faces. Points and corners keep their numbers.
  FaceSoup soup() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace meristem
