// SPDX-License-Identifier: Apache-2.0
#include "protocol/record_order.h"

#include <set>

namespace meristem::studio {

namespace {

/// Adds a record after the records of its members. Records never contain themselves.
void add(const Record& record, std::set<const Record*>& known, std::vector<const Record*>& records) {
  if (!known.insert(&record).second) return;
  for (const Record::Part& part : record.parts) add(part.record(), known, records);
  for (const Member& member : record.members)
    for_each_record(member.form, [&](const Record& nested) { add(nested, known, records); });
  if (!is_empty(record)) records.push_back(&record);
}

}  // namespace

std::vector<GroupRecords> records_by_group() {
  std::set<const Record*> known;
  std::vector<GroupRecords> groups;
  for (const ProtocolGroup& group : protocol()) {
    GroupRecords& own = groups.emplace_back(GroupRecords{.group = &group});
    for (const RecordFunction other : group.others) add(other(), known, own.records);
    for (const RequestType& request : group.requests) {
      add(request.members(), known, own.records);
      add(request.answer(), known, own.records);
    }
    for (const MessageType& message : group.messages) add(message.members(), known, own.records);
  }
  return groups;
}

}  // namespace meristem::studio
