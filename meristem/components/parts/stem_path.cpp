// SPDX-License-Identifier: Apache-2.0
// A stem grows section by section. Each section turns with the given axis, by its share of the curl, and by the change
// of the noise since the previous section. It also turns away from branches that push it, and toward gravity and light.
// The shares are chosen so that the form of a stem does not depend on the number of its sections.
#include "meristem/components/parts/stem_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/math.h"
#include "meristem/base/noise.h"
#include "meristem/graph/table/table.h"

namespace meristem {

namespace {

// Largest share of an angle; with 1, the first section would close the whole angle.
constexpr double kStrongest = 0.995;
constexpr int kWaySteps = 64;            // pieces between two points that measure the length of an axis
constexpr std::size_t kMaxPoints = 500;  // points of an axis

/// Returns the share of the angle that one turn must close, so that 1 / `part` turns together close `strength` of it.
double share_of_turn(double strength, double part) {
  const double open = 1 - std::min(std::abs(strength), kStrongest);
  return 1 - math::pow(open, part);
}

/// Returns the directions of the sections of a stem along a spline, in the stem's own frame.
std::vector<Vec3> way_directions(const std::vector<Vec3>& axis, int sections) {
  // Make the spline, parametrised by the length of the lines between its points.
  std::vector<Vec3> points{Vec3(0)};
  std::vector<float> at{0};
  for (const Vec3 point : axis) {
    const float step = glm::distance(point, points.back());
    at.push_back(at.back() + step);
    points.push_back(point);
  }
  const auto coordinate = [&](int k) {
    std::vector<Vec2> pairs;
    for (std::size_t p = 0; p < points.size(); ++p) pairs.emplace_back(at[p], points[p][k]);
    return Curve(std::move(pairs));
  };
  const Curve x = coordinate(0), y = coordinate(1), z = coordinate(2);
  const auto position = [&](double s) { return glm::dvec3(x(s), y(s), z(s)); };

  // Divide it into sections of equal length.
  const auto fine = static_cast<int>(points.size() - 1) * kWaySteps;
  std::vector<double> length(static_cast<std::size_t>(fine) + 1);
  glm::dvec3 last = position(0);
  for (int k = 1; k <= fine; ++k) {
    const glm::dvec3 next = position(at.back() * k / fine);
    length[static_cast<std::size_t>(k)] = length[static_cast<std::size_t>(k - 1)] + glm::distance(last, next);
    last = next;
  }
  const auto place_at_length = [&](double wanted) {
    const auto after = std::ranges::upper_bound(length, wanted);
    const auto k = std::clamp<std::ptrdiff_t>(after - length.begin(), 1, fine) - 1;
    const double piece = length[static_cast<std::size_t>(k + 1)] - length[static_cast<std::size_t>(k)];
    const double share = piece > 0 ? (wanted - length[static_cast<std::size_t>(k)]) / piece : 0;
    return position(at.back() * (static_cast<double>(k) + share) / fine);
  };
  std::vector<Vec3> directions;
  last = position(0);
  for (int k = 1; k <= sections; ++k) {
    const glm::dvec3 next = place_at_length(length.back() * k / sections);
    directions.push_back(normalized_or(Vec3(next - last), directions.empty() ? kUp : directions.back()));
    last = next;
  }
  return directions;
}

/// Grows the axis of one stem in world space.
class StemPathBuilder {
 public:
  StemPathBuilder(const StemParameters& form, const Site& site, const StemTropisms& tropisms,
                  std::span<const StemBend> bends)
      : form_(form), tropisms_(tropisms), bends_(bends), key_(site.key.child("gnarl")) {
    const Frame& frame = site.frame;
    scale_ = glm::length(frame.heading());
    heading_ = normalized_or(frame.heading(), kUp);
    right_ = normalized_or(frame.right() - glm::dot(frame.right(), heading_) * heading_, any_perpendicular(heading_));
    origin_ = frame.origin;
    if (!form.axis.empty()) way_ = way_directions(form.axis, form.segments);
  }

