// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "protocol/protocol.h"

namespace meristem::studio {

/// The records that one subject describes first. Records that an earlier subject uses belong to that subject.
struct GroupRecords {
  const ProtocolGroup* group = nullptr;
  std::vector<const Record*> records{};  ///< each once, after the records of its members
};

/// Returns the records of all subjects, in their order.
std::vector<GroupRecords> records_by_group();

/// Calls `visit` for all records that a form uses directly.
template <class Visit>
void for_each_record(const Form& form, Visit visit) {
  for (const Form& part : form.parts) for_each_record(part, visit);
  for (const RecordFunction record : form.records) visit(record());
}

/// Returns true if an object of this record has no members.
inline bool is_empty(const Record& record) { return record.members.empty() && record.parts.empty(); }

}  // namespace meristem::studio
