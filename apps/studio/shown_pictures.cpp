// SPDX-License-Identifier: Apache-2.0
// Compares pictures by their tinted light: the root mean square of the differences of many pixels, on a scale that is
// even to the eye. Pictures below a small difference look alike, and the page keeps its own.
#include "shown_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "meristem/base/colour.h"
#include "meristem/graph/component.h"
#include "meristem/graph/texture_parameters.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kSamples = 40'000;  // approximate number of pixels that are compared
// Largest difference between alike pictures: root mean square, in levels of 255
constexpr double kAlike = 2;

const Prototype* component_of(const Graph& graph, const Material& material) {
  const auto found = std::ranges::find(graph.components, material.name, &Prototype::id);
  return found == graph.components.end() ? nullptr : &*found;
}

/// Returns true if the material would have the picture's texture with the colour for which it was painted.
bool differs_in_colour_alone(const Graph& graph, const Material& material, const Material& painted) {
  const Prototype* const prototype = component_of(graph, material);
  if (prototype == nullptr) return false;
  const auto& shape_of = prototype->type->texture_shape;
  const TextureShape shape = shape_of ? shape_of(prototype->parameters.get()) : TextureShape();
  const auto sketch = sketch_texture(prototype->base().texture, shape, painted.colour);
  return sketch != nullptr && sketch->fingerprint == painted.texture->fingerprint;
}

bool is_painted(const Material& material) {
  return material.texture != nullptr && material.texture->is_painted() && !material.texture->colour.is_empty();
}

/// Returns the linear light of each byte.
std::array<float, 256> lights() {
  std::array<float, 256> lights{};
  for (std::size_t k = 0; k < lights.size(); ++k) lights[k] = linear_from_srgb(Vec3(static_cast<float>(k) / 255.0F)).r;
  return lights;
}

}  // namespace

bool look_alike(const Texture& one, const Texture& other, Vec3 colour) {
  static const std::array<float, 256> kLights = lights();
  const Image& a = one.colour;
  const Image& b = other.colour;
  if (a.width != b.width || a.height != b.height || one.masked != other.masked) return false;
  const Vec3 tint_a = Material{.colour = colour, .texture = {std::shared_ptr<void>(), &one}}.tint();
  const Vec3 tint_b = Material{.colour = colour, .texture = {std::shared_ptr<void>(), &other}}.tint();
  // The step is odd, so that the samples do not fall into one column.
  const std::size_t pixels = a.rgba.size() / 4;
  const std::size_t step = std::max<std::size_t>(1, pixels / kSamples) | 1U;
  double sum = 0;
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < pixels; k += step) {
    const std::uint8_t* const from_a = a.rgba.data() + 4 * k;
    const std::uint8_t* const from_b = b.rgba.data() + 4 * k;
    if (one.masked && from_a[3] < 128 && from_b[3] < 128) continue;
    for (int channel = 0; channel < 3; ++channel) {
      // Differences of the root of light look nearly even to the eye.
      const float way =
          std::sqrt(kLights[from_a[channel]] * tint_a[channel]) - std::sqrt(kLights[from_b[channel]] * tint_b[channel]);
      sum += static_cast<double>(way) * static_cast<double>(way);
    }
    count += 3;
  }
  return count == 0 || 255 * std::sqrt(sum / static_cast<double>(count)) <= kAlike;
}

void ShownPictures::lend(const Graph& graph, std::vector<Material>& materials) const {
  for (Material& material : materials) {
    if (material.texture == nullptr || material.texture->is_painted()) continue;
    const auto shown = shown_.find(material.name);
    if (shown != shown_.end() && differs_in_colour_alone(graph, material, shown->second.painted))
      material.texture = shown->second.painted.texture;
  }
}

bool ShownPictures::keep(const Graph& graph, std::vector<Material>& materials) {
  bool keeps_any = false;
  for (Material& material : materials) {
    if (!is_painted(material)) continue;
    Shown& shown = shown_[material.name];
    const Texture* const before = shown.painted.texture.get();
    if (before == material.texture.get()) continue;
    bool is_alike = false;
    if (before != nullptr && differs_in_colour_alone(graph, material, shown.painted)) {
      if (shown.compared != material.texture->fingerprint) {
        shown.is_alike = look_alike(*before, *material.texture, material.colour);
        shown.compared = material.texture->fingerprint;
      }
      is_alike = shown.is_alike;
    }
    if (is_alike) {
      material.texture = shown.painted.texture;
      keeps_any = true;
    } else {
      shown = {.painted = material};
    }
  }
  return keeps_any;
}

}  // namespace meristem::studio
