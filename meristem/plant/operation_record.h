// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/vec.h"

namespace meristem {

struct Frame;

/// One operation that people did to a tree while it grew, or that is planned.
struct OperationRecord {
  std::string operation;      ///< path of the operation in the document: "components.apple.operations[3]"
  std::string act;            ///< what was done: "cut", "disbud", "ring", "bend", "tie" or "mark"
  int iteration = 0;          ///< the operation was done after this iteration
  std::uint32_t tree = 0;     ///< number of the root
  std::string shoot;          ///< label of the axis where it was done, as axis_labels() gives it
  int rank = 0;               ///< 0 the leader, 1 what stands on it, and so on
  std::uint32_t metamer = 0;  ///< number, on that axis, of the metamer at whose end it was done; 0 at a shoot's base
  Vec3 position{0};           ///< the end of that metamer, metres
  Vec3 bud{0};                ///< unit vector to the living lateral bud there; 0 if there is none
  Vec3 bud_position{0};       ///< position of that bud on the bark, metres; `position` if there is none
  double diameter = 0;        ///< metres; diameter of the cut wood, or of the shoot for other operations
  std::uint32_t part = 0;     ///< index into Stem::parts of the part that it was done to, if stems are joined
  // Amounts removed; 0 for operations that remove nothing.
  std::uint32_t metamers = 0;  ///< number of metamers
  double length = 0;           ///< metres
  double wood = 0;             ///< cubic metres
  double light = 0;            ///< light that the removed buds received

  bool operator==(const OperationRecord&) const = default;
};

/// Transforms the positions, lengths and volumes of a record into `frame`, which enlarges lengths by `scale`.
void move_record(OperationRecord& record, const Frame& frame, float scale);

}  // namespace meristem