  StemPath run() {
    StemPath path;
    path.length = scale_ * static_cast<float>(form_.length);
    path.skeleton.reserve(static_cast<std::size_t>(form_.segments) + 1);
    section_ = path.length / static_cast<float>(form_.segments);
    Vec3 position = origin_;
    NodeIndex last = add_node(path.skeleton, kNoNode, position, 0);
    for (int k = 0; k < form_.segments; ++k) {
      const Vec3 heading = heading_, right = right_;
      turn(k, position);
      path.frames.push_back(k == 0 ? frame(position, heading_, right_) : frame_midway(position, heading, right));
      position += section_ * heading_;
      last = add_node(path.skeleton, last, position, k + 1);
    }
    path.frames.push_back(frame(position, heading_, right_));
    return path;
  }

 private:
  NodeIndex add_node(Skeleton& skeleton, NodeIndex parent, Vec3 position, int section) const {
    const NodeIndex node = skeleton.add_node(parent, position, 0);
    skeleton.radius[node] = radius_at(section);
    return node;
  }

  /// Returns a node's frame, whose heading is midway between the headings of the adjacent sections.
  Frame frame_midway(Vec3 position, Vec3 heading, Vec3 right) const {
    heading = normalized_or(heading + heading_, heading_);
    right += right_;
    return frame(position, heading, normalized_or(right - glm::dot(right, heading) * heading, right_));
  }

  Frame frame(Vec3 position, Vec3 heading, Vec3 right) const {
    Frame frame{Mat3(right, heading, glm::cross(right, heading)), position};
    frame.axes *= scale_;
    return frame;
  }

  Vec3 upper() const { return glm::cross(right_, heading_); }
  /// Converts a direction in the frame of a straight stem to the world.
  Vec3 from_stem(Vec3 local) const { return local.x * right_ + local.y * heading_ + local.z * upper(); }

  /// Turns to the section that begins at `position`.
  void turn(int section, Vec3 position) {
    if (!way_.empty()) follow_way(static_cast<std::size_t>(section));
    if (form_.spiral != 0) rotate(rotation(heading_, form_.spiral / form_.segments));
    const double curl = form_.curl / form_.segments;
    rotate(rotation(right_, wandered(section, 0) - curl) * rotation(upper(), wandered(section, 1)));
    avoid(section);
    if (!tropisms_.act()) return;
    const Vec3 in_scene = tropisms_.origin + tropisms_.stretch * position;
    const double gravitropism = tropisms_.gravitropism, phototropism = tropisms_.phototropism;
    if (gravitropism != 0) follow(tropisms_.directions->gravity(in_scene), gravitropism);
    if (phototropism != 0) follow(tropisms_.directions->light(in_scene), phototropism);
    if (tropisms_.keep_out()) stay_out(section, in_scene);
  }

  /// Turns to a heading that the surrounding bodies allow.
  void stay_out(int section, Vec3 in_scene) {
    const double thickest = std::max(radius_at(section), radius_at(section + 1));
    const Vec3 open = tropisms_.directions->open_heading({.position = in_scene,
                                                          .heading = heading_,
                                                          .step = tropisms_.stretch * section_,
                                                          .radius = tropisms_.stretch * thickest});
    if (open != heading_) rotate(rotation_between(heading_, open));
  }

  /// Returns the radius at the begin of a section in metres.
  float radius_at(int section) const {
    const double u = static_cast<double>(section) / form_.segments;
    return scale_ * static_cast<float>(std::max(0.0, form_.taper(u)) * form_.radius);
  }

  /// Turns like the spline between the previous section and this one.
  void follow_way(std::size_t section) {
    const Mat3 turn = rotation_between(section == 0 ? kUp : way_[section - 1], way_[section]);
    const Mat3 own = glm::transpose(way_axes_) * turn * way_axes_;  // in the spline's own frame
    way_axes_ = turn * way_axes_;
    const Mat3 turned = Mat3(right_, heading_, upper()) * own;
    heading_ = glm::normalize(turned[1]);
    right_ = glm::normalize(turned[0] - glm::dot(turned[0], heading_) * heading_);
  }

  /// Returns the change of the noise since the previous section.
  double wandered(int section, std::uint64_t direction) const {
    if (form_.gnarl == 0) return 0;
    const auto noise = [&](int k) {
      return gradient_noise(key_.child(direction), k * form_.gnarl_waves / form_.segments);
    };
    return 2 * form_.gnarl * (noise(section + 1) - noise(section));
  }

  /// Turns by all pushes on the stem since the previous section.
  void avoid(int section) {
    const double reached = (section + 0.5) / form_.segments;
    for (; next_bend_ < bends_.size() && bends_[next_bend_].u <= reached; ++next_bend_) {
      const Vec3 turn = bends_[next_bend_].turn;
      const float angle = glm::length(turn);
      if (angle > 0) rotate(rotation(from_stem(turn / angle), angle));
    }
  }

