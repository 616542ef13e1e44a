// SPDX-License-Identifier: Apache-2.0
// The painted pictures that the page has. If only a colour changes, the page tints a picture that it has and needs no
// other.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "meristem/graph/graph.h"
#include "meristem/plant/material.h"

namespace meristem::studio {

/// The pictures that the page has of each material, with the colours for which they were painted. A material tints its
/// picture so that the mean becomes its colour. A picture of another colour is therefore reused: always during a drag,
/// and at rest if the difference from a picture of the new colour is invisible. Files never use these pictures.
class ShownPictures {
 public:
  /// Forgets all pictures, because the page has none any more.
  void clear() { shown_.clear(); }
  /// Replaces unpainted textures by the page's pictures for materials that differ from them only in colour.
  void lend(const Graph& graph, std::vector<Material>& materials) const;
  /// Replaces painted textures by the page's pictures if they look alike. Records the other textures as new pictures of
  /// the page. Returns true if any texture was replaced.
  bool keep(const Graph& graph, std::vector<Material>& materials);

 private:
  struct Shown {
    Material painted;            // material with the colour of the painting
    std::uint64_t compared = 0;  // fingerprint of the last picture that it was compared with
    bool is_alike = false;       // result of that comparison
  };

  std::map<std::string, Shown> shown_;  // by the material's name
};

/// Returns true if two textures, each tinted to the mean `colour` (sRGB), look alike to the eye.
bool look_alike(const Texture& one, const Texture& other, Vec3 colour);

}  // namespace meristem::studio
