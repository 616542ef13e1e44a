// SPDX-License-Identifier: Apache-2.0
// The kinds of files that a plan can request for each plant, selected by their endings. The list can be extended.
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

/// A grown plant whose files are being written.
struct PlantInHand {
  const Document& document;    ///< the document with the plant's values
  const GrownDocument& grown;  ///< grown up to the stage that the output needs
  const Value& settings;       ///< settings beside the ending in the plan, completed by the output's table; null: no
                               ///< settings
};

/// A kind of file.
struct PlantOutput {
  std::string ending;                  ///< with its dot
  std::string doc;                     ///< one sentence
  GrownPart needs = GrownPart::plant;  ///< the stage up to which the plant must have grown
  TraceRequest request{};              ///< records of growth that the file needs
  /// Writes the file at `path`, and further files that belong to it beside it.
  std::function<void(const PlantInHand& plant, const std::string& path, Progress& progress)> write;
  /// Returns the table of the settings beside the ending. Null: no settings are allowed.
  const ParameterTable& (*settings)() = nullptr;
  /// Checks the settings beyond their table. Null: the table is sufficient. Throws InputError.
  std::function<void(const Value& settings)> check = {};
};

/// Returns all kinds: the formats of grown documents, and all other kinds of files of plants.
std::span<const PlantOutput> plant_outputs();

/// Returns the kind with this ending, or null.
const PlantOutput* find_plant_output(const std::string& ending);

}  // namespace meristem
