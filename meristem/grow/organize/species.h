// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// What all self-organizing trees of one component have in common.
struct OrganizedSpecies {
  OrganizeParameters parameters;
  const Scene& scene;
  Limits limits;
  std::string component;
  Directions directions;  ///< of light and gravity where it stands

  /// Whether an operation acts in the summer of an iteration; of any iteration without one.
  bool has_summer(std::optional<int> iteration = std::nullopt) const;
  /// Rounds of the stand for each iteration.
  int rounds() const;
  /// Whether buds look for light and room in a round, from 0.
  bool looks(int round) const;
  /// The path of a parameter in the document.
  std::string path(const std::string& parameter) const;
  /// Throws an InputError at a parameter.
  [[noreturn]] void refuse(const std::string& parameter, std::string message, std::string expected,
                           std::string nearest = {}) const;
};

}  // namespace meristem
