// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "meristem/plant/mtg/mtg.h"
#include "meristem/plant/mtg/mtg_text.h"

namespace meristem {

/// The declarations of an MTG file before its entities.
struct MtgHeader {
  std::vector<MtgClass> classes;  ///< the first class is the scene
  std::vector<MtgFeature> features;
  std::map<std::string, std::uint32_t, std::less<>> class_by_name;
  std::map<std::string, std::uint32_t, std::less<>> feature_by_name;
};

/// Returns the name in a map that is nearest to an unknown name. Empty if the map is too large to compare.
template <class Map>
std::string nearest_known(std::string_view name, const Map& known) {
  constexpr std::size_t kMaxCompared = 1000;
  if (known.size() > kMaxCompared) return {};
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const auto& [candidate, value] : known) names.push_back(candidate);
  return nearest_name(name, names);
}

/// The largest number of scales that a file may use.
inline constexpr int kDeepestMtgScale = 32;

/// Reads the sections CODE, CLASSES, DESCRIPTION and FEATURES up to and including the line `MTG:`.
MtgHeader read_mtg_header(MtgLines& lines, MtgErrors& errors);

}  // namespace meristem
