// SPDX-License-Identifier: Apache-2.0
// Traces how a grammar became a plant: the word of one step, and the positions at which the turtle drew its modules.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/graph/graph.h"
#include "meristem/grow/lsystem/word.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The position of a drawn module.
struct DrawnModule {
  std::uint32_t module = 0;  ///< index in the drawn word
  Vec3 from{0};              ///< begin of a segment or polygon; metres, in world space
  Vec3 to{0};  ///< end of a segment, or centre of a polygon's corners; equals `from` for a placed component

  bool operator==(const DrawnModule&) const = default;
};

/// The requested instance and step.
struct LsystemTraceRequest {
  std::optional<int> steps{};          ///< number of steps; unset: the instance's own
  std::optional<std::uint64_t> key{};  ///< bits of the key of the instance's site; unset or unknown: `number` is used
  std::size_t number = 0;              ///< number of the instance; too large: the last one
};

/// One instance of an lsystem component after a number of steps.
struct LsystemTrace {
  Site site;                        ///< site of the instance
  std::size_t number = 0;           ///< number among all instances of the component
  std::size_t count = 0;            ///< number of instances of the component
  std::string text;                 ///< text of the grammar, as it was read
  int steps = 0;                    ///< number of steps of the instance itself
  Alphabet alphabet;                ///< alphabet of both words
  Word derived;                     ///< word after the requested steps
  Word drawn;                       ///< the derived word after interpretation, as the turtle draws it
  bool is_interpreted = false;      ///< true if the grammar has interpretation rules
  std::vector<DrawnModule> places;  ///< by rising module; in undeformed space, before `finish`
};

/// Traces an instance of the component with this id. Instances are ordered by their number of recursions, then by their
/// numbers among siblings. Random numbers equal the numbers of the plant's growth. Returns nothing if the component has
/// no instance or is no lsystem. Throws what expand(), derive() and draw() throw.
std::optional<LsystemTrace> trace_lsystem(const Graph& graph, const Scene& scene, const std::string& id,
                                          const LsystemTraceRequest& request, double time, Progress& progress);

}  // namespace meristem
