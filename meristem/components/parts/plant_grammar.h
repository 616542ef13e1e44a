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
  std::vector<PlacedComponent> placed;          ///< those that a ~ names
  std::vector<std::uint32_t> placed_of_letter;  ///< by letter: index into them, kNoIndex for most
};

/// Reads a grammar's text as the table of a component does: with the document's variables, and files that it includes
/// sought beside `path`. Throws InputError for its faults, by line and column.
PlantGrammar read_plant_grammar(const std::string& text, const std::string& path, ParameterReader& reader,
                                std::vector<Diagnostic>& warnings);

}  // namespace meristem
