// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The common data of all self-organizing trees of one component.
struct OrganizedSpecies {
  OrganizeParameters parameters;
  const Scene& scene;
  SizeLimits limits;
  std::string component;
  Directions directions;  ///< of light and gravity at its place

  /// Returns true if an operation acts in the summer of `iteration`, or of any iteration if it is not given.
  bool has_summer(std::optional<int> iteration = std::nullopt) const;
  /// Returns the number of rounds of the stand per iteration.
  int rounds() const;
  /// Returns true if buds search for light and space in a round, counted from 0.
  bool looks(int round) const;
  /// Returns the path of a parameter in the document.
  std::string path(const std::string& parameter) const;
  /// Throws an InputError at a parameter.
  [[noreturn]] void refuse(const std::string& parameter, std::string message, std::string expected,
                           std::string nearest = {}) const;
};

}  // namespace meristem
