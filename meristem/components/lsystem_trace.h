// SPDX-License-Identifier: Apache-2.0
// How a grammar became a plant: the word of one step, and where the turtle drew each of its modules.
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

/// Where a module of a word was drawn.
struct DrawnModule {
  std::uint32_t module = 0;  ///< index in the word that was drawn
  Vec3 from{0};              ///< metres, in world space: where a segment or a polygon begins
  Vec3 to{0};  ///< where the segment ends, or the middle of the polygon's corners; a placed component's is `from`

  bool operator==(const DrawnModule&) const = default;
};

/// What is asked about.
struct LsystemTraceWish {
  std::optional<int> steps{};          ///< in place of the instance's own
  std::optional<std::uint64_t> key{};  ///< the bits of the key of the instance's site; unset, or of none: see `number`
  std::size_t number = 0;              ///< of the instance among all, where no key says it; beyond the last: the last
};

/// One instance of an lsystem component after a number of steps.
struct LsystemTrace {
  Site site;                        ///< of the instance
  std::size_t number = 0;           ///< of the instance among all of the component
  std::size_t count = 0;            ///< instances of the component
  std::string text;                 ///< of the grammar, as it was read
  int steps = 0;                    ///< that the instance itself would take
  Alphabet alphabet;                ///< of both words
  Word derived;                     ///< word after the steps that were asked about
  Word drawn;                       ///< the same with interpretation rules applied: what the turtle draws
  bool is_interpreted = false;      ///< whether there are such rules
  std::vector<DrawnModule> places;  ///< by rising module; in undeformed space, before `finish` moves anything
};

/// Traces an instance of the component with this id. Instances are counted from those with the fewest recursions behind
/// them, and by their numbers among their siblings. The draws are those that the plant grows by. Nothing where the
/// component has no instance, or is no lsystem. Throws what expand, derive and draw throw.
std::optional<LsystemTrace> trace_lsystem(const Graph& graph, const Scene& scene, const std::string& id,
                                          const LsystemTraceWish& wish, double time, Progress& progress);

}  // namespace meristem
