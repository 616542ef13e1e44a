// SPDX-License-Identifier: Apache-2.0
// Makes the material of a component from its parameters, paints textures, and computes the tint of each instance. A
// material begins with a sketch of its texture; paint_textures() later paints each different sketch once.
#include "meristem/graph/looks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <typeinfo>
#include <unordered_map>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

constexpr double kToneOfVariety = 0.9;  // variation of the tone where the lightness varies by 1

Vec3 linear_mean(const std::vector<Vec3>& colours) {
  Vec3 sum(0);
  for (const Vec3 colour : colours) sum += linear_from_srgb(colour);
  return sum / static_cast<float>(colours.size());
}

/// Returns the colour factor at `at` (0 to 1), interpolated between its two neighbours in the list.
Vec3 factor_at(const std::vector<Vec3>& factors, double at) {
  const double place = std::clamp(at, 0.0, 1.0) * static_cast<double>(factors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), factors.size() - 1);
  const auto above = std::min(below + 1, factors.size() - 1);
  return glm::mix(factors[below], factors[above], static_cast<float>(place - static_cast<double>(below)));
}

/// Returns the mean colour that the document gives, or `usual` if it gives none.
Vec3 mean_colour(const ComponentBase& base, Vec3 usual) {
  return base.colours.empty() ? base.colour.value_or(usual) : srgb_from_linear(linear_mean(base.colours));
}

TextureShape shape_of(const Prototype& prototype) {
  const auto& texture_shape = prototype.type->texture_shape;
  return texture_shape ? texture_shape(prototype.parameters.get()) : TextureShape();
}

std::shared_ptr<const Texture> painted_texture(const Prototype& prototype, const Progress& progress) {
  const ComponentBase& base = prototype.base();
  return make_texture(base.texture, shape_of(prototype), mean_colour(base, prototype.type->material.colour), progress);
}

/// Returns the number of pixels to paint for a material whose texture is a sketch, else 0.
std::uint64_t pixels_to_paint(const Material& material) {
  if (material.texture == nullptr || material.texture->is_painted()) return 0;
  const Image& colour = material.texture->colour;
  return static_cast<std::uint64_t>(colour.width) * static_cast<std::uint64_t>(colour.height);
}

/// Returns the component whose id is the name of a material with a texture.
const Prototype& component_of(const Material& material, const Graph& graph) {
  const auto found = std::ranges::find(graph.components, material.name, &Prototype::id);
  if (found == graph.components.end()) throw std::invalid_argument("a material with a texture is of no component");
  return *found;
}

}  // namespace

Material material_of(const Prototype& prototype) {
  const ComponentBase& base = prototype.base();
  Material material = prototype.type->material;
  material.name = prototype.id;
  material.colour = mean_colour(base, material.colour);
  material.roughness = static_cast<float>(base.roughness.value_or(material.roughness));
  material.translucency = static_cast<float>(base.translucency.value_or(material.translucency));
  material.opacity = static_cast<float>(base.opacity);
  const auto& is_sheet = prototype.type->is_sheet;
  if (is_sheet && is_sheet(prototype.parameters.get())) material.two_sided = true;
  material.texture = sketch_texture(base.texture, shape_of(prototype), material.colour);
  // If the document gives no colour, a picture keeps its own colours.
  const bool is_tinted = base.colour.has_value() || !base.colours.empty();
  if (base.texture.picture && !is_tinted) material.colour = srgb_from_linear(material.texture->mean);
  return material;
}

void paint_textures(const Graph& graph, std::vector<Material>& materials, Progress& progress, Cache* cache) {
  CacheRun results(cache, {typeid(Texture)});
  std::unordered_map<std::uint64_t, std::shared_ptr<const Texture>> painted;  // by fingerprint
  std::uint64_t pixels = 0;
  for (const Material& material : materials) pixels += pixels_to_paint(material);
  if (pixels > 0) progress.begin("painting textures", pixels);
  for (Material& material : materials) {
    const std::uint64_t own_pixels = pixels_to_paint(material);
    if (own_pixels == 0) continue;
    const std::uint64_t key = material.texture->fingerprint;
    std::shared_ptr<const Texture>& texture = painted[key];
    if (texture == nullptr) {
      texture = results.find<const Texture>(key);
      results.count<Texture>(texture != nullptr);
    }
    if (texture == nullptr) results.store(key, texture = painted_texture(component_of(material, graph), progress));
    material.texture = texture;
    progress.advance(own_pixels);
  }
  results.end();
}

Material blades_of(const Prototype& prototype) {
  Material material = prototype.type->blades.material;
  material.name = prototype.id + "_blades";
  if (prototype.type->blades.has_document_colours) material.colour = mean_colour(prototype.base(), material.colour);
  return material;
}

Tinting::Tinting(const Prototype& prototype) : variety_(prototype.base().variety.value_or(prototype.type->variety)) {
  const std::vector<Vec3>& colours = prototype.base().colours;
  if (colours.empty()) return;
  const Vec3 mean = glm::max(linear_mean(colours), Vec3(1e-4F));
  for (const Vec3 colour : colours) colours_.push_back(linear_from_srgb(colour) / mean);
}

Vec3 Tinting::tint(const ComponentBase& instance, RandomKey key) const {
  Vec3 tint = colours_.empty() ? Vec3(1) : factor_at(colours_, instance.colour_at.value_or(key.uniform(0)));
  if (variety_ > 0) {
    const double lighter = variety_ * (2 * key.uniform(1) - 1);
    const double yellower = kToneOfVariety * variety_ * (2 * key.uniform(2) - 1);
    const DVec3 shade = (1 + lighter) * DVec3(1 + yellower, 1, 1 - 0.45 * yellower);
    tint *= glm::max(Vec3(shade), Vec3(0));
  }
  return tint;
}

}  // namespace meristem
