// SPDX-License-Identifier: Apache-2.0
// Which painted pictures the page is shown, so that a colour that only tints those which it has sends no other.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "meristem/graph/graph.h"
#include "meristem/plant/material.h"

namespace meristem::studio {

/// The picture that the page has of each material, and the colour for which it was painted. A material tints its
/// picture so that the mean is its colour; so a picture that was painted for another colour does for a new one, too:
/// always while a hand drags, and at rest where nobody sees the difference from the one that is painted for the new
/// colour. What files hold is never one of these.
class ShownPictures {
 public:
  /// The page has none any more.
  void clear() { shown_.clear(); }
  /// Has materials that wait for their painting wear what the page has, where only the colour is another one.
  void lend(const Graph& graph, std::vector<Material>& materials) const;
  /// Has painted materials wear what the page has, where it looks the same; takes note of all others. Whether there was
  /// any such.
  bool keep(const Graph& graph, std::vector<Material>& materials);

 private:
  struct Shown {
    Material painted;            // with the colour that it was painted for
    std::uint64_t compared = 0;  // fingerprint of the last picture that it was compared with
    bool is_alike = false;       // what came out
  };

  std::map<std::string, Shown> shown_;  // by the material's name
};

/// Whether two textures, each tinted to the same mean `colour` (sRGB), cannot be told apart by eye.
bool look_alike(const Texture& one, const Texture& other, Vec3 colour);

}  // namespace meristem::studio
