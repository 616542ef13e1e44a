// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/graph/component.h"
#include "meristem/graph/table/plant_source.h"

namespace meristem {

/// A value that is set in another document.
struct SetNumber {
  double value = 0;
  double min = 0, max = 0;  ///< range of the value in that document
};

/// A whole plant from another document.
struct Subdocument : ComponentBase {
  std::string file;
  std::vector<std::pair<std::string, SetNumber>> set;
  std::optional<double> seed;   ///< unset: each instance has its own seed
  std::optional<int> variants;  ///< number of seeds; each instance uses one of them
  std::shared_ptr<const PlantSource> source;
};

ComponentType subdocument_component();

}  // namespace meristem
