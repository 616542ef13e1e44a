// SPDX-License-Identifier: Apache-2.0
// The kinds of files that a plan can ask for of each plant, by their endings: an open list.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// A plant in hand, of which files are written.
struct PlantInHand {
  const Document& document;    ///< the document with the plant's values
  const GrownDocument& grown;  ///< up to what the output needs
  const Value& settings;       ///< what the plan says beside the ending, as the output's table has it; null: nothing
};

/// A kind of file.
struct PlantOutput {
  std::string ending;                  ///< with its dot
  std::string doc;                     ///< one sentence
  GrownPart needs = GrownPart::plant;  ///< the stage up to which the plant must have grown
  TraceWish wish{};                    ///< what must be recorded of growth for it
  /// Writes the file at `path`, and what belongs to it beside it.
  std::function<void(const PlantInHand& plant, const std::string& path, Progress& progress)> write;
  /// What the plan may say beside the ending; null: nothing.
  const ParameterTable& (*settings)() = nullptr;
  /// Checks the settings beyond their table; null: there is no more to check. Throws InputError.
  std::function<void(const Value& settings)> check = {};
};

/// All kinds: the formats that grown documents are written in, and what else makes files of plants.
std::span<const PlantOutput> plant_outputs();

/// The kind of that ending, or null.
const PlantOutput* find_plant_output(const std::string& ending);

}  // namespace meristem
