// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/shape/mesh/corner_table.h"
#include "meristem/shape/mesh/quadric.h"
#include "meristem/shape/mesh/vertex_queue.h"

namespace meristem {

/// A mesh whose edges collapse, the cheapest first.
class EdgeCollapse {
 public:
  /// No collapse may have an error above `error` metres. Indices must be in range. Throws Cancelled.
  EdgeCollapse(const Mesh& mesh, float error, const Progress& progress);

  /// Collapses edges until there are at most `triangles` triangles, or no edge can collapse. Throws Cancelled.
  void run(std::size_t triangles, Progress& progress);

  /// Returns the remaining positions and triangles.
  Mesh mesh(const Progress& progress) const;

 private:
  using Corner = CornerTable::Corner;

  /// Stored together, because walks around a mesh wait for memory more than for arithmetic.
  struct Vertex {
    Quadric quadric;
    Vec3 position{0};
    bool is_inner = false;    ///< true if the vertex may move
    bool is_blocked = false;  ///< true if its edges must not collapse until something around it changes
  };
  /// An edge from the vertex of `corner` to the vertex of the next corner, which has the higher index.
  struct Candidate {
    float cost = -1;  ///< the default comes before all others
    Corner corner = 0;
    DVec3 apex{0};

    bool is_before(const Candidate& other) const {
      return cost < other.cost || (cost == other.cost && corner < other.corner);
    }
  };
  /// A triangle that stays when an edge collapses. `corner` is at the edge's end, and the other two are `from` and
  /// `to`.
  struct FanTriangle {
    Corner corner;
    std::uint32_t from, to;
    DVec3 normal{0};  // unit normal after the collapse
  };

  void add_quadrics(const Progress& progress);
  float median_cost(const Progress& progress) const;
  void put_all(std::uint32_t begin, std::uint32_t end, const Progress& progress);
  void collapse_queued(std::size_t triangles, Progress& progress);
  DVec3 position(std::uint32_t vertex) const { return DVec3(vertices_[vertex].position) - centre_; }
  Vec3 stored(DVec3 point) const;
  DVec3 rounded(DVec3 point) const { return DVec3(stored(point)) - centre_; }

  template <class Visit>
  void for_each_edge(std::uint32_t vertex, Visit&& visit) const;
  Candidate candidate(std::uint32_t low, std::uint32_t high, Corner corner) const;
  Candidate cheapest_after(const Candidate& last, std::uint32_t vertex) const;
  void consider(std::uint32_t vertex);
  bool keeps_manifold(Corner corner);
  DVec3 with_volume(const Candidate& edge) const;
  bool keeps_form(DVec3 apex);
  bool keeps_folds(Corner corner, DVec3 apex);
  double sharpest_fold(Corner corner) const;
  void collapse(Corner corner, DVec3 apex);

  DVec3 centre_;  // origin of the quadrics, which lose digits far from their origin
  double squared_error_;
  CornerTable corners_;
  std::vector<Vertex> vertices_;
  VertexQueue queue_;
  std::vector<FanTriangle> fan_;
};

}  // namespace meristem
