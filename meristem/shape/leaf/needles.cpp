// SPDX-License-Identifier: Apache-2.0
// Builds the needles of a shoot. Bundles stand on a helix along the shoot, and their angle changes from the base angle
// to the tip angle. Combing presses their directions toward the plane of the shoot's two sides. A needle is a kite of
// two triangles that bends at its widest point, or a spike of three triangles around its upper edge.
#include "meristem/shape/leaf/needles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/base/random.h"

namespace meristem {
namespace {

constexpr double kWidest = 0.45;   // share of a needle's length at which it is widest
constexpr float kRounded = 0.5F;   // outward lean of a flat needle's normals, as if it were round
constexpr double kRoll = 6;        // radians; needles are turned about themselves by up to this times the irregularity
constexpr double kBareBase = 0.1;  // share of the shoot's twig before the first needles

void check(const NeedleShoot& shoot) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  const auto is_length = [](double value) { return std::isfinite(value) && value > 0; };
  require(is_length(shoot.length) && is_length(shoot.width), "needles need a positive length and width");
  require(std::isfinite(shoot.along) && shoot.along >= 0, "a shoot's length must be at least 0");
  require(std::isfinite(shoot.axis_radius) && shoot.axis_radius >= 0, "a twig's radius must be at least 0");
  require(std::isfinite(shoot.base_angle + shoot.tip_angle + shoot.divergence + shoot.spread + shoot.curl),
          "the angles of needles must be finite");
  require(shoot.flatten >= 0 && shoot.flatten <= 1, "needles must be combed by a share from 0 to 1");
  require(shoot.irregular >= 0 && shoot.irregular <= 1, "needles must differ by a share from 0 to 1");
  require(shoot.count >= 1 && shoot.fascicle >= 1, "a shoot needs at least 1 needle");
  require(shoot.sides == 2 || shoot.sides == 3, "a needle must have 2 or 3 sides");
}

class NeedleMesher {
 public:
  explicit NeedleMesher(const NeedleShoot& shoot)
      : shoot_(shoot), key_(RandomKey(shoot.variant).child("needles")), first_turn_(2 * kPi * key_.uniform(0)) {}

  Mesh run() {
    if (shoot_.axis_radius > 0 && shoot_.along > 0) add_axis();
    for (int k = 0; k < shoot_.count; ++k) add_bundle(k);
    return std::move(mesh_);
  }

 private:
  /// Returns a number that is uniform in 1 - irregular to 1 + irregular.
  double about_one(RandomKey key, std::uint64_t index) const {
    return 1 + shoot_.irregular * (2 * key.uniform(index) - 1);
  }

  void add_bundle(int k) {
    const RandomKey key = key_.child(static_cast<std::uint64_t>(k));
    const double up = (k + 0.5) / shoot_.count;
    const double lean = (shoot_.base_angle + up * (shoot_.tip_angle - shoot_.base_angle)) * about_one(key, 0);
    const double turn = first_turn_ + k * shoot_.divergence + 0.5 * shoot_.irregular * (2 * key.uniform(1) - 1);
    const Vec3 outward = combed(turn);
    const Vec3 ahead = static_cast<float>(math::sin(lean)) * outward + static_cast<float>(math::cos(lean)) * kUp;
    const auto height = static_cast<float>(shoot_.along * (kBareBase + (1 - kBareBase) * up));
    // A needle's upper face looks to the shoot, or up if needles are combed.
    const Vec3 to_shoot = static_cast<float>(math::sin(lean)) * kUp - static_cast<float>(math::cos(lean)) * outward;
    const Vec3 upper = glm::mix(to_shoot, Vec3(0, 0, 1), static_cast<float>(shoot_.flatten));
    Frame bundle = frame_along({0, height, 0}, ahead, upper);
    const double roll = kRoll * shoot_.irregular * (1 - shoot_.flatten) * (2 * key.uniform(3) - 1);
    bundle.axes = bundle.axes * rotation(kUp, roll);
    for (int n = 0; n < shoot_.fascicle; ++n) add_needle(in_bundle(bundle, n, key), key.child("needle"), n);
  }

  /// Returns a direction at right angles to the shoot.
  Vec3 combed(double turn) const {
    const double x = math::cos(turn);
    const double z = (1 - shoot_.flatten) * math::sin(turn);
    return normalized_or(Vec3(static_cast<float>(x), 0, static_cast<float>(z)), {1, 0, 0});
  }

