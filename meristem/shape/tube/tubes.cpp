// SPDX-License-Identifier: Apache-2.0
// Turns a skeleton into closed tubes, one per axis, in two passes. The first pass counts each axis's rings, so that
// every axis knows its position in the arrays. The second pass writes all axes in parallel.
//
// A ring lies in its node's mitre plane, at right angles to the middle of the two directions that meet there. A frame
// that is reflected at this plane passes from one segment to the next without twist. This is the exact parallel
// transport of a polyline, which double reflection approximates between samples of a curve. A bend too sharp for one
// mitre gets a fan of rings around its node. On the inner side of a bend, rings extend back no farther than their
// segments allow, so neighbouring rings never cross.
//
// A lateral grows out of its parent with a collar (collar.h), and a root flares toward the ground. Axes that are one
// piece of wood, such as a cut leader and the lateral that continues it, are written one after another. The next tube
// begins with the last ring of the tube before, as at a bend of one tube.
//
// Not done here: smoothing of the axis (plant/finish.h).
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 3.6.1 (equation 3.26 holds for the interior angle); W. Wang et al., Computation of rotation minimizing
// frames, 2008; M. Bergou et al., Discrete elastic rods, 2008, section 4.2.2 (transport along edges).
#include "meristem/shape/tube/tubes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/large_memory.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {
namespace {

constexpr float kSharpestMitre = 0.25881905F;  // cosine of half a bend: the sharpest mitre
constexpr float kInnerReach = 0.45F;           // share of the shorter segment; two neighbours leave a tenth of it free
constexpr float kFanSpacing = 0.05F;           // between a fan's rings, in radii
constexpr float kStartDepth = 0.5F;            // how far a lateral's closed start extends back, in radii
constexpr float kInJoint = 0.999F;             // share of a joint's radius, so that two closed bodies share no edges
                                               // there
constexpr float kHiddenFillet = 0.3F;          // share of a fillet that continues below the parent's bark
constexpr std::array<float, AxisPlan::kFlareRings> kFlareShares{0.1F, 0.25F, 0.5F};  // shares of the first segment
constexpr float kSqrt2 = 1.4142135F;
constexpr auto kDomeStep = static_cast<float>(kPi / 2 / (AxisPlan::kDomeRings + 1));  // step along a dome, in radii
constexpr std::size_t kMeshedAxesPerBlock = 64;
constexpr std::size_t kRingsPerCheck = 4096;

struct Turn {
  float cosine, sine;
};

/// Cosines and sines of the corners of polygons with 3 to `max` sides. The last corner repeats the first.
class TurnTable {
 public:
  explicit TurnTable(int max) {
    for (int sides = 3; sides <= max; ++sides) {
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

/// The position of a ring between the segments before and after it.
struct Mitre {
  Vec3 before, after;       // directions of the segments
  Vec3 across;              // normal of the ring's plane, halfway between both directions
  Vec3 outer{0}, inner{0};  // toward the outside of the bend: in the ring's plane, and in the plane of the whole bend
  float outer_stretch = 1;  // factor on the radius toward the outside
  float inner_stretch = 1;  // factor on the radius toward the inside
  float half_cosine = 1;    // cosine of half the angle between before and after

  explicit Mitre(Vec3 straight) : before(straight), after(straight), across(straight) {}
  Mitre(Vec3 before_, Vec3 after_, Vec3 across_, Vec3 outer_) : before(before_), after(after_), across(across_) {
    outer = inner = outer_;
    half_cosine = glm::dot(before, across);
    outer_stretch = inner_stretch = 1 / half_cosine;
  }
};

/// The ring at which one tube continues another.
struct Joint {
  Mitre mitre;
  float slope_before, slope_after;  // slopes of the radius
  Vec3 x;                           // direction of the first corner before the ring
  float tiles, v;
};

/// Writes one axis into its part of the mesh.
class AxisMesher {
 public:
  /// `joint` is the last ring of the axis that this axis succeeds.
  AxisMesher(const TubePlan& tubes, AxisIndex axis, std::span<const Turn> corners, const std::optional<Joint>& joint,
             Mesh& mesh)
      : tubes_(tubes),
        path_(tubes.path(axis)),
        plan_(tubes[axis]),
        surface_(tubes.surface(axis)),
        corners_(corners),
        joint_(joint),
        mesh_(mesh) {
    next_vertex_ = static_cast<std::uint32_t>(plan_.first_vertex);
    next_triangle_ = plan_.first_triangle;
    const double around = 2 * kPi * path_.radius(0);
    tiles_ = static_cast<float>(std::max(1.0, std::floor(around / surface_.uv_scale + 0.5)));
    if (joint_) {
      tiles_ = joint_->tiles;
      v_ = joint_->v;
    }
  }

  /// Returns the joint with the axis that succeeds this one, if there is one.
  std::optional<Joint> run(const Progress& progress) {
    Vec3 before = plan_.collar ? plan_.collar->direction : path_.direction(0, kUp);
    x_ = joint_ ? joint_->x : any_perpendicular(before);
    start(before);
    const std::size_t last = path_.size() - 1;
    for (std::size_t i = plan_.collar ? plan_.collar->next_point : 1; i < last; ++i) {
      const Vec3 after = path_.direction(i, before);
      advance_v(i);
      bend(i, before, after);
      before = after;
      if (i % kRingsPerCheck == 0) progress.check();
    }
    advance_v(last);
    std::optional<Joint> joint;
    if (plan_.successor == kNoAxis) {
      finish(before);
    } else {
      joint = finish_in_successor(before);
    }
    place_texture();
    assert(next_triangle_ == plan_.first_triangle + plan_.triangles());
    assert(next_vertex_ == plan_.first_vertex + plan_.vertices(path_.is_lateral()));
    return joint;
  }

 private:
  /// The point before the first bend, where a branch comes free, represents all points before it.
  bool is_free_point(std::size_t i) const { return plan_.collar && i + 1 == plan_.collar->next_point; }
  Vec3 position(std::size_t i) const { return is_free_point(i) ? plan_.collar->centre : path_.position(i); }
  float radius(std::size_t i) const {
    if (is_free_point(i)) return plan_.collar->radius;
    if (path_.is_lateral()) return i == 0 ? plan_.start_radius : path_.radius(i);
    return path_.radius(i) * flare(glm::distance(path_.position(0), path_.position(i)));
  }
  float flare(float metres) const { return flare_factor(surface_, plan_.start_radius, metres); }
  float length(std::size_t i) const { return glm::distance(position(i), position(i + 1)); }
  /// Returns the growth of the radius per metre from point i to the next.
  float slope(std::size_t i) const { return (radius(i + 1) - radius(i)) / std::max(length(i), kThinnestTube); }
  /// Returns the growth of v per metre along the tube at this radius, which equals the growth of u per metre around it.
  float tiles_per_metre(float at_radius) const { return tiles_ / (static_cast<float>(2 * kPi) * at_radius); }

  void advance_v(std::size_t i) { v_ += length(i - 1) * tiles_per_metre(0.5F * (radius(i - 1) + radius(i))); }

  /// Writes the closed start. A lateral has a collar, or a point behind its first ring, inside the parent. A root has a
  /// disc.
  void start(Vec3 direction) {
    if (plan_.collar) return start_collar();
    const Vec3 centre = path_.position(0);
    if (path_.is_lateral()) {
      const std::uint32_t point = add_vertex(centre - kStartDepth * radius(0) * direction, -direction, {0.5F, 0});
      close_start(point);
      if (joint_) return ring(centre, kInJoint * radius(0), joint_->mitre, joint_->slope_before, joint_->slope_after);
      ring(centre, radius(0), Mitre(direction), 1 / kStartDepth, slope(0));
      return;
    }
    start_root(direction);
  }

  void start_root(Vec3 direction) {
    const Vec3 centre = path_.position(0);
    const float scale = radius(0) * tiles_per_metre(radius(0));
    const std::uint32_t middle = add_vertex(centre, -direction, {0, 0});
    close_start(middle);
    next_vertex_ += plan_.sides;
    const float first = flare_slope(0);
    ring(centre, radius(0), Mitre(direction), first, first);
    // The disc's rim repeats the ring, with the disc's own normal and uvs.
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      const std::uint32_t vertex = middle + 1 + k;
      mesh_.positions[vertex] = mesh_.positions[vertex + plan_.sides];
      mesh_.normals[vertex] = -direction;
      mesh_.uvs[vertex] = {-scale * corners_[k].cosine, scale * corners_[k].sine};
    }
    for (std::uint32_t k = 0; k < plan_.flare_rings; ++k) {
      const float way = kFlareShares[k] * length(0);
      const float here = glm::mix(path_.radius(0), path_.radius(1), kFlareShares[k]) * flare(way);
      v_ = way * tiles_per_metre(here);
      ring(centre + way * direction, here, Mitre(direction), flare_slope(way), flare_slope(way));
      join();
    }
    v_ = 0;
  }

  /// Returns the growth of the radius per metre at a height, in metres, on the first segment.
  float flare_slope(float metres) const {
    const float step = 0.01F * length(0);
    const auto radius_at = [&](float way) {
      return glm::mix(path_.radius(0), path_.radius(1), way / std::max(length(0), kThinnestTube)) * flare(way);
    };
    return (radius_at(metres + step) - radius_at(metres)) / std::max(step, kThinnestTube);
  }

  /// Writes the rings between the parent's bark and the first free ring. Each corner follows a curve that leaves the
  /// bark flat and ends in the branch's direction.
  void start_collar() {
    const Collar& collar = *plan_.collar;
    const Bark bark = tubes_.bark_below(path_);
    const Vec3 y = glm::cross(collar.direction, x_);
    const float farthest = 2 * (glm::distance(collar.centre, path_.position(0)) + collar.radius);
    const std::uint32_t stride = plan_.sides + 1;
    const std::uint32_t point = next_vertex_++;
    const std::uint32_t first = next_vertex_;
    close_start(point);
    Vec3 middle(0);
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      const Vec3 out = corners_[k].cosine * x_ + corners_[k].sine * y;
      const Vec3 top = collar.centre + collar.radius * out;
      const Vec3 foot = top - bark.trace(top, -collar.direction, farthest) * collar.direction;
      const Vec3 up = bark.nearest(foot).normal();
      const Vec3 away = unit_or(out - glm::dot(out, up) * up, out);
      Vec3 low = foot + collar.fillet * away;
      const Bark::Nearest at_low = bark.nearest(low);
      const Vec3 outward = at_low.normal();
      low -= (at_low.distance + plan_.sink) * outward;
      const Vec3 hidden = low + kHiddenFillet * collar.fillet * (away - outward);
      middle += hidden;
      put_collar_vertex(first + k, hidden, unit_or(away - 0.3F * outward, -outward), k);
      for (std::uint32_t j = 1; j < AxisPlan::kCollarRings; ++j) {
        const float t = static_cast<float>(j - 1) / static_cast<float>(AxisPlan::kCollarRings - 2);
        const Vec3 position = (1 - t) * (1 - t) * low + 2 * t * (1 - t) * foot + t * t * top;
        const Vec3 along = unit_or((1 - t) * (foot - low) + t * (top - foot), collar.direction);
        const Vec3 facing = (1 - t) * outward + t * out;
        const Vec3 normal = t == 0 ? outward : unit_or(facing - glm::dot(facing, along) * along, out);
        put_collar_vertex(first + j * stride + k, position, normal, k);
      }
    }
    // The last corner repeats the first.
    for (std::uint32_t j = 0; j < AxisPlan::kCollarRings; ++j) {
      const std::uint32_t vertex = first + j * stride;
      put_collar_vertex(vertex + plan_.sides, mesh_.positions[vertex], mesh_.normals[vertex], plan_.sides);
    }
    middle += mesh_.positions[first];
    // The hidden point lies deeper than the ring around it.
    middle /= static_cast<float>(stride);
    mesh_.positions[point] = middle - kHiddenFillet * collar.fillet * bark.nearest(middle).normal();
    mesh_.normals[point] = -collar.direction;
    mesh_.uvs[point] = {0.5F, 0};
    finish_collar(first);
  }

  void put_collar_vertex(std::uint32_t vertex, Vec3 position, Vec3 normal, std::uint32_t corner) {
    mesh_.positions[vertex] = position;
    mesh_.normals[vertex] = normal;
    mesh_.uvs[vertex].x = static_cast<float>(corner) * tiles_ / static_cast<float>(plan_.sides);
  }

  /// Measures v along the collar's rings and joins them.
  void finish_collar(std::uint32_t first) {
    const std::uint32_t stride = plan_.sides + 1;
    next_vertex_ = first + stride;
    for (std::uint32_t j = 1; j < AxisPlan::kCollarRings; ++j) {
      float way = 0;
      for (std::uint32_t k = 0; k < plan_.sides; ++k) {
        const std::uint32_t vertex = next_vertex_ + k;
        way += glm::distance(mesh_.positions[vertex], mesh_.positions[vertex - stride]);
      }
      const float before = v_;
      v_ += way / static_cast<float>(plan_.sides) * tiles_per_metre(plan_.collar->radius);
      for (std::uint32_t k = 0; k < stride; ++k) {
        mesh_.uvs[next_vertex_ + k].y = v_;
        if (j == 1) mesh_.uvs[first + k].y = before;
      }
      next_vertex_ += stride;
      join();
    }
  }

  /// Adds triangles between a point and the rim around it, which is written next.
  void close_start(std::uint32_t point) {
    const std::uint32_t rim = next_vertex_;
    // A lateral's rim is its first ring, whose last corner repeats the first.
    const std::uint32_t sides = plan_.sides;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t next = path_.is_lateral() ? k + 1 : (k + 1) % sides;
      add_triangle(point, rim + next, rim + k);
    }
  }

