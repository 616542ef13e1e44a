// SPDX-License-Identifier: Apache-2.0
// Builds and updates a corner table. Corners are sorted by their opposite edge to find pairs, and a collapse rewires
// the corners around the two removed triangles.
#include "meristem/shape/mesh/corner_table.h"

#include <algorithm>
#include <utility>

#include "meristem/shape/mesh/filled.h"

namespace meristem {

CornerTable::CornerTable(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices,
                         const Progress& progress)
    : first_(filled(vertices, kNone, progress)),
      inner_(filled<std::uint8_t>(vertices, 1, progress)),
      triangles_(triangles.size()) {
  sides_.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % kItemsBetweenChecks == 0) progress.check();
    for (const std::uint32_t v : triangles[t]) {
      first_[v] = static_cast<Corner>(sides_.size());
      sides_.push_back({v, kNone});
    }
  }
  pair_corners(progress);
  find_inner(progress);
}

void CornerTable::pair_corners(const Progress& progress) {
  // Sort the corners by the lower vertex of the opposite edge, by counting. `end[v]` is the end of the corners of v.
  const std::size_t corners = sides_.size();
  const auto lower = [&](Corner c) { return std::min(sides_[next(c)].vertex, sides_[previous(c)].vertex); };
  const auto upper = [&](Corner c) { return std::max(sides_[next(c)].vertex, sides_[previous(c)].vertex); };
  std::vector<std::uint32_t> end = filled<std::uint32_t>(vertex_count() + 1, 0, progress);
  for (Corner c = 0; c < corners; ++c) {
    if (c % kItemsBetweenChecks == 0) progress.check();
    ++end[lower(c) + 1];
  }
  for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
  std::vector<Corner> sorted = filled(corners, kNone, progress);
  for (Corner c = 0; c < corners; ++c) {
    if (c % kItemsBetweenChecks == 0) progress.check();
    sorted[end[lower(c)]++] = c;
  }

  // Pair corners that have the edge in opposite directions. All other edges keep their ends in place.
  std::size_t begin = 0;
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    if (v % kItemsBetweenChecks == 0) progress.check();
    const std::span<Corner> around(sorted.data() + begin, end[v] - begin);
    begin = end[v];
    std::sort(around.begin(), around.end(),
              [&](Corner a, Corner b) { return std::pair(upper(a), a) < std::pair(upper(b), b); });
    for (std::size_t i = 0; i < around.size();) {
      std::size_t last = i + 1;
      while (last < around.size() && upper(around[last]) == upper(around[i])) ++last;
      const bool is_pair = last - i == 2 && sides_[next(around[i])].vertex == sides_[previous(around[i + 1])].vertex &&
                           sides_[next(around[i])].vertex != sides_[previous(around[i])].vertex;
      if (is_pair) {
        sides_[around[i]].opposite = around[i + 1];
        sides_[around[i + 1]].opposite = around[i];
      } else {
        inner_[v] = 0;
        inner_[upper(around[i])] = 0;
      }
      i = last;
    }
  }
}

void CornerTable::find_inner(const Progress& progress) {
  std::vector<std::uint32_t> unmet = filled<std::uint32_t>(vertex_count(), 0, progress);
  for (std::size_t c = 0; c < sides_.size(); ++c) {
    if (c % kItemsBetweenChecks == 0) progress.check();
    ++unmet[sides_[c].vertex];
  }
  for (std::uint32_t v = 0; v < vertex_count(); ++v) {
    if (v % kItemsBetweenChecks == 0) progress.check();
    if (first_[v] == kNone) inner_[v] = 0;
    if (inner_[v] == 0) continue;
    Corner c = first_[v];
    do {
      --unmet[v];
      c = turn(c);
    } while (c != first_[v]);
    if (unmet[v] != 0) inner_[v] = 0;
  }
}

void CornerTable::collapse(Corner c) {
  const std::uint32_t kept = sides_[c].vertex;
  const Corner gone = next(c);
  const Corner beyond = sides_[previous(c)].opposite;  // its next corner is at the kept vertex, its previous corner at
                                                       // the other one
  for (Corner around = turn(gone); around != gone; around = turn(around)) sides_[around].vertex = kept;
  first_[sides_[gone].vertex] = kNone;
  sides_[gone].vertex = kept;
  remove_triangle(c, gone);
  remove_triangle(previous(beyond), next(beyond));
}

/// Removes the triangle of two corners whose vertices became one. The triangles beyond its other edges become
/// neighbours.
void CornerTable::remove_triangle(Corner a, Corner b) {
  const std::array<Corner, 2> outer{sides_[a].opposite, sides_[b].opposite};
  for (int k = 0; k < 2; ++k) {
    sides_[outer[k]].opposite = outer[1 - k];
    for (const Corner c : {next(outer[k]), previous(outer[k])}) first_[sides_[c].vertex] = c;
  }
  const Corner first = a - a % 3;
  for (Corner corner = first; corner < first + 3; ++corner) sides_[corner].vertex = kNone;
  --triangles_;
}

}  // namespace meristem
