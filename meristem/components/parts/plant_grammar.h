// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/component.h"
#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

/// A grammar with the components that it places.
struct PlantGrammar {
  std::string text;  ///< as it was read
  Grammar grammar;
  std::vector<PlacedComponent> placed;          ///< components named after a ~
  std::vector<std::uint32_t> placed_of_letter;  ///< by letter: index into `placed`, or kNoIndex
};

/// Reads the grammar of a component. It may use the document's variables, and included files are relative to the folder
/// of `path`. Throws InputError for its errors, with line and column.
PlantGrammar read_plant_grammar(const std::string& text, const std::string& path, ParameterReader& reader,
                                std::vector<Diagnostic>& warnings);

}  // namespace meristem
