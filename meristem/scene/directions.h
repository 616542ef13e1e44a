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

/// How something pulls at a position.
struct Pulling {
  Vec3 toward{0};      ///< unit vector; 0 where nothing pulls
  float strength = 1;  ///< 1: as a scene's own light and gravity do

  Vec3 vector() const { return strength * toward; }
};

/// What is left to do of a turn by `share` toward what pulls with `strength`: two pulls of strength 1, one after the
/// other, turn as much as one of strength 2.
double share_pulled(double share, float strength);

/// A field that plants perceive: the scene's own, and what is added to it or stands for it.
class Sense {
 public:
  Sense() = default;
  /// A unit vector, the same everywhere.
  explicit Sense(Vec3 toward) : uniform_{toward, 1} {}
  /// The scene's own where that varies.
  explicit Sense(FieldPointer own) : own_(std::move(own)), varies_(true) {}

  Pulling at(Vec3 position) const { return varies_ ? sum_at(position) : uniform_; }
  /// What other fields than the scene's pull there: 0 where there are none.
  Vec3 given_at(Vec3 position) const { return given_ == nullptr ? Vec3(0) : given_->at(position); }
  bool is_uniform() const { return !varies_; }

  /// With another field added, or in place of all there is.
  Sense with(FieldPointer field, bool adds) const;

 private:
  Pulling sum_at(Vec3 position) const;

  Pulling uniform_{kUp, 1};  // all of it, where that is the same everywhere
  FieldPointer own_;         // the scene's own where it varies or is not all; else null
  FieldPointer given_;
  bool varies_ = false;
};

/// Which ways a plant feels at a position: toward the light, and down. Whatever turns by light or gravity asks here, at
/// the position where it turns. Without lamps and fields both are the same everywhere, and asking costs nothing; what
/// shares a result between positions goes by key_at all the same.
class Directions {
 public:
  Directions() = default;  ///< light from the zenith
  /// Unit vectors.
  explicit Directions(Vec3 toward_light, Vec3 down = -kUp) : light_(toward_light), gravity_(down) {}
  /// Toward the middle of the sun's positions, each by its strength; where the sun gives no light (under a sky without
  /// a sun) toward the one in pictures, `shown`, and up where that is below the horizon, as all light comes from the
  /// sky then. Lamps pull as strongly as they shine, against the strength of all directional light.
  Directions(const Light& light, SkyDirection shown);
  Directions(Sense light, Sense gravity) : light_(std::move(light)), gravity_(std::move(gravity)) {}

  Pulling light(Vec3 position) const { return light_.at(position); }
  Pulling gravity(Vec3 position) const { return gravity_.at(position); }
  Vec3 toward_light(Vec3 position) const { return light_.at(position).toward; }  ///< unit vector, or 0
  Vec3 down(Vec3 position) const { return gravity_.at(position).toward; }        ///< unit vector, or 0

  const Sense& light_sense() const { return light_; }
  const Sense& gravity_sense() const { return gravity_; }
  /// With other ones.
  Directions with(Sense light, Sense gravity) const;

  /// With a body more that stems keep out of.
  Directions with(std::shared_ptr<const KeptOut> body) const;
  /// Where a section of a stem heads that keeps out of all these bodies; the first of them is the last to say.
  Vec3 open_heading(const KeptOut::Section& section) const {
    return kept_out_ == nullptr ? section.heading : kept_out(section);
  }
  bool keep_out() const { return kept_out_ != nullptr; }

  /// Equal for positions about which all are the same.
  std::uint64_t key_at(Vec3 position) const;

 private:
  Vec3 kept_out(KeptOut::Section section) const;

  Sense light_{kUp};
  Sense gravity_{-kUp};
  std::shared_ptr<const std::vector<std::shared_ptr<const KeptOut>>> kept_out_;  // null where there are none
};

}  // namespace meristem
