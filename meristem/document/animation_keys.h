// SPDX-License-Identifier: Apache-2.0
// The keys of a document's animation: {"keys": {"stem.length": [[0, 0.05], [4, 1.8, "smooth"]]}}. A parameter that may
// differ from instance to instance follows each instance's own clock; keys of such a one stand in the tree in place of
// its value. All others are one value for the document, and have the value that their keys give at the document's time.
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/graph.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// A parameter that has been given keys.
struct KeyedParameter {
  std::string name;  ///< as the animation names it: "stem.length"
  std::string path;  ///< of the value in the document: "components.stem.length"
  KeyClock clock = KeyClock::document;
  double last_time = 0;  ///< of its keys, seconds
};

/// Puts what the keys of variables say at `time`, or what all others say, into the tree of a document that may be
/// faulty in every other way. `reader` gets the faults of the keys.
std::vector<KeyedParameter> put_variable_keys(Value& root, double time, ParameterReader& reader);
std::vector<KeyedParameter> put_other_keys(Value& root, const Registry& registry, double time, ParameterReader& reader);

/// Adds a fault for keys that come after the animation's end, and for those of parameters that are one value for the
/// document though clocks of their own run where they stand. The graph's structure is sound.
void check_key_clocks(const std::vector<KeyedParameter>& keyed, const Graph& graph,
                      std::vector<Diagnostic>& diagnostics);

}  // namespace meristem
