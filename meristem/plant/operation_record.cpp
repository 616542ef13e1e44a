// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/operation_record.h"

#include "meristem/base/frame.h"

namespace meristem {

void move_record(OperationRecord& record, const Frame& frame, float scale) {
  record.position = frame.point(record.position);
  record.bud = normalized_or(frame.axes * record.bud, Vec3(0));
  record.bud_position = frame.point(record.bud_position);
  record.diameter *= scale;
  record.length *= scale;
  record.wood *= double{scale} * scale * scale;
}

}  // namespace meristem
