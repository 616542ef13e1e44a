// SPDX-License-Identifier: Apache-2.0
// From a skeleton to closed tubes, one an axis. Two passes: the first counts each axis's rings, so that every axis
// knows where in the arrays it writes; the second writes all axes side by side.
//
// A ring lies in its node's mitre plane, at right angles to the middle of the two directions that meet there. A frame
// reflected at that plane passes from one segment to the next with no turn about either: the exact parallel transport
// of a polyline, which the double reflection approximates between samples of a curve. A bend too sharp for one mitre
// gets a fan of rings about its node. On the inner side of a bend rings reach back no farther than their segments let
// them, so that neighbours never cross.
//
// Deliberately left to others: smoothing of the axis (plant/finish.h), and blending of forks.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 3.6.1 (equation 3.26 holds for the interior angle); W. Wang et al., Computation of rotation minimizing
// frames, 2008; M. Bergou et al., Discrete elastic rods, 2008, section 4.2.2 (transport along edges).
#include "meristem/shape/tubes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr float kThinnest = 1e-6F;                   // metres: thinner tubes would have degenerate triangles
constexpr float kCosSharpestMitre = 0.25881905F;     // 75 degrees
constexpr float kCosSharpestFanOfTwo = -0.8660254F;  // 150 degrees
constexpr float kInnerReach = 0.45F;                 // of the shorter segment; two neighbours leave a tenth of it free
constexpr float kFanSpacing = 0.05F;                 // between a fan's rings, in radii
constexpr float kHidden = 0.95F;     // of the mother's inner radius that a lateral's first ring may fill
constexpr float kStartDepth = 0.5F;  // how far a lateral's closed start reaches back, in radii
constexpr std::size_t kAxesPerBlock = 64;
constexpr std::size_t kRingsPerCheck = 4096;

struct Turn {
  float cosine, sine;
};

/// As normalized_or, but in floats: it is asked for a million times a tree.
Vec3 unit_or(Vec3 vector, Vec3 fallback) {
  const float square = glm::dot(vector, vector);
  return square > 1e-24F && square < 1e24F ? vector * (1 / std::sqrt(square)) : fallback;
}

/// The points of an axis from its start to its tip: its nodes, after the mother node if there is one.
struct AxisPath {
  const Skeleton* skeleton = nullptr;
  std::span<const NodeIndex> nodes;
  NodeIndex mother = kNoNode;

  bool is_lateral() const { return mother != kNoNode; }
  std::size_t size() const { return nodes.empty() ? 0 : nodes.size() + (is_lateral() ? 1 : 0); }
  /// The node at point i; 0 is the mother of a lateral axis.
  NodeIndex node(std::size_t i) const { return is_lateral() ? (i == 0 ? mother : nodes[i - 1]) : nodes[i]; }
  Vec3 position(std::size_t i) const { return skeleton->position[node(i)]; }
  float radius(std::size_t i) const { return std::max(skeleton->radius[node(i)], kThinnest); }
  float base_radius() const { return std::max(skeleton->radius[nodes[0]], kThinnest); }
  /// The direction from point i to the next, or `fallback` where they coincide.
  Vec3 direction(std::size_t i, Vec3 fallback) const { return unit_or(position(i + 1) - position(i), fallback); }
};

/// What one axis becomes, and where it stands in the mesh.
struct AxisPlan {
  std::uint32_t sides = 0;
  std::uint32_t rings = 0;
  float start_radius = 0;
  std::uint64_t first_vertex = 0;
  std::uint64_t first_triangle = 0;

  // A lateral's start is one hidden point; a root's is a flat disc with vertices of its own. A tip has a point a side.
  std::uint64_t start_vertices(bool is_lateral) const { return is_lateral ? 1 : sides + 1; }
  std::uint64_t vertices(bool is_lateral) const {
    return rings == 0 ? 0 : std::uint64_t{rings} * (sides + 1) + start_vertices(is_lateral) + sides;
  }
  std::uint64_t triangles() const { return rings == 0 ? 0 : 2 * std::uint64_t{sides} * rings; }
};