  /// Writes the ring or rings at an inner point.
  void bend(std::size_t i, Vec3 before, Vec3 after) {
    const float cosine = glm::dot(before, after);
    const std::uint32_t count = fan_size(cosine);
    if (count > 1) return fan(i, before, after, count);
    const Vec3 outer = unit_or(before - after, Vec3(0));
    Mitre mitre(before, after, glm::normalize(before + after), outer);
    mitre.inner_stretch = inner_stretch(i, mitre.half_cosine);
    ring(position(i), radius(i), mitre, slope(i - 1), slope(i));
    join();
  }

  /// Divides a sharp bend into equal parts: rings around one point, slightly apart so that no two of their vertices
  /// coincide.
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
      ring(position(i) + shift * middle, radius(i), mitre, j == 0 ? slope(i - 1) : 0, j + 1 == count ? slope(i) : 0);
      join();
      // The middle of the tube does not move here, and its outside turns by the part's angle.
      if (j + 1 < count) v_ += 0.5F * static_cast<float>(angle * part) * tiles_ / static_cast<float>(2 * kPi);
    }
  }

  float inner_stretch(std::size_t i, float half_cosine) const {
    return inner_stretch(std::min(length(i - 1), length(i)), radius(i), half_cosine);
  }
  /// Returns how far a ring extends toward the inside of its bend, in radii: to the mitre, or less if the shorter
  /// adjacent segment is too short.
  static float inner_stretch(float shorter, float ring_radius, float half_cosine) {
    const float half_sine = std::sqrt(std::max(0.0F, 1 - half_cosine * half_cosine));
    const float room = kInnerReach * shorter;
    const float mitre = 1 / std::max(half_cosine, kSharpestMitre);
    return room < mitre * ring_radius * half_sine ? room / (ring_radius * half_sine) : mitre;
  }

  /// Writes the last ring and the cap.
  void finish(Vec3 direction) {
    const std::size_t last = path_.size() - 1;
    const float width = radius(last);
    const Vec3 centre = position(last);
    const float before = slope(last - 1);
    switch (plan_.cap) {
      case SurfaceOptions::Cap::pointed:  // a cone as high as it is wide
        ring(centre, width, Mitre(direction), before, -1);
        join();
        close_tip(centre + width * direction, direction, width * kSqrt2);
        return;
      case SurfaceOptions::Cap::round:
        ring(centre, width, Mitre(direction), before, 0);
        join();
        for (std::uint32_t k = 1; k <= AxisPlan::kDomeRings; ++k) {
          const double angle = k * kPi / 2 / (AxisPlan::kDomeRings + 1);
          const auto sine = static_cast<float>(math::sin(angle));
          const auto cosine = static_cast<float>(math::cos(angle));
          v_ += kDomeStep * width * tiles_per_metre(width);
          ring(centre + sine * width * direction, cosine * width, Mitre(direction), -sine / cosine, -sine / cosine);
          join();
        }
        close_tip(centre + width * direction, direction, kDomeStep * width);
        return;
      case SurfaceOptions::Cap::flat:
        ring(centre, width, Mitre(direction), before, before);
        join();
        close_end(centre, direction);
    }
  }

  /// Writes the last ring at the position of the successor's first ring, and a cone that is hidden inside the
  /// successor.
  Joint finish_in_successor(Vec3 before) {
    const std::size_t last = path_.size() - 1;
    const AxisPath successor = tubes_.path(plan_.successor);
    const Vec3 after = successor.direction(0, before);
    const float width = radius(last);
    const float metres = glm::distance(successor.position(0), successor.position(1));
    const float slope_after = (successor.radius(1) - width) / std::max(metres, kThinnestTube);
    Mitre mitre(before, after, glm::normalize(before + after), unit_or(before - after, Vec3(0)));
    mitre.inner_stretch = inner_stretch(std::min(length(last - 1), metres), width, mitre.half_cosine);
    const Joint joint{mitre, slope(last - 1), slope_after, x_, tiles_, v_};
    ring(position(last), width, mitre, joint.slope_before, joint.slope_after);
    join();
    close_tip(position(last) + width * before, before, width * kSqrt2);
    return joint;
  }

  /// Adds triangles from the last ring to a tip `metres` farther along the surface. The tip has a vertex per side,
  /// because each side has its own u.
  void close_tip(Vec3 tip, Vec3 direction, float metres) {
    const std::uint32_t rim = next_vertex_ - plan_.sides - 1;
    const float tip_v = v_ + metres * tiles_per_metre(radius(path_.size() - 1));
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      const float u = tiles_ * (static_cast<float>(k) + 0.5F) / static_cast<float>(plan_.sides);
      add_triangle(rim + k, rim + k + 1, add_vertex(tip, direction, {u, tip_v}));
    }
  }

  /// Adds a disc on the last ring, with its own normal and uvs.
  void close_end(Vec3 centre, Vec3 direction) {
    const std::uint32_t rim = next_vertex_ - plan_.sides - 1;
    const float scale = radius(path_.size() - 1) * tiles_per_metre(radius(path_.size() - 1));
    const std::uint32_t middle = add_vertex(centre, direction, {0, 0});
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      const Vec2 uv(scale * corners_[k].cosine, scale * corners_[k].sine);
      add_vertex(mesh_.positions[rim + k], direction, uv);
    }
    for (std::uint32_t k = 0; k < plan_.sides; ++k) {
      add_triangle(middle, middle + 1 + k, middle + 1 + (k + 1) % plan_.sides);
    }
  }

  /// Writes a ring and carries the frame across it. The slopes belong to the radius before and after.
  void ring(Vec3 centre, float ring_radius, const Mitre& mitre, float slope_before, float slope_after) {
    const Vec3 y = glm::cross(mitre.before, x_);
    const float weight_before = 1 / std::sqrt(1 + slope_before * slope_before);
    const float weight_after = 1 / std::sqrt(1 + slope_after * slope_after);
    const Vec3 taper = weight_before * slope_before * mitre.before + weight_after * slope_after * mitre.after;
    // The component along the hinge stays. The component across it is turned into the mitre plane, on either side.
    const auto laid = [&](Vec3 out, float stretch, Vec3 toward) {
      const float outward = glm::dot(out, mitre.outer);
      const Vec3 along_hinge = out - glm::dot(out, mitre.across) * mitre.across - outward * mitre.outer;
      return ring_radius * (along_hinge + outward / mitre.half_cosine * stretch * toward);
    };
    const auto averaged = [&](Vec3 out) {
      const Vec3 reflected = out - 2 * glm::dot(out, mitre.across) * mitre.across;
      return weight_before * out + weight_after * reflected;
    };
    // All of this is linear in the corner's direction, apart from the side of the bend on which it lies.
    const Vec3 outer_x = laid(x_, mitre.outer_stretch, mitre.outer);
    const Vec3 outer_y = laid(y, mitre.outer_stretch, mitre.outer);
    const Vec3 inner_x = laid(x_, mitre.inner_stretch, mitre.inner);
    const Vec3 inner_y = laid(y, mitre.inner_stretch, mitre.inner);
    const Vec3 normal_x = averaged(x_);
    const Vec3 normal_y = averaged(y);
    const float outward_x = glm::dot(x_, mitre.outer);
    const float outward_y = glm::dot(y, mitre.outer);
    const float du = tiles_ / static_cast<float>(plan_.sides);
    Vec3* const positions = &mesh_.positions[next_vertex_];
    Vec3* const normals = &mesh_.normals[next_vertex_];
    Vec2* const uvs = &mesh_.uvs[next_vertex_];
    for (std::uint32_t k = 0; k <= plan_.sides; ++k) {
      const auto [cosine, sine] = corners_[k];
      const bool is_outer = cosine * outward_x + sine * outward_y > 0;
      positions[k] = centre + cosine * (is_outer ? outer_x : inner_x) + sine * (is_outer ? outer_y : inner_y);
      const Vec3 normal = cosine * normal_x + sine * normal_y - taper;
      normals[k] = normal * (1 / std::sqrt(glm::dot(normal, normal)));
      uvs[k] = {static_cast<float>(k) * du, v_};
    }
    next_vertex_ += plan_.sides + 1;
    x_ -= 2 * glm::dot(x_, mitre.across) * mitre.across;
    x_ = glm::normalize(x_ - glm::dot(x_, mitre.after) * mitre.after);
  }

  /// Turns, mirrors and shifts the texture coordinates of the axis. The turn is the nearest one at which a whole number
  /// of tiles lies around the tube in both directions of the texture, so that its edges join.
  void place_texture() {
    if (surface_.turn == 0 && surface_.shift_u == 0 && surface_.shift_v == 0 && !surface_.mirror) return;
    const double length = tiles_;
    const Vec2 around(std::round(length * math::cos(surface_.turn)), std::round(length * math::sin(surface_.turn)));
    const Vec2 along_u = around == Vec2(0) ? Vec2(1, 0) : around / tiles_;
    const Vec2 along_v(-along_u.y, along_u.x);
    const float side = surface_.mirror ? -1.0F : 1.0F;
    const Vec2 shift(surface_.shift_u, surface_.shift_v);
    for (std::uint32_t k = static_cast<std::uint32_t>(plan_.first_vertex); k < next_vertex_; ++k) {
      const Vec2 uv = mesh_.uvs[k];
      mesh_.uvs[k] = side * uv.x * along_u + uv.y * along_v + shift;
    }
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

  const TubePlan& tubes_;
  AxisPath path_;
  const AxisPlan& plan_;
  const SurfaceOptions& surface_;
  std::span<const Turn> corners_;
  std::optional<Joint> joint_;
  Mesh& mesh_;
  std::uint32_t next_vertex_ = 0;
  std::uint64_t next_triangle_ = 0;
  Vec3 x_{0};  // direction of the first corner, at right angles to the segment before the next ring
  float tiles_ = 1;
  float v_ = 0;
};

}  // namespace

