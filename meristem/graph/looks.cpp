// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/looks.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

constexpr double kToneOfVariety = 0.9;  // how far the tone varies where lightness varies by 1

Vec3 linear_mean(const std::vector<Vec3>& colours) {
  Vec3 sum(0);
  for (const Vec3 colour : colours) sum += linear_from_srgb(colour);
  return sum / static_cast<float>(colours.size());
}

/// Between the two colours about `at`, in linear light.
Vec3 linear_at(const std::vector<Vec3>& colours, double at) {
  const double place = std::clamp(at, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), colours.size() - 1);
  const auto above = std::min(below + 1, colours.size() - 1);
  const auto share = static_cast<float>(place - static_cast<double>(below));
  return glm::mix(linear_from_srgb(colours[below]), linear_from_srgb(colours[above]), share);
}

}  // namespace

Material material_of(const Prototype& prototype) {
  const ComponentBase& base = prototype.base();
  Material material = prototype.type->material;
  material.name = prototype.id;
  material.colour =
      base.colours.empty() ? base.colour.value_or(material.colour) : srgb_from_linear(linear_mean(base.colours));
  material.roughness = static_cast<float>(base.roughness.value_or(material.roughness));
  material.translucency = static_cast<float>(base.translucency.value_or(material.translucency));
  const auto& texture_shape = prototype.type->texture_shape;
  const TextureShape shape = texture_shape ? texture_shape(prototype.parameters.get()) : TextureShape();
  material.texture = make_texture(base.texture, shape, material.colour);
  // Without a colour of the document's own, a picture is shown as it is.
  const bool is_tinted = base.colour.has_value() || !base.colours.empty();
  if (base.texture.picture && !is_tinted) material.colour = srgb_from_linear(material.texture->mean);
  return material;
}

Vec3 instance_tint(const ComponentBase& instance, double variety, RandomKey key) {
  Vec3 tint(1);
  if (!instance.colours.empty()) {
    const double at = instance.colour_at.value_or(key.uniform(0));
    tint = linear_at(instance.colours, at) / glm::max(linear_mean(instance.colours), Vec3(1e-4F));
  }
  if (variety > 0) {
    const double lighter = variety * (2 * key.uniform(1) - 1);
    const double yellower = kToneOfVariety * variety * (2 * key.uniform(2) - 1);
    const DVec3 shade = (1 + lighter) * DVec3(1 + yellower, 1, 1 - 0.45 * yellower);
    tint *= glm::max(Vec3(shade), Vec3(0));
  }
  return tint;
}

}  // namespace meristem