/// How many rings share a bend with this cosine.
std::uint32_t fan_size(float cosine) {
  return cosine >= kCosSharpestMitre ? 1 : cosine >= kCosSharpestFanOfTwo ? 2 : 3;
}

/// All axes of a skeleton with their places in the mesh.
class TubePlan {
 public:
  TubePlan(const Skeleton& skeleton, const Surface& surface) : skeleton_(skeleton), axes_(skeleton) {
    most_sides_ = std::max(3, surface.sides);
    for (const float radius : skeleton.radius) thickest_ = std::max(thickest_, radius);
    plans_.resize(axes_.count());
    // Sides first: how much of a lateral its mother hides depends on hers.
    parallel_for(plans_.size(), kAxesPerBlock, [this](std::size_t begin, std::size_t end) {
      for (std::size_t axis = begin; axis < end; ++axis) choose_sides(static_cast<AxisIndex>(axis));
    });
    parallel_for(plans_.size(), kAxesPerBlock, [this](std::size_t begin, std::size_t end) {
      for (std::size_t axis = begin; axis < end; ++axis) count_rings(static_cast<AxisIndex>(axis));
    });
    for (std::size_t axis = 0; axis < plans_.size(); ++axis) {
      plans_[axis].first_vertex = size_.vertices;
      plans_[axis].first_triangle = size_.triangles;
      size_.vertices += plans_[axis].vertices(path(static_cast<AxisIndex>(axis)).is_lateral());
      size_.triangles += plans_[axis].triangles();
    }
  }

  TubeSize size() const { return size_; }
  std::size_t axis_count() const { return plans_.size(); }
  int most_sides() const { return most_sides_; }
  const AxisPlan& operator[](std::size_t axis) const { return plans_[axis]; }

  AxisPath path(AxisIndex axis) const {
    const std::span<const NodeIndex> nodes = axes_.of(axis);
    return {&skeleton_, nodes, nodes.empty() ? kNoNode : skeleton_.parent[nodes[0]]};
  }

 private:
  void choose_sides(AxisIndex axis) {
    const AxisPath points = path(axis);
    if (points.size() == 0) return;
    const double share = thickest_ > 0 ? math::pow(std::min(1.0F, points.base_radius() / thickest_), 1.0 / 3) : 0;
    plans_[axis].sides = static_cast<std::uint32_t>(std::max(3.0, std::floor(most_sides_ * share + 0.5)));
  }

  void count_rings(AxisIndex axis) {
    const AxisPath points = path(axis);
    if (points.size() < 2) return;
    AxisPlan& plan = plans_[axis];
    plan.start_radius = points.base_radius();
    if (points.is_lateral()) plan.start_radius = std::min(plan.start_radius, room_inside(points.mother));
    plan.rings = 2;
    Vec3 before = points.direction(0, kUp);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Vec3 after = points.direction(i, before);
      plan.rings += fan_size(glm::dot(before, after));
      before = after;
    }
  }

  /// The radius of the largest disc about a node that its tube hides however the disc is turned.
  float room_inside(NodeIndex node) const {
    const std::span<const NodeIndex> nodes = axes_.of(skeleton_.axis[node]);
    const float radius = std::max(skeleton_.radius[node], kThinnest);
    // The flats of the tube are nearer than its corners, and where it tapers the nearest point lies ahead.
    const double flat = math::cos(kPi / plans_[skeleton_.axis[node]].sides);
    const auto next = std::upper_bound(nodes.begin(), nodes.end(), node);
    double taper = 0;
    if (next != nodes.end()) {
      const float length = glm::distance(skeleton_.position[*next], skeleton_.position[node]);
      taper = std::max(0.0F, radius - skeleton_.radius[*next]) / std::max(length, kThinnest);
    }
    return static_cast<float>(kHidden * radius * flat / std::sqrt(1 + taper * taper));
  }

  const Skeleton& skeleton_;
  Axes axes_;
  int most_sides_ = 3;
  float thickest_ = 0;
  std::vector<AxisPlan> plans_;
  TubeSize size_;
};

