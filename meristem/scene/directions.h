// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/field/kept_out.h"
#include "meristem/scene/field/vector_field.h"
#include "meristem/scene/light/light.h"

namespace meristem {

/// The direction and strength of a pull at a position.
struct FieldPull {
  Vec3 toward{0};      ///< unit vector; 0 if nothing pulls
  float strength = 1;  ///< 1: like the scene's own light or gravity

  /// Returns the pull as one vector, as long as its strength.
  Vec3 vector() const { return strength * toward; }
};

/// Returns the share of a turn toward a pull of the given strength, if strength 1 turns by `share`. Two pulls of
/// strength 1 in sequence turn as much as one pull of strength 2.
double share_pulled(double share, float strength);

/// A field that plants perceive: the scene's own field, with added or replacing fields.
class FieldSense {
 public:
  FieldSense() = default;
  /// A uniform field with this unit vector.
  explicit FieldSense(Vec3 toward) : uniform_{toward, 1} {}
  /// A field that varies in space.
  explicit FieldSense(FieldPointer own) : own_(std::move(own)), varies_(true) {}

  /// Returns the pull at a position.
  FieldPull at(Vec3 position) const { return varies_ ? sum_at(position) : uniform_; }
  /// Returns the sum of the fields that were added to the scene's own, at a position; 0 without such fields.
  Vec3 given_at(Vec3 position) const { return given_ == nullptr ? Vec3(0) : given_->at(position); }
  bool has_given() const { return given_ != nullptr; }  ///< true if a field was added to the scene's own
  bool is_uniform() const { return !varies_; }          ///< true if the field is equal at all positions

  /// Returns a copy with another field. If `adds` is false, the field replaces all others.
  FieldSense with(FieldPointer field, bool adds) const;

 private:
  FieldPull sum_at(Vec3 position) const;

  FieldPull uniform_{kUp, 1};  // the whole field if it is uniform
  FieldPointer own_;           // the scene's own field if it varies or if others were added; else null
  FieldPointer given_;
  bool varies_ = false;
};

/// The directions that a plant perceives at a position: toward the light and down. All growth that turns by light or
/// gravity asks this class at the position of the turn. Without lamps and fields the directions are uniform, and
/// queries cost nothing. Code that shares results between positions must use key_at().
class Directions {
 public:
  Directions() = default;  ///< light from the zenith
  /// Both arguments are unit vectors.
  explicit Directions(Vec3 toward_light, Vec3 down = -kUp) : light_(toward_light), gravity_(down) {}
  /// Light comes from the mean of the sun's positions, weighted by strength. If the sun gives no light (an overcast
  /// sky), light comes from the sun in pictures, `shown`. If `shown` is below the horizon, light comes from the zenith,
  /// because then only the sky gives light. Lamps pull in proportion to their strength, relative to the strength of all
  /// directional light.
  Directions(const Light& light, SkyDirection shown);
  Directions(FieldSense light, FieldSense gravity) : light_(std::move(light)), gravity_(std::move(gravity)) {}

  /// Returns the pull of the light at a position.
  FieldPull light(Vec3 position) const { return light_.at(position); }
  /// Returns the pull of gravity at a position.
  FieldPull gravity(Vec3 position) const { return gravity_.at(position); }
  Vec3 toward_light(Vec3 position) const { return light_.at(position).toward; }  ///< unit vector, or 0
  Vec3 down(Vec3 position) const { return gravity_.at(position).toward; }        ///< unit vector, or 0

  const FieldSense& light_sense() const { return light_; }      ///< the field of light
  const FieldSense& gravity_sense() const { return gravity_; }  ///< the field of gravity
  /// Returns a copy with other fields of light and gravity.
  Directions with(FieldSense light, FieldSense gravity) const;

  /// Returns a copy with one more body that stems keep out of.
  Directions with(std::shared_ptr<const KeptOut> body) const;
  /// Returns the heading of a section of a stem that keeps out of all these bodies. The first body is applied last.
  Vec3 open_heading(const KeptOut::Section& section) const {
    return kept_out_ == nullptr ? section.heading : kept_out(section);
  }
  bool keep_out() const { return kept_out_ != nullptr; }  ///< true if stems must keep out of some body

  /// Returns a key that is equal for positions with equal directions.
  std::uint64_t key_at(Vec3 position) const;

 private:
  Vec3 kept_out(KeptOut::Section section) const;

  FieldSense light_{kUp};
  FieldSense gravity_{-kUp};
  std::shared_ptr<const std::vector<std::shared_ptr<const KeptOut>>> kept_out_;  // null if there are no such bodies
};

}  // namespace meristem
