// SPDX-License-Identifier: Apache-2.0
// The data that the sinks of one emitter share: the instance that is expanded, and the parts that are emitted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/component.h"
#include "meristem/graph/emitted.h"
#include "meristem/graph/emitter_context.h"
#include "meristem/grow/growth_trace.h"

namespace meristem {

/// The instance that an emitter expands. The emitter sets it, and its sinks read it.
struct PresentInstance {
  EmitterContext* context = nullptr;  ///< data of the batch, not null
  Emitted emitted{};                  ///< parts of all instances so far

  std::size_t index = 0;                                ///< index of the instance in its block
  Site site{};                                          ///< its site, with the instance's own frame
  Frame geometry_frame{};                               ///< its own frame, moved by `place`
  Vec3 tint{1};                                         ///< linear factors on the material's colour
  std::shared_ptr<const Surroundings> surroundings{};   ///< surroundings set by components above; null: not set
  const ComponentBase* base = nullptr;                  ///< its parameters
  bool is_placed = false;                               ///< true: `place` moves its geometry
  bool is_visible = true;                               ///< false: it has no visible geometry
  bool stands_as_grown = false;                         ///< true: its stems have grown up to the time of its clock
  std::uint32_t stem_count = 0;                         ///< number of stems that it has emitted
  std::uint64_t parent_section = 0;                     ///< section of a surface that it stands on, or 0
  std::uint64_t section = 0;                            ///< section of a surface that it has emitted, or 0
  std::shared_ptr<const GrowthTrace> watched_growth{};  ///< growth that it shows, or null

  const Prototype& prototype() const { return context->prototype; }
  /// Returns the time of its clock, seconds.
  double time() const { return site.clock.at(context->time); }
  /// Returns true if its stems grow over time.
  bool grows_in_time() const {
    return prototype().type->grows_in_time && context->animation != nullptr && context->animation->steps_per_second &&
           !context->growth_step;
  }
  /// Returns true if a plant begins with it.
  bool is_individual() const { return site.individual == site.key.bits(); }
  /// Returns its size relative to the world.
  float scale() const { return glm::length(site.frame.heading()); }
  /// Returns the path of its component in the document.
  std::string path() const { return "components." + prototype().id; }
};

/// Throws an InputError because a limit was exceeded. `message` contains the limit, but not the count, which depends on
/// other threads.
[[noreturn]] inline void throw_past_limit(std::string message, std::uint64_t limit, std::string_view limit_name,
                                          std::string path) {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = fmt::format("at most {} (limits.{})", limit, limit_name),
                              .path = std::move(path)});
}

}  // namespace meristem