/// Cosines and sines of the corners of polygons with 3 to `most` sides; the last corner is the first once more.
class CornerTable {
 public:
  explicit CornerTable(int most) {
    for (int sides = 3; sides <= most; ++sides) {
      first_.push_back(turns_.size());
      for (int k = 0; k <= sides; ++k) {
        const double angle = 2 * kPi * (k % sides) / sides;
        turns_.push_back({static_cast<float>(math::cos(angle)), static_cast<float>(math::sin(angle))});
      }
    }
  }
  std::span<const Turn> of(std::uint32_t sides) const {
    return std::span(turns_).subspan(first_[sides - 3], sides + 1);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Turn> turns_;
};

/// How a ring lies between the segment before it and the one after.
struct Mitre {
  Vec3 before, after;       // directions of the segments
  Vec3 across;              // normal of the ring's plane, halfway between them
  Vec3 outer{0}, inner{0};  // towards the outside of the bend: in the ring's plane, and in that of the whole bend
  float outer_stretch = 1;  // of the radius towards the outside
  float inner_stretch = 1;  // and the inside
  float half_cosine = 1;    // of half the angle between before and after

  explicit Mitre(Vec3 straight) : before(straight), after(straight), across(straight) {}
  Mitre(Vec3 before_, Vec3 after_, Vec3 across_, Vec3 outer_) : before(before_), after(after_), across(across_) {
    outer = inner = outer_;
    half_cosine = glm::dot(before, across);
    outer_stretch = inner_stretch = 1 / half_cosine;
  }
};

/// Writes one axis into its place.
class AxisMesher {
 public:
  AxisMesher(const AxisPath& path, const AxisPlan& plan, std::span<const Turn> corners, double uv_scale, Mesh& mesh)
      : path_(path), plan_(plan), corners_(corners), mesh_(mesh) {
    next_vertex_ = static_cast<std::uint32_t>(plan.first_vertex);
    next_triangle_ = plan.first_triangle;
    const double around = 2 * kPi * path.base_radius();
    tiles_ = static_cast<float>(std::max(1.0, std::floor(around / uv_scale + 0.5)));
  }

  void run(const Progress& progress) {
    Vec3 before = path_.direction(0, kUp);
    x_ = any_perpendicular(before);
    start(before);
    const std::size_t last = path_.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
      const Vec3 after = path_.direction(i, before);
      advance_v(i);
      bend(i, before, after);
      before = after;
      if (i % kRingsPerCheck == 0) progress.check();
    }
    advance_v(last);
    finish(before);
    assert(next_triangle_ == plan_.first_triangle + plan_.triangles());
    assert(next_vertex_ == plan_.first_vertex + plan_.vertices(path_.is_lateral()));
  }

 private:
  float radius(std::size_t i) const { return i == 0 ? plan_.start_radius : path_.radius(i); }
  float length(std::size_t i) const { return glm::distance(path_.position(i), path_.position(i + 1)); }
  /// The radius's growth a metre from point i to the next.
  float slope(std::size_t i) const { return (radius(i + 1) - radius(i)) / std::max(length(i), kThinnest); }
  /// v of a metre along the tube where it has this radius; equal to u of a metre around it.
  float tiles_per_metre(float at_radius) const { return tiles_ / (static_cast<float>(2 * kPi) * at_radius); }

  void advance_v(std::size_t i) { v_ += length(i - 1) * tiles_per_metre(0.5F * (radius(i - 1) + radius(i))); }

