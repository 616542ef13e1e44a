// SPDX-License-Identifier: Apache-2.0
#include "small_textures.h"

#include <algorithm>
#include <utility>

#include "meristem/base/parallel.h"
#include "thumbnail.h"

namespace meristem::studio {

namespace {

bool is_larger(const Image& image, int size) { return std::max(image.width, image.height) > size; }

/// Returns true if a material has a painted texture with more than `size` pixels along a side.
bool wears_larger(const Material& material, int size) {
  const Texture* const texture = material.texture.get();
  return texture != nullptr && texture->is_painted() &&
         (is_larger(texture->colour, size) || is_larger(texture->normals, size));
}

}  // namespace

void SmallTextures::fit(const std::vector<std::vector<Material>*>& lists, int size, const Progress& progress) {
  const std::map<const Texture*, Small> before = size == size_ ? std::exchange(known_, {}) : decltype(known_)();
  known_.clear();
  size_ = size;

  // Collects the textures in use, each once: known ones, and new ones that must be made.
  std::vector<Small*> fresh;
  for (const std::vector<Material>* const materials : lists) {
    for (const Material& material : *materials) {
      if (!wears_larger(material, size)) continue;
      const auto [place, is_new] = known_.try_emplace(material.texture.get());
      if (!is_new) continue;
      const auto found = before.find(material.texture.get());
      place->second = found != before.end() ? found->second : Small{.whole = material.texture, .small = nullptr};
      if (found == before.end()) fresh.push_back(&place->second);
    }
  }
  parallel_for(fresh.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      progress.check();
      const Texture& whole = *fresh[k]->whole;
      fresh[k]->small =
          std::make_shared<const Texture>(Texture{.name = whole.name,
                                                  .colour = shrunk(whole.colour, size, PixelKind::srgb),
                                                  .normals = shrunk(whole.normals, size, PixelKind::numbers),
                                                  .mean = whole.mean,
                                                  .masked = whole.masked,
                                                  .fingerprint = whole.fingerprint});
    }
  });

  for (std::vector<Material>* const materials : lists) {
    for (Material& material : *materials) {
      const auto found = known_.find(material.texture.get());
      if (found != known_.end()) material.texture = found->second.small;
    }
  }
}

}  // namespace meristem::studio
