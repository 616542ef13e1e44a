// SPDX-License-Identifier: Apache-2.0
// In: some thousand triangles between common points. Out: fewer triangles whose outlines from all sides cover nearly
// equal pixels. In each step, the cheapest of all changes is applied: a point collapses onto a neighbour, or a small
// piece is removed. The cost is the number of changed pixels of the plant's outlines and of the groups' own outlines. A
// small part is added for the distance from the planes of the first faces. Between two equal outlines, the rounder body
// therefore stays. Pixels are compared with the first outlines and not with the step before, so errors do not add up.
// The number of faces over each pixel is counted, so the cost of a step depends on what it touches.
//
// Bodies with tunnels need not stay manifold, because a tunnel may become a line. If this is forbidden, crowns with
// tunnels keep invisible faces and lose their shape. Level 2 of a low-poly oak then shared 58 % of its outline, and
// shares 90 % now. Bodies without tunnels keep their connections, since otherwise some of their faces could look
// inward.
//
// Based on: P. Lindstrom, G. Turk: Image-driven simplification (2000). Here outlines replace shaded pictures, because a
// level of detail keeps its materials.
#include "meristem/shape/outline/outline_collapse.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/mesh/quadric.h"
#include "meristem/shape/outline/outline.h"
#include "meristem/shape/outline/outline_raster.h"

namespace meristem {

namespace {

constexpr int kViews = 20;
constexpr int kSize = 96;              // in pixels
constexpr double kGroupWeight = 0.15;  // weight of a group's outline; other groups may hide much of it
constexpr double kShapeWeight = 0.08;  // weight of the volume between old and new faces; more keeps bodies rounder, but
                                       // outlines suffer
constexpr double kMinFaceCosine = 0.2;    // minimum cosine of the angle that a face may turn at once
constexpr std::size_t kTriedTargets = 5;  // number of a point's neighbours that are tried, the nearest to its planes
constexpr std::size_t kFewFaces = 8;      // maximum number of faces that are removed at once
constexpr int kFitRounds = 4;
constexpr std::array kLastReaches = {0.2, 0.08, 0.2, 0.08, 0.2, 0.08};  // share of edges: maximum moves of points at
                                                                        // the end
constexpr double kMinViewWeight = 0.5;  // minimum weight of a view that fits well; lower values harm the directions
                                        // between views
constexpr double kMaxViewWeight = 2;
constexpr double kStage = 0.6;     // share of the faces that remain after a stage; points also move between stages
constexpr double kMinGain = 1e-7;  // share of the whole outline: minimum gain that justifies moving a point
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr double kInfiniteCost = std::numeric_limits<double>::infinity();

/// Pixels of one view that a step would change.
struct Scratch {
  std::vector<std::int16_t> delta = std::vector<std::int16_t>(kSize * kSize);
  std::vector<std::uint32_t> touched;
};

struct Step {
  double cost = kInfiniteCost;
  std::uint32_t to = kNone;  // kNone: the whole piece is removed
  bool is_stale = false;
};

}  // namespace

class OutlineCollapse::State {
 public:
  State(FaceSoup soup, Progress& progress) : soup_(std::move(soup)) {
    find_neighbours();
    find_tunnels();
    choose_views();
    draw_reference(progress);
    add_planes();
    left_ = soup_.faces.size();
    is_gone_.resize(left_);
    steps_.resize(soup_.points.size());
    parallel_for(steps_.size(), 64, [&](std::size_t begin, std::size_t end) {
      progress.check();
      Scratch scratch;
      for (std::size_t k = begin; k < end; ++k) steps_[k] = best_step(static_cast<std::uint32_t>(k), scratch);
    });
  }

  void run(std::size_t faces, Progress& progress) {
    bool can_go_on = true;
    while (left_ > faces && can_go_on) {
      const auto stage = std::max(faces, static_cast<std::size_t>(kStage * static_cast<double>(left_)));
      while (left_ > stage) {
        progress.check();
        const std::uint32_t point = cheapest();
        can_go_on = point != kNone;
        if (!can_go_on) break;
        take(point);
      }
      fit(progress);
    }
    fit_worst_views(progress);
  }

  std::size_t face_count() const { return left_; }

  FaceSoup left() const {
    FaceSoup soup = soup_;
    soup.faces.clear();
    for (std::size_t k = 0; k < soup_.faces.size(); ++k) {
      if (is_gone_[k] == 0) soup.faces.push_back(soup_.faces[k]);
    }
    return soup;
  }