  /// Returns the frame of a needle in its bundle. Needles lean away from the bundle's middle in all directions, and two
  /// needles to opposite sides.
  Frame in_bundle(const Frame& bundle, int n, RandomKey key) const {
    if (shoot_.fascicle == 1) return bundle;
    const double turn = 2 * kPi * (n + key.uniform(2)) / shoot_.fascicle;
    // Few needles stand in a ring, many fill a cone.
    const double share = shoot_.fascicle <= 5 ? 1 : std::sqrt((n + 0.5) / shoot_.fascicle);
    const double around = shoot_.fascicle <= 5 ? turn : n * radians(kGoldenAngleDeg) + turn;
    Frame needle = bundle;
    needle.axes = bundle.axes * rotation(kUp, around) * rotation({1, 0, 0}, shoot_.spread * share);
    return needle;
  }

  /// Adds a needle along the frame's y, with its face to z.
  void add_needle(const Frame& frame, RandomKey key, int n) {
    const double length = shoot_.length * about_one(key, static_cast<std::uint64_t>(n));
    const auto half = static_cast<float>(shoot_.width / 2);
    // The bend as a chord from base to tip, and the middle's height above it.
    const double lean = 0.5 * shoot_.curl;
    const auto middle = static_cast<float>(kWidest * length);
    const auto tip_along = static_cast<float>(length * math::cos(lean));
    const auto tip_down = static_cast<float>(-length * math::sin(lean));
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    const auto add = [&](Vec3 at, Vec3 normal, Vec2 uv) {
      mesh_.positions.push_back(frame.point(at));
      mesh_.normals.push_back(glm::normalize(frame.vector(normal)));
      mesh_.uvs.push_back(uv);
    };
    const Vec3 up_at_tip{0, static_cast<float>(math::sin(lean)), static_cast<float>(math::cos(lean))};
    const Vec3 tip{0, tip_along, tip_down};
    if (shoot_.sides == 2) {
      const auto v = static_cast<float>(kWidest);
      add({0, 0, 0}, {0, 0, 1}, {0.5F, 0});
      add({half, middle, 0}, {kRounded, 0, 1}, {1, v});
      add(tip, up_at_tip, {0.5F, 1});
      add({-half, middle, 0}, {-kRounded, 0, 1}, {0, v});
      mesh_.triangles.push_back({first, first + 1, first + 3});
      mesh_.triangles.push_back({first + 1, first + 2, first + 3});
      return;
    }
    // Around the base, then the tip for each side.
    const float low = -0.5F * half;
    add({half, 0, low}, {1, 0, -0.6F}, {1, 0});
    add({0, 0, half}, {0, 0, 1}, {0.5F, 0});
    add({-half, 0, low}, {-1, 0, -0.6F}, {0, 0});
    add(tip, up_at_tip + Vec3(1, 0, 0), {0.75F, 1});
    add(tip, up_at_tip - Vec3(1, 0, 0), {0.25F, 1});
    add(tip, -up_at_tip, {0.5F, 1});
    for (std::uint32_t k = 0; k < 3; ++k) mesh_.triangles.push_back({first + (k + 1) % 3, first + k, first + 3 + k});
  }

  /// Adds a three-sided twig that ends in a point.
  void add_axis() {
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * kPi * k / 3;
      const Vec3 out{static_cast<float>(math::cos(angle)), 0, -static_cast<float>(math::sin(angle))};
      mesh_.positions.push_back(static_cast<float>(shoot_.axis_radius) * out);
      mesh_.normals.push_back(out);
      mesh_.uvs.emplace_back(0.5F, 0);
    }
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * kPi * (k + 0.5) / 3;
      mesh_.positions.emplace_back(0, static_cast<float>(shoot_.along), 0);
      mesh_.normals.emplace_back(static_cast<float>(math::cos(angle)), 0, -static_cast<float>(math::sin(angle)));
      mesh_.uvs.emplace_back(0.5F, 0.1F);
    }
    for (std::uint32_t k = 0; k < 3; ++k) mesh_.triangles.push_back({first + k, first + (k + 1) % 3, first + 3 + k});
  }

  const NeedleShoot& shoot_;
  RandomKey key_;
  double first_turn_;
  Mesh mesh_;
};

}  // namespace

Mesh make_needles(const NeedleShoot& shoot) {
  check(shoot);
  return NeedleMesher(shoot).run();
}

}  // namespace meristem
