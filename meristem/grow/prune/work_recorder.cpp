// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/prune/work_recorder.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "meristem/base/math.h"

namespace meristem {

std::vector<WorkRecorder::Noted> WorkRecorder::note(const OperationWork& work) const {
  const Metamers& metamers = tree_.metamers;
  std::vector<Noted> noted;
  for (const AxisIndex axis : work.marked) noted.push_back(at_base(metamers.axes[axis].first, "mark"));
  for (const Ring& ring : work.rings) noted.push_back(at_base(ring.metamer, "ring"));
  for (const Bow& bow : work.bows) {
    noted.push_back(bow.toward ? at_end(bow.last, "tie") : at_base(bow.first, "bend"));
  }
  for (const MetamerIndex metamer : work.pinched) {
    if (metamers.terminal[metamer].is_open()) noted.push_back(at_end(metamer, "disbud"));
  }
  for (const MetamerIndex metamer : work.lifted) {
    if (metamers.lateral[metamer].is_open()) noted.push_back(at_end(metamer, "disbud"));
  }
  // A removal inside another removal is not recorded separately. Inner removals are beyond the outer ones and have
  // larger indices.
  std::vector<MetamerIndex> gone = work.gone;
  std::ranges::sort(gone);
  std::unordered_set<MetamerIndex> told;
  std::vector<MetamerIndex> beyond;
  for (const MetamerIndex first : gone) {
    if (told.count(first) != 0) continue;
    noted.push_back(cut(first, beyond));
    if (gone.size() > 1) told.insert(beyond.begin(), beyond.end());
  }
  return noted;
}

/// Returns a record at the end of a metamer, on its shoot.
WorkRecorder::Noted WorkRecorder::at_end(MetamerIndex metamer, const char* act) const {
  const Metamers& metamers = tree_.metamers;
  const AxisIndex axis = metamers.axis[metamer];
  const Bud lateral = metamers.lateral[metamer];
  const Vec3 bud = lateral.is_open() || lateral.is_grown() ? metamers.side[metamer] : Vec3(0);
  const double radius = radius_of_(metamer);
  return {metamer,
          {.operation = operation_.path,
           .act = act,
           .iteration = tree_.iteration,
           .tree = number_,
           .shoot = metamers.name_of(axis),
           .rank = tree_.leads.rank[axis],
           .metamer = metamers.number[metamer],
           .position = metamers.tip[metamer],
           .bud = bud,
           .bud_position = metamers.tip[metamer] + static_cast<float>(radius) * bud,
           .diameter = 2 * radius}};
}

/// Returns a record at the base of a metamer. If the metamer begins a shoot, the record belongs to that shoot.
WorkRecorder::Noted WorkRecorder::at_base(MetamerIndex first, const char* act) const {
  const Metamers& metamers = tree_.metamers;
  if (first == 0) return at_end(0, act);  // at the begin of the stem
  Noted noted = at_end(metamers.parent[first], act);
  noted.record.diameter = 2 * radius_of_(first);
  if (!metamers.begins_shoot(first)) return noted;
  noted.record.shoot = metamers.name_of(metamers.axis[first]);
  noted.record.rank = tree_.leads.rank[metamers.axis[first]];
  noted.record.metamer = 0;
  noted.record.bud = Vec3(0);
  noted.record.bud_position = noted.record.position;
  return noted;
}

/// Returns the record of a cut that removes `first`. Sets `beyond` to all removed metamers.
WorkRecorder::Noted WorkRecorder::cut(MetamerIndex first, std::vector<MetamerIndex>& beyond) const {
  const Metamers& metamers = tree_.metamers;
  Noted noted = at_base(first, "cut");
  beyond = metamers.with_borne(first);
  // Sort by index, so that the rounding of sums does not depend on the search order.
  std::ranges::sort(beyond);
  OperationRecord& record = noted.record;
  record.metamers = static_cast<std::uint32_t>(beyond.size());
  for (std::size_t k = beyond.size(); k-- > 0;) {
    const double length = metamers.length(beyond[k]);
    const double radius = radius_of_(beyond[k]);
    record.length += length;
    noted.section = kPi * radius * radius;
    record.wood += noted.section * length;
  }
  if (first < tree_.flow.light.size()) record.light = tree_.flow.light[first];
  return noted;
}

}  // namespace meristem