 private:
  using Face = FaceSoup::Face;

  void find_neighbours() {
    around_.resize(soup_.points.size());
    std::uint32_t groups = 0;
    for (std::uint32_t f = 0; f < soup_.faces.size(); ++f) {
      for (const std::uint32_t point : soup_.faces[f].points) around_[point].push_back(f);
      groups = std::max(groups, soup_.faces[f].group + 1);
    }
    planes_ = 1 + std::size_t{groups};
    for (const Face& face : soup_.faces) first_.push_back(area_vector(face));
  }

  /// Marks the points of pieces that have a tunnel: points minus edges plus faces is at most 0.
  void find_tunnels() {
    std::vector<std::uint32_t> piece(soup_.points.size());
    std::iota(piece.begin(), piece.end(), 0U);
    const auto root = [&](std::uint32_t point) {
      while (piece[point] != point) point = piece[point] = piece[piece[point]];
      return point;
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Face& face : soup_.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        edges.push_back(std::minmax(face.points[k], face.points[(k + 1) % 3]));
        piece[root(face.points[k])] = root(face.points[(k + 1) % 3]);
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::int64_t> characteristic(soup_.points.size(), 0);
    for (std::uint32_t point = 0; point < soup_.points.size(); ++point) {
      if (!around_[point].empty()) ++characteristic[root(point)];
    }
    for (const auto& edge : edges) --characteristic[root(edge.first)];
    for (const Face& face : soup_.faces) ++characteristic[root(face.points[0])];
    has_tunnel_.resize(soup_.points.size());
    for (std::uint32_t point = 0; point < soup_.points.size(); ++point) {
      has_tunnel_[point] = characteristic[root(point)] <= 0 ? 1 : 0;
    }
  }

  void choose_views() {
    for (const Face& face : soup_.faces) {
      for (const std::uint32_t point : face.points) box_.add(soup_.points[point]);
    }
    radius_ = std::max(0.5 * static_cast<double>(glm::length(box_.size())), 1e-9);
    for (const Vec3 direction : outline_directions(kViews)) {
      views_.push_back(view_along(direction, DVec3(box_.centre()), 0.5 * kSize / (1.05 * radius_), kSize));
    }
  }

  std::uint16_t& count(std::size_t view, std::size_t plane, std::uint32_t pixel) {
    return counts_[(view * planes_ + plane) * kSize * kSize + pixel];
  }
  std::uint16_t count(std::size_t view, std::size_t plane, std::uint32_t pixel) const {
    return counts_[(view * planes_ + plane) * kSize * kSize + pixel];
  }

  void add_face(std::size_t view, const Face& face, int by) {
    glm::dvec2 corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = views_[view].pixel(soup_.points[face.points[k]]);
    cover_triangle(corners[0], corners[1], corners[2], kSize, [&](int row, int first, int end) {
      for (int x = first; x < end; ++x) {
        const auto pixel = static_cast<std::uint32_t>(row * kSize + x);
        for (const std::size_t plane : {std::size_t{0}, 1 + std::size_t{face.group}}) {
          std::uint16_t& covered = count(view, plane, pixel);
          covered = static_cast<std::uint16_t>(covered + by);
        }
      }
    });
  }

  void draw_reference(Progress& progress) {
    counts_.resize(views_.size() * planes_ * kSize * kSize);
    parallel_for(views_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t view = begin; view < end; ++view) {
        progress.check();
        for (const Face& face : soup_.faces) add_face(view, face, 1);
      }
    });
    is_wanted_.resize(counts_.size());
    std::vector<std::uint64_t> covered(views_.size());
    std::uint64_t all = 0;
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      is_wanted_[k] = counts_[k] > 0 ? 1 : 0;
      const std::size_t picture = k / (kSize * kSize);
      if (picture % planes_ == 0) covered[picture / planes_] += is_wanted_[k];
    }
    for (const std::uint64_t pixels : covered) {
      const double whole = std::max<double>(1, static_cast<double>(pixels));
      pixel_share_.push_back(1 / (whole * static_cast<double>(views_.size())));
      all += pixels;
    }
    const double across = 2 * 1.05 * radius_ / kSize;
    area_ = std::max<double>(1, static_cast<double>(all)) / static_cast<double>(views_.size()) * across * across;
  }

  DVec3 area_vector(const Face& face) const { return area_vector(face.points, kNone, Vec3(0)); }

  /// Returns twice the area vector of a face with one of its points moved.
  DVec3 area_vector(const std::array<std::uint32_t, 3>& points, std::uint32_t moved, Vec3 elsewhere) const {
    DVec3 at[3];
    for (std::size_t k = 0; k < 3; ++k) at[k] = DVec3(points[k] == moved ? elsewhere : soup_.points[points[k]]);
    return glm::cross(at[1] - at[0], at[2] - at[0]);
  }

  void add_planes() {
    quadrics_.resize(soup_.points.size());
    for (const Face& face : soup_.faces) {
      const DVec3 doubled = area_vector(face);
      const double length = glm::length(doubled);
      if (!(length > 0)) continue;
      const DVec3 normal = (1 / length) * doubled;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = face.points[k];
        const std::uint32_t to = face.points[(k + 1) % 3];
        const DVec3 position(soup_.points[from]);
        quadrics_[from].add_plane(normal, position, length);
        if (shared_faces(from, to) != 1) continue;
        const DVec3 along = DVec3(soup_.points[to]) - position;
        const double square = glm::dot(along, along);
        if (!(square > 0)) continue;
        const DVec3 outward = glm::cross(along, normal) * (1 / std::sqrt(square));
        quadrics_[from].add_plane(outward, position, 0.25 * square);
        quadrics_[to].add_plane(outward, position, 0.25 * square);
      }
    }
  }

  static bool has(const Face& face, std::uint32_t point) {
    return face.points[0] == point || face.points[1] == point || face.points[2] == point;
  }

  std::size_t shared_faces(std::uint32_t a, std::uint32_t b) const {
    return static_cast<std::size_t>(
        std::count_if(around_[a].begin(), around_[a].end(), [&](std::uint32_t f) { return has(soup_.faces[f], b); }));
  }

  std::vector<std::uint32_t> neighbours(std::uint32_t point) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t f : around_[point]) {
      for (const std::uint32_t other : soup_.faces[f].points) {
        if (other != point) found.push_back(other);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Returns the faces that are connected with a point, if they are few.
  std::vector<std::uint32_t> small_piece(std::uint32_t point) const {
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> points{point};
    for (std::size_t k = 0; k < points.size(); ++k) {
      for (const std::uint32_t f : around_[points[k]]) {
        if (std::find(faces.begin(), faces.end(), f) != faces.end()) continue;
        if (faces.size() == kFewFaces) return {};
        faces.push_back(f);
        for (const std::uint32_t other : soup_.faces[f].points) {
          if (std::find(points.begin(), points.end(), other) == points.end()) points.push_back(other);
        }
      }
    }
    return faces;
  }

  /// Returns the cost of a volume between faces, as a share of the plant's.
  double shape_cost(double volume) const { return kShapeWeight * volume / (area_ * radius_); }

  double volume_of(const Quadric& quadric, Vec3 at) const {
    return std::sqrt(quadric.at(DVec3(at)) * quadric.weight()) / 6;
  }

  /// Returns the increase of the outlines' error, as a share of the whole outline, if the point `moved` is replaced by
  /// a point at `target`, where the point `onto` is. Faces in `faces` that keep three points move, and the others are
  /// removed.
  double outline_cost(const std::vector<std::uint32_t>& faces, std::uint32_t moved, std::uint32_t onto, Vec3 target,
                      Scratch& scratch) const {
    if (faces.empty()) return 0;
    const std::size_t group = 1 + std::size_t{soup_.faces[faces[0]].group};
    double worse = 0;
    for (std::size_t view = 0; view < views_.size(); ++view) {
      scratch.touched.clear();
      for (const std::uint32_t f : faces) {
        const Face& face = soup_.faces[f];
        mark(view, face, kNone, target, -1, scratch);
        if (moved != kNone && (onto == kNone || !has(face, onto))) mark(view, face, moved, target, 1, scratch);
      }
      int whole = 0;
      int own = 0;
      for (const std::uint32_t pixel : scratch.touched) {
        const int delta = scratch.delta[pixel];
        scratch.delta[pixel] = 0;
        if (delta == 0) continue;
        whole += change(view, 0, pixel, delta);
        own += change(view, group, pixel, delta);
      }
      worse += pixel_share_[view] * (whole + kGroupWeight * own);
    }
    return worse;
  }

  /// Returns 1 if a pixel becomes wrong that is now as in the beginning, -1 if it becomes right again, and 0 otherwise.
  int change(std::size_t view, std::size_t plane, std::uint32_t pixel, int delta) const {
    const int covered = count(view, plane, pixel);
    const bool is_covered = covered > 0;
    const bool would_be = covered + delta > 0;
    if (is_covered == would_be) return 0;
    const bool is_wanted = is_wanted_[(view * planes_ + plane) * kSize * kSize + pixel] != 0;
    return would_be == is_wanted ? -1 : 1;
  }

  void mark(std::size_t view, const Face& face, std::uint32_t moved, Vec3 target, int by, Scratch& scratch) const {
    glm::dvec2 corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t point = face.points[k];
      corners[k] = views_[view].pixel(point == moved ? target : soup_.points[point]);
    }
    cover_triangle(corners[0], corners[1], corners[2], kSize, [&](int row, int first, int end) {
      for (int x = first; x < end; ++x) {
        const auto pixel = static_cast<std::uint32_t>(row * kSize + x);
        scratch.touched.push_back(pixel);
        scratch.delta[pixel] = static_cast<std::int16_t>(scratch.delta[pixel] + by);
      }
    });
  }

  /// Returns true if no face turns over or becomes a line when a point moves. Faces with `onto` are removed and do not
  /// count.
  bool keeps_facing(std::uint32_t point, std::uint32_t onto, Vec3 target) const {
    return std::all_of(around_[point].begin(), around_[point].end(), [&](std::uint32_t f) {
      const Face& face = soup_.faces[f];
      if (onto != kNone && has(face, onto)) return true;
      const DVec3 before = area_vector(face);
      const DVec3 after = area_vector(face.points, point, target);
      const double square = glm::length(after);
      if (!(square > 1e-6 * longest_edge(face, point, target))) return false;
      // Small turns add up: a face that finally looks the opposite way is inside out.
      if (!(glm::dot(first_[f], after) > 0)) return false;
      return glm::dot(before, after) > kMinFaceCosine * glm::length(before) * square;
    });
  }

  /// Returns the squared length of the longest edge.
  double longest_edge(const Face& face, std::uint32_t moved, Vec3 target) const {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = face.points[k];
      const std::uint32_t b = face.points[(k + 1) % 3];
      const DVec3 along = DVec3(a == moved ? target : soup_.points[a]) - DVec3(b == moved ? target : soup_.points[b]);
      longest = std::max(longest, glm::dot(along, along));
    }
    return longest;
  }

  bool may_collapse(std::uint32_t from, std::uint32_t to, const std::vector<std::uint32_t>& near) const {
    if (has_tunnel_[from] == 0) {
      std::vector<std::uint32_t> common;
      const std::vector<std::uint32_t> others = neighbours(to);
      std::set_intersection(near.begin(), near.end(), others.begin(), others.end(), std::back_inserter(common));
      if (common.size() != shared_faces(from, to)) return false;
    }
    return keeps_facing(from, to, soup_.points[to]);
  }

  Step best_step(std::uint32_t from, Scratch& scratch) const {
    Step best;
    if (around_[from].empty()) return best;
    const std::vector<std::uint32_t> near = neighbours(from);
    std::vector<std::pair<double, std::uint32_t>> targets;
    for (const std::uint32_t to : near) {
      Quadric sum = quadrics_[from];
      sum += quadrics_[to];
      targets.emplace_back(volume_of(sum, soup_.points[to]), to);
    }
    std::sort(targets.begin(), targets.end());
    std::size_t tried = 0;
    for (const auto& [volume, to] : targets) {
      if (tried == kTriedTargets) break;
      if (!may_collapse(from, to, near)) continue;
      ++tried;
      const double cost = shape_cost(volume) + outline_cost(around_[from], from, to, soup_.points[to], scratch);
      if (cost < best.cost) best = {cost, to, false};
    }
    const std::vector<std::uint32_t> piece = small_piece(from);
    if (!piece.empty()) {
      double area = 0;
      for (const std::uint32_t f : piece) area += 0.5 * glm::length(area_vector(soup_.faces[f]));
      const double cost = shape_cost(area * std::sqrt(area)) + outline_cost(piece, kNone, kNone, Vec3(0), scratch);
      if (cost < best.cost) best = {cost, kNone, false};
    }
    return best;
  }

  /// Returns the point with the cheapest collapse, or kNone if no point can be removed. Ties go to the lowest index.
  /// Each round updates only the step of the point that looked cheapest. A newly found step is valid, so there is at
  /// most one more round than there are points.
  std::uint32_t cheapest() {
    for (std::size_t round = 0; round <= steps_.size(); ++round) {
      std::uint32_t best = kNone;
      double cost = kInfiniteCost;
      for (std::uint32_t k = 0; k < steps_.size(); ++k) {
        if (steps_[k].cost < cost) {
          cost = steps_[k].cost;
          best = k;
        }
      }
      if (best == kNone || is_good(best)) return best;
      steps_[best] = best_step(best, scratch_);
    }
    return kNone;
  }

  /// Returns true if a point's step is still valid: nothing near it has changed, and the neighbour still exists.
  bool is_good(std::uint32_t point) const {
    const Step& step = steps_[point];
    if (step.is_stale) return false;
    return step.to == kNone ? !small_piece(point).empty() : shared_faces(point, step.to) > 0;
  }

  /// Removes a face from the pictures, or adds it.
  void redraw(std::uint32_t f, int by) {
    for (std::size_t view = 0; view < views_.size(); ++view) add_face(view, soup_.faces[f], by);
  }

  void remove(std::uint32_t f) {
    is_gone_[f] = 1;
    --left_;
    for (const std::uint32_t point : soup_.faces[f].points) std::erase(around_[point], f);
  }

  /// Applies the valid step of a point. At least one face is removed, so there are no more steps than faces.
  void take(std::uint32_t from) {
    const std::uint32_t to = steps_[from].to;
    if (to == kNone) {
      for (const std::uint32_t f : small_piece(from)) {
        redraw(f, -1);
        const auto points = soup_.faces[f].points;
        remove(f);
        for (const std::uint32_t point : points) steps_[point] = {};
      }
      return;
    }
    const std::vector<std::uint32_t> faces = around_[from];
    const std::vector<std::uint32_t> wearing = around_[to];
    for (const std::uint32_t near : neighbours(from)) steps_[near].is_stale = true;
    for (const std::uint32_t f : faces) {
      redraw(f, -1);
      if (has(soup_.faces[f], to)) {
        remove(f);
        continue;
      }
      Face& face = soup_.faces[f];
      for (std::size_t k = 0; k < 3; ++k) {
        if (face.points[k] != from) continue;
        face.points[k] = to;
        face.corners[k] = corner_like(face.corners[k], to, wearing);
      }
      around_[to].push_back(f);
      redraw(f, 1);
    }
    around_[from].clear();
    steps_[from] = {};
    quadrics_[to] += quadrics_[from];
    steps_[to] = best_step(to, scratch_);
    for (const std::uint32_t near : neighbours(to)) {
      // A neighbour that had no step may have one now.
      if (std::isfinite(steps_[near].cost)) {
        steps_[near].is_stale = true;
      } else {
        steps_[near] = best_step(near, scratch_);
      }
    }
  }

  /// Returns the corner at `point` whose attributes (normal, UV, material) are closest to the attributes of `corner`.
  std::uint32_t corner_like(std::uint32_t corner, std::uint32_t point, const std::vector<std::uint32_t>& faces) const {
    std::uint32_t best = corner;
    float nearest = std::numeric_limits<float>::infinity();
    for (const std::uint32_t f : faces) {
      const Face& face = soup_.faces[f];
      for (std::size_t k = 0; k < 3; ++k) {
        if (face.points[k] != point) continue;
        const std::uint32_t other = face.corners[k];
        const float turned = 1 - glm::dot(soup_.corner_normals[corner], soup_.corner_normals[other]);
        const float apart = turned + glm::distance(soup_.corner_uvs[corner], soup_.corner_uvs[other]);
        if (apart < nearest) {
          nearest = apart;
          best = other;
        }
      }
    }
    return best;
  }

  /// Moves points, one after the other, to positions where the outlines fit better.
  void fit(Progress& progress) {
    double reach = 0.35;
    for (int round = 0; round < kFitRounds; ++round, reach *= 0.6) fit_points(reach, progress);
    for (Step& step : steps_) step.is_stale = true;
  }

  void fit_points(double reach, Progress& progress) {
    for (std::uint32_t point = 0; point < soup_.points.size(); ++point) {
      if (around_[point].empty()) continue;
      progress.check();
      fit_point(point, reach);
    }
  }

  /// Moves points so that the worst fitting outlines fit better, since a level is judged by its worst side.
  void fit_worst_views(Progress& progress) {
    const std::vector<double> even = pixel_share_;
    for (const double reach : kLastReaches) {
      weigh_views(even);
      fit_points(reach, progress);
    }
    pixel_share_ = even;
  }

  /// Sets the weight of each view by its error.
  void weigh_views(const std::vector<double>& even) {
    std::vector<double> wrong(views_.size());
    double mean = 0;
    for (std::size_t view = 0; view < views_.size(); ++view) {
      int pixels = 0;
      for (std::uint32_t pixel = 0; pixel < kSize * kSize; ++pixel) {
        const bool is_wanted = is_wanted_[view * planes_ * kSize * kSize + pixel] != 0;
        if (is_wanted != (count(view, 0, pixel) > 0)) ++pixels;
      }
      wrong[view] = pixels * even[view];
      mean += wrong[view] / static_cast<double>(views_.size());
    }
    if (!(mean > 0)) return;
    for (std::size_t view = 0; view < views_.size(); ++view) {
      pixel_share_[view] = even[view] * std::clamp(wrong[view] / mean, kMinViewWeight, kMaxViewWeight);
    }
  }

  void fit_point(std::uint32_t point, double reach) {
    const Vec3 home = soup_.points[point];
    const std::vector<std::uint32_t> near = neighbours(point);
    double edges = 0;
    for (const std::uint32_t other : near) edges += static_cast<double>(glm::distance(home, soup_.points[other]));
    const auto step = static_cast<float>(reach * edges / static_cast<double>(near.size()));
    DVec3 outward(0);
    for (const std::uint32_t f : around_[point]) outward += area_vector(soup_.faces[f]);
    const Vec3 normal = normalized_or(Vec3(outward), Vec3(0, 1, 0));
    const Vec3 aside = any_perpendicular(normal);
    const Vec3 across = glm::cross(normal, aside);
    const double volume = volume_of(quadrics_[point], home);
    double best = -kMinGain;
    Vec3 target = home;
    for (const Vec3 way : {normal, -normal, aside, -aside, across, -across, kUp, -kUp}) {
      const Vec3 there = glm::clamp(home + step * way, box_.low, box_.high);
      if (there == home || !keeps_facing(point, kNone, there)) continue;
      const double cost = shape_cost(volume_of(quadrics_[point], there) - volume) +
                          outline_cost(around_[point], point, kNone, there, scratch_);
      if (cost < best) {
        best = cost;
        target = there;
      }
    }
    if (target == home) return;
    for (const std::uint32_t f : around_[point]) redraw(f, -1);
    soup_.points[point] = target;
    for (const std::uint32_t f : around_[point]) redraw(f, 1);
  }

  FaceSoup soup_;
  std::vector<std::vector<std::uint32_t>> around_;  // faces of each point
  std::vector<DVec3> first_;                        // area vector of each face at the beginning
  std::vector<std::uint8_t> has_tunnel_;            // for each point, whether its piece has a tunnel
  std::vector<Quadric> quadrics_;
  std::vector<std::uint8_t> is_gone_;  // 1 or 0 for each face
  std::vector<Step> steps_;            // the best step of each point
  std::vector<OutlineView> views_;
  std::size_t planes_ = 1;               // pictures of a view: one of all faces, then one of each group
  std::vector<std::uint16_t> counts_;    // number of faces over each pixel, by view, picture, pixel
  std::vector<std::uint8_t> is_wanted_;  // 1 or 0: whether there was a face in the beginning
  Box box_;
  double radius_ = 1;                // metres
  std::vector<double> pixel_share_;  // for each view, the share of a pixel in all outlines, if all outlines count
                                     // equally
  double area_ = 1;                  // mean area of the whole outline, square metres
  std::size_t left_ = 0;
  Scratch scratch_;
};

OutlineCollapse::OutlineCollapse(FaceSoup soup, Progress& progress)
    : state_(std::make_unique<State>(std::move(soup), progress)) {}

OutlineCollapse::~OutlineCollapse() = default;

void OutlineCollapse::run(std::size_t faces, Progress& progress) { state_->run(faces, progress); }

std::size_t OutlineCollapse::face_count() const { return state_->face_count(); }

FaceSoup OutlineCollapse::soup() const { return state_->left(); }

}  // namespace meristem
