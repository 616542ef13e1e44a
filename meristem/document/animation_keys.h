// SPDX-License-Identifier: Apache-2.0
// The keys of a document's animation: {"keys": {"stem.length": [[0, 0.05], [4, 1.8, "smooth"]]}}. If a parameter may
// differ from instance to instance, it follows each instance's own clock, and its keys replace its value in the tree.
// Any other parameter has one value for the document: the value of its keys at the document's time.
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/graph.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// A parameter that has keys.
struct KeyedParameter {
  std::string name;  ///< name in the animation: "stem.length"
  std::string path;  ///< path of the value in the document: "components.stem.length"
  KeyClock clock = KeyClock::document;
  double last_time = 0;  ///< time of its last key, seconds
};

/// Puts the keys of variables, or the keys of everything else, into the tree of a document, as of `time`. The rest of
/// the tree may have faults. Faults of the keys are reported to `reader`.
std::vector<KeyedParameter> put_variable_keys(Value& root, double time, ParameterReader& reader);
std::vector<KeyedParameter> put_other_keys(Value& root, const Registry& registry, double time, ParameterReader& reader);

/// Reports keys that come after the animation's end. Also reports keys of parameters that have one value for the
/// document although instances have their own clocks there. The graph's structure must be sound.
void check_key_clocks(const std::vector<KeyedParameter>& keyed, const Graph& graph,
                      std::vector<Diagnostic>& diagnostics);

}  // namespace meristem
