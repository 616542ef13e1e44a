// SPDX-License-Identifier: Apache-2.0
// Combines the light and gravity that plants perceive from the scene's own and from added fields, and turns stems away
// from bodies that they must keep out of.
#include "meristem/scene/directions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meristem/base/fingerprint.h"
#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/scene/field/ready_fields.h"

namespace meristem {

namespace {

constexpr float kUnitSlack = 1e-6F;  // tolerance for squared lengths that count as 1
constexpr float kNoPull = 1e-24F;    // squared length below which there is no pull

/// Splits a vector into direction and length. Unit vectors are returned unchanged, to the last bit.
FieldPull pulling(Vec3 vector) {
  const float squared = glm::dot(vector, vector);
  if (std::abs(squared - 1) < kUnitSlack) return {vector, 1};
  if (!(squared > kNoPull)) return {Vec3(0), 0};
  const float length = std::sqrt(squared);
  return {vector / length, length};
}

/// Direction of the light of lamps and directional light together, as a unit vector.
class LampField : public VectorField {
 public:
  LampField(std::vector<Lamp> lamps, DVec3 directional) : lamps_(std::move(lamps)), directional_(directional) {}

  Vec3 at(Vec3 position) const override {
    DVec3 sum = directional_;
    for (const Lamp& lamp : lamps_) {
      const LightRay ray = Light::ray_to(lamp, position);
      sum += ray.strength * DVec3(ray.toward);
    }
    return normalized_or(Vec3(sum), kUp);
  }

 private:
  std::vector<Lamp> lamps_;
  DVec3 directional_;
};

Vec3 toward_directional_light(const Light& light, SkyDirection shown) {
  if (light.sun.size() == 1) return light.sun[0].toward;  // exact, without rounding
  if (!light.sun.empty()) {
    DVec3 sum(0);
    for (const DirectionalLight& sun : light.sun) sum += sun.strength * DVec3(sun.toward);
    return normalized_or(Vec3(sum), kUp);
  }
  return shown.altitude > 0 ? unit_vector(shown) : kUp;
}

FieldSense sense_of(const Light& light, SkyDirection shown) {
  const Vec3 toward = toward_directional_light(light, shown);
  if (light.lamps.empty()) return FieldSense(toward);
  double strength = 0;
  for (const DirectionalLight& directional : light.sun) strength += directional.strength;
  for (const DirectionalLight& directional : light.sky) strength += directional.strength;
  return FieldSense(std::make_shared<const LampField>(light.lamps, strength * DVec3(toward)));
}

}  // namespace

double share_pulled(double share, float strength) {
  if (strength == 1) return share;
  const double open = 1 - std::min(1.0, std::abs(share));
  return std::copysign(strength > 0 ? 1 - math::pow(open, strength) : 0, share);
}

FieldSense FieldSense::with(FieldPointer field, bool adds) const {
  FieldSense made;
  if (adds) {
    made.own_ = given_ == nullptr && own_ == nullptr ? std::make_shared<const UniformField>(uniform_.toward) : own_;
    if (given_ != nullptr) field = std::make_shared<const SumField>(given_, std::move(field));
  }
  made.given_ = std::move(field);
  made.varies_ = (made.own_ != nullptr && !made.own_->is_uniform()) || !made.given_->is_uniform();
  if (!made.varies_) made.uniform_ = made.sum_at(Vec3(0));
  return made;
}

FieldPull FieldSense::sum_at(Vec3 position) const {
  const Vec3 own = own_ == nullptr ? Vec3(0) : own_->at(position);
  return pulling(own + given_at(position));
}

Directions::Directions(const Light& light, SkyDirection shown) : light_(sense_of(light, shown)) {}

Directions Directions::with(FieldSense light, FieldSense gravity) const {
  Directions made = *this;
  made.light_ = std::move(light);
  made.gravity_ = std::move(gravity);
  return made;
}

Directions Directions::with(std::shared_ptr<const KeptOut> body) const {
  std::vector<std::shared_ptr<const KeptOut>> bodies;
  bodies.push_back(std::move(body));
  if (kept_out_ != nullptr) bodies.insert(bodies.end(), kept_out_->begin(), kept_out_->end());
  Directions made = *this;
  made.kept_out_ = std::make_shared<const std::vector<std::shared_ptr<const KeptOut>>>(std::move(bodies));
  return made;
}

Vec3 Directions::kept_out(KeptOut::Section section) const {
  for (const std::shared_ptr<const KeptOut>& body : *kept_out_) section.heading = body->open_heading(section);
  return section.heading;
}

std::uint64_t Directions::key_at(Vec3 position) const {
  Fingerprint key;
  for (const FieldPull& felt : {light(position), gravity(position)}) {
    key.add(felt.toward.x).add(felt.toward.y).add(felt.toward.z).add(felt.strength);
  }
  const bool varies = !light_.is_uniform() || !gravity_.is_uniform() || kept_out_ != nullptr;
  if (varies) key.add(position.x).add(position.y).add(position.z);
  return key.hash();
}

}  // namespace meristem