  /// Turns toward a pull, or away from it if the strength is negative.
  void follow(const FieldPull& pulling, double strength) {
    const Vec3 target = strength > 0 ? pulling.toward : -pulling.toward;
    const double angle = math::acos(glm::dot(heading_, target));
    const Vec3 axis = normalized_or(glm::cross(heading_, target), right_);
    rotate(rotation(axis, angle * share_of_turn(strength, pulling.strength / form_.segments)));
  }

  void rotate(const Mat3& turn) {
    heading_ = glm::normalize(turn * heading_);
    right_ = turn * right_;
    right_ = glm::normalize(right_ - glm::dot(right_, heading_) * heading_);
  }

  const StemParameters& form_;
  const StemTropisms& tropisms_;
  std::span<const StemBend> bends_;
  std::size_t next_bend_ = 0;
  RandomKey key_;
  float scale_ = 1;
  float section_ = 0;  // length of a section, metres
  Vec3 heading_{0}, right_{0}, origin_{0};
  std::vector<Vec3> way_;
  Mat3 way_axes_{1};  // the spline's own frame, transported along it without twist
};

}  // namespace

const ParameterTable& stem_form_table() {
  static const ParameterTable table =
      Table<StemParameters>("a stem", "A stem along a curve.")
          .number("length", &StemParameters::length,
                  {.unit = Unit::metre, .min = 1e-4, .max = 1000, .usual = {0.01, 10}},
                  "Length of the stem from base to tip.")
          .number("radius", &StemParameters::radius,
                  {.unit = Unit::metre, .min = 1e-6, .max = 100, .usual = {0.0005, 0.3}},
                  "Radius of the stem at its base.")
          .curve("taper", &StemParameters::taper,
                 "Radius from base (0) to tip (1), as a share of the radius at the base.")
          .integer("segments", &StemParameters::segments, {.min = 1, .max = 1000, .usual = {1, 64}, .fixed = true},
                   "Number of straight segments; raised, smoother bends and more nodes.")
          .positions(
              "axis", &StemParameters::axis, {.unit = Unit::metre, .min = -1e4, .max = 1e4},
              "Points of a spline from the origin, in the stem's own frame, whose form the stem takes; its length "
              "stays 'length'.")
          .together(PointsForm::line)
          .number("curl", &StemParameters::curl, {.unit = Unit::degree, .min = -3600, .max = 3600},
                  "Bend of the stem from base to tip, away from its upper side; the upper side of a branch faces the "
                  "tip of its parent.")
          .number("spiral", &StemParameters::spiral,
                  {.unit = Unit::degree, .min = -36000, .max = 36000, .usual = {-1080, 1080}},
                  "Turn of the curl's direction about the stem from base to tip; raised, a corkscrew.")
          .number("gnarl", &StemParameters::gnarl, {.unit = Unit::degree, .min = 0, .max = 180, .usual = {0, 60}},
                  "Random deviation of the stem's direction along its length; raised, a more crooked stem.")
          .number("gnarl_waves", &StemParameters::gnarl_waves, {.min = 0, .max = 1000},
                  "Number of random bends from base to tip; raised, shorter bends.")
          .only_with("gnarl", {"gnarl_waves"});
  return table;
}

StemPath grow_stem(const StemParameters& form, const Site& site, const StemTropisms& tropisms,
                   std::span<const StemBend> bends) {
  return StemPathBuilder(form, site, tropisms, bends).run();
}

void check_stem_form(const StemParameters& form, const DocumentPath& path, ParameterReader& reader) {
  const DocumentPath axis(path, "axis");
  if (form.axis.size() > kMaxPoints) {
    reader.add_error(axis, fmt::format("the axis has {} points", form.axis.size()),
                     fmt::format("at most {}", kMaxPoints));
    return;
  }
  Vec3 last(0);
  for (std::size_t k = 0; k < form.axis.size(); ++k) {
    if (glm::distance(form.axis[k], last) < 1e-6F) {
      reader.add_error(DocumentPath(axis, k),
                       k == 0 ? "the axis begins at the origin by itself" : "a point of the axis repeats",
                       "points that lie apart");
      return;
    }
    last = form.axis[k];
  }
}

}  // namespace meristem