Mesh make_tubes(const Skeleton& skeleton, const SurfaceOptions& surface, Progress& progress) {
  if (!(surface.uv_scale > 0)) throw std::invalid_argument("a surface's uv_scale must be above 0");
  return std::move(make_tubes(TubePlan(skeleton, {{surface}}), progress)[0]);
}

std::vector<Mesh> make_tubes(const TubePlan& plan, Progress& progress) {
  std::vector<Mesh> meshes(plan.sizes().size());
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const TubeSize size = plan.sizes()[k];
    if (size.vertices > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument("a mesh has at most 2^32 vertices");
    }
    meshes[k].positions.reserve(size.vertices + 1);  // with spare capacity, so that rays read them without a copy
    resize_large(meshes[k].positions, size.vertices);
    resize_large(meshes[k].normals, size.vertices);
    resize_large(meshes[k].uvs, size.vertices);
    resize_large(meshes[k].triangles, size.triangles);
  }
  // Let every axis fill its part of the mesh.
  const TurnTable corners(plan.max_sides());
  parallel_for(plan.axis_count(), kMeshedAxesPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) {
      // A successor is written after the axis that it succeeds.
      if (plan[axis].succeeds) continue;
      std::optional<Joint> joint;
      for (auto index = static_cast<AxisIndex>(axis); index != kNoAxis; index = plan[index].successor) {
        if (plan[index].rings > 0) {
          joint = AxisMesher(plan, index, corners.of(plan[index].sides), joint, meshes[plan[index].mesh]).run(progress);
        }
        progress.advance(plan.node_count(index));
      }
    }
  });
  return meshes;
}

}  // namespace meristem