  /// The closed start: for a lateral a point behind its first ring, inside the mother; else a disc.
  void start(Vec3 direction) {
    const Vec3 centre = path_.position(0);
    if (path_.is_lateral()) {
      const std::uint32_t point = add_vertex(centre - kStartDepth * radius(0) * direction, -direction, {0.5F, 0});
      close_start(point);
      ring(centre, radius(0), Mitre(direction), 1 / kStartDepth, slope(0));
      return;
    }
    const float scale = radius(0) * tiles_per_metre(radius(0));
    const std::uint32_t middle = add_vertex(centre, -direction, {0, 0});
    close_start(middle);
    next_vertex_ += plan_.sides;
    ring(centre, radius(0), Mitre(direction), slope(0), slope(0));
    // The disc's rim is the ring once more, with the disc's own normal and uvs.
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      const std::uint32_t vertex = middle + 1 + k;
      mesh_.positions[vertex] = mesh_.positions[vertex + plan_.sides];
      mesh_.normals[vertex] = -direction;
      mesh_.uvs[vertex] = {-scale * corners_[k].cosine, scale * corners_[k].sine};
    }
  }

  /// Triangles between a point and the rim about it that is written next.
  void close_start(std::uint32_t point) {
    const std::uint32_t rim = next_vertex_;
    // A lateral's rim is its first ring; there the last corner is the first once more.
    const std::uint32_t sides = plan_.sides;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t next = path_.is_lateral() ? k + 1 : (k + 1) % sides;
      add_triangle(point, rim + next, rim + k);
    }
  }

  /// The ring or rings at an inner point.
  void bend(std::size_t i, Vec3 before, Vec3 after) {
    const float cosine = glm::dot(before, after);
    const std::uint32_t count = fan_size(cosine);
    if (count > 1) return fan(i, before, after, count);
    const Vec3 outer = unit_or(before - after, Vec3(0));
    Mitre mitre(before, after, glm::normalize(before + after), outer);
    mitre.inner_stretch = inner_stretch(i, mitre.half_cosine);
    ring(path_.position(i), radius(i), mitre, slope(i - 1), slope(i));
    join();
  }

  /// A sharp bend in equal parts: rings about one point, set a little apart so that no two of their vertices coincide.
  void fan(std::size_t i, Vec3 before, Vec3 after, std::uint32_t count) {
    const Vec3 hinge = unit_or(glm::cross(before, after), any_perpendicular(before));
    const Vec3 side = glm::cross(hinge, before);
    const double angle = math::atan2(glm::dot(after, side), glm::dot(after, before));
    const auto turned = [&](double share) {
      return static_cast<float>(math::cos(share * angle)) * before +
             static_cast<float>(math::sin(share * angle)) * side;
    };
    const Vec3 middle = turned(0.5);
    const float reach = inner_stretch(i, static_cast<float>(math::cos(0.5 * angle)));
    const double part = 1.0 / count;
    for (std::uint32_t j = 0; j < count; ++j) {
      const Vec3 across = turned((j + 0.5) * part);
      Mitre mitre(turned(j * part), j + 1 == count ? after : turned((j + 1) * part), across, glm::cross(across, hinge));
      mitre.inner = glm::cross(middle, hinge);
      mitre.inner_stretch = reach;
      const float shift = (static_cast<float>(j) - 0.5F * static_cast<float>(count - 1)) * kFanSpacing * radius(i);
      ring(path_.position(i) + shift * middle, radius(i), mitre, j == 0 ? slope(i - 1) : 0,
           j + 1 == count ? slope(i) : 0);
      join();
      // The middle of the tube stands still here, its outside turns by the part's angle.
      if (j + 1 < count) v_ += 0.5F * static_cast<float>(angle * part) * tiles_ / static_cast<float>(2 * kPi);
    }
  }

  /// How far a ring may reach towards the inside of its bend, in radii: to the mitre, unless a segment is too short.
  float inner_stretch(std::size_t i, float half_cosine) const {
    const float half_sine = std::sqrt(std::max(0.0F, 1 - half_cosine * half_cosine));
    const float room = kInnerReach * std::min(length(i - 1), length(i));
    const float mitre = 1 / std::max(half_cosine, kCosSharpestMitre);
    return room < mitre * radius(i) * half_sine ? room / (radius(i) * half_sine) : mitre;
  }

  /// The last ring and a cone as high as it is wide.
  void finish(Vec3 direction) {
    const std::size_t last = path_.size() - 1;
    const float height = radius(last);
    ring(path_.position(last), height, Mitre(direction), slope(last - 1), -1);
    join();
    const std::uint32_t rim = next_vertex_ - plan_.sides - 1;
    const Vec3 tip = path_.position(last) + height * direction;
    const float tip_v = v_ + height * static_cast<float>(std::sqrt(2.0)) * tiles_per_metre(height);
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      const float u = tiles_ * (static_cast<float>(k) + 0.5F) / static_cast<float>(plan_.sides);
      add_triangle(rim + k, rim + k + 1, add_vertex(tip, direction, {u, tip_v}));
    }
  }

  /// Writes a ring and carries the frame across it. The slopes are those of the radius before and after.
  void ring(Vec3 centre, float ring_radius, const Mitre& mitre, float slope_before, float slope_after) {
    const Vec3 y = glm::cross(mitre.before, x_);
    const float weight_before = 1 / std::sqrt(1 + slope_before * slope_before);
    const float weight_after = 1 / std::sqrt(1 + slope_after * slope_after);
    const Vec3 taper = weight_before * slope_before * mitre.before + weight_after * slope_after * mitre.after;
    const float du = tiles_ / static_cast<float>(plan_.sides);
    for (std::uint32_t k = 0; k <= plan_.sides; ++k) {
      const Vec3 out = corners_[k].cosine * x_ + corners_[k].sine * y;
      const float along = glm::dot(out, mitre.across);
      const float outward = glm::dot(out, mitre.outer);
      // What lies along the hinge stays; what lies across it is laid into the mitre plane.
      Vec3 offset = out - along * mitre.across - outward * mitre.outer;
      const float level = outward / mitre.half_cosine;
      offset += level > 0 ? level * mitre.outer_stretch * mitre.outer : level * mitre.inner_stretch * mitre.inner;
      const Vec3 reflected = out - 2 * along * mitre.across;
      const Vec3 normal = glm::normalize(weight_before * out + weight_after * reflected - taper);
      add_vertex(centre + ring_radius * offset, normal, {static_cast<float>(k) * du, v_});
    }
    x_ -= 2 * glm::dot(x_, mitre.across) * mitre.across;
    x_ = glm::normalize(x_ - glm::dot(x_, mitre.after) * mitre.after);
  }

  /// Joins the last two rings.
  void join() {
    const std::uint32_t stride = plan_.sides + 1;
    const std::uint32_t upper = next_vertex_ - stride;
    const std::uint32_t lower = upper - stride;
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      add_triangle(lower + k, lower + k + 1, upper + k + 1);
      add_triangle(lower + k, upper + k + 1, upper + k);
    }
  }

  std::uint32_t add_vertex(Vec3 position, Vec3 normal, Vec2 uv) {
    mesh_.positions[next_vertex_] = position;
    mesh_.normals[next_vertex_] = normal;
    mesh_.uvs[next_vertex_] = uv;
    return next_vertex_++;
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles[next_triangle_++] = {a, b, c};
  }

  const AxisPath& path_;
  const AxisPlan& plan_;
  std::span<const Turn> corners_;
  Mesh& mesh_;
  std::uint32_t next_vertex_ = 0;
  std::uint64_t next_triangle_ = 0;
  Vec3 x_{0};  // the first corner's direction, at right angles to the segment before the next ring
  float tiles_ = 1;
  float v_ = 0;
};

}  // namespace

TubeSize measure_tubes(const Skeleton& skeleton, const Surface& surface) { return TubePlan(skeleton, surface).size(); }

Mesh make_tubes(const Skeleton& skeleton, const Surface& surface, Progress& progress) {
  if (!(surface.uv_scale > 0)) throw std::invalid_argument("a surface's uv_scale is above 0");
  // Give every axis its place.
  const TubePlan plan(skeleton, surface);
  const TubeSize size = plan.size();
  if (size.vertices > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("a mesh has at most 2^32 vertices");
  }
  Mesh mesh;
  mesh.positions.resize(size.vertices);
  mesh.normals.resize(size.vertices);
  mesh.uvs.resize(size.vertices);
  mesh.triangles.resize(size.triangles);
  // Let every axis fill it.
  const CornerTable corners(plan.most_sides());
  parallel_for(plan.axis_count(), kAxesPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) {
      const AxisPath path = plan.path(static_cast<AxisIndex>(axis));
      if (plan[axis].rings > 0) {
        AxisMesher(path, plan[axis], corners.of(plan[axis].sides), surface.uv_scale, mesh).run(progress);
      }
      progress.advance(path.nodes.size());
    }
  });
  return mesh;
}

}  // namespace meristem
