// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/vec.h"

namespace meristem {

struct Frame;

/// One thing that people did to a tree as it grew, or would do now.
struct OperationRecord {
  std::string operation;      ///< path of the operation in the document: "components.apple.operations[3]"
  std::string act;            ///< what was done: "cut", "disbud", "ring", "bend", "tie" or "mark"
  int iteration = 0;          ///< after whose growth
  std::uint32_t tree = 0;     ///< number of the root
  std::string shoot;          ///< label of the axis where it was done, as axis_labels() gives it
  int rank = 0;               ///< 0 the leader, 1 what stands on it, and so on
  std::uint32_t metamer = 0;  ///< number on that axis of the metamer at whose end it was done; 0 at a shoot's base
  Vec3 position{0};           ///< the end of that metamer, metres
  Vec3 bud{0};                ///< unit vector to the living lateral bud there; 0 where there is none
  Vec3 bud_position{0};       ///< that bud on the bark, metres; `position` where there is none
  double diameter = 0;        ///< metres, of the wood that is cut through, or of the shoot where all else is done
  std::uint32_t part = 0;     ///< of the stem that it was done to, where stems are joined: Stem::parts
  // What was taken away; 0 for all else.
  std::uint32_t metamers = 0;
  double length = 0;  ///< metres
  double wood = 0;    ///< cubic metres
  double light = 0;   ///< of its buds

  bool operator==(const OperationRecord&) const = default;
};

/// Moves what a record says of positions, lengths and volumes into a frame that enlarges all by `scale`.
void move_record(OperationRecord& record, const Frame& frame, float scale);

}  // namespace meristem
