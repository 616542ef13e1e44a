// SPDX-License-Identifier: Apache-2.0
// Lists the effects of operations on a component's trees, from the records of its skeletons. The list has counts of all
// acts, and the positions of the requested operation with the courses of their shoots.
#include "operation_values.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "meristem/components/expanded.h"
#include "meristem/export/packet/short_values.h"
#include "meristem/plant/axis_labels.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kMaxPlaces = 2000;   // maximum number of positions per operation
constexpr std::size_t kMaxCourse = 60000;  // maximum number of points of their shoots

/// Returns the points of each axis of a stem that one of these records names, in its present state; at most `max`
/// points.
std::map<ShootName, Value::List> courses_of(const Stem& stem, const std::vector<OperationRecord>& records,
                                            std::size_t& max) {
  std::map<ShootName, Value::List> courses;
  for (const OperationRecord& record : records) courses[{record.part, record.tree, record.shoot}];
  const Skeleton& skeleton = stem.skeleton;
  std::vector<Value::List*> course_of_axis;
  for (const ShootName& name : shoot_names(skeleton, stem.part_of_axis)) {
    const auto found = courses.find(name);
    course_of_axis.push_back(found == courses.end() ? nullptr : &found->second);
  }
  for (NodeIndex node = 0; node < skeleton.node_count() && max > 0; ++node) {
    Value::List* const course = course_of_axis[skeleton.axis[node]];
    if (course == nullptr) continue;
    if (course->empty() && !skeleton.is_root(node)) {
      course->push_back(vector_value(skeleton.position[skeleton.parent[node]]));
    }
    course->push_back(vector_value(skeleton.position[node]));
    --max;
  }
  return courses;
}

Value place_value(const OperationRecord& record, const Value::List& course) {
  return Value::Object{{"act", record.act},
                       {"iteration", record.iteration},
                       {"tree", static_cast<double>(record.tree)},
                       {"shoot", record.shoot},
                       {"metamer", static_cast<double>(record.metamer)},
                       {"position", vector_value(record.position)},
                       {"metamers", static_cast<double>(record.metamers)},
                       {"course", course}};
}

}  // namespace

Value operations_value(const GrownPlant& grown, const OperationsRequest& request, const Progress& progress) {
  const auto prototype = std::ranges::find(grown.document->graph.components, request.component, &Prototype::id);
  if (prototype == grown.document->graph.components.end()) return {};
  const std::optional<int> last = last_iteration(*prototype);

  const std::string own = "components." + request.component + ".";
  std::map<std::tuple<std::string, int, std::string>, double> counts;
  Value::List places;
  std::size_t chosen = 0;
  std::size_t max = kMaxCourse;
  // Each stem has its own trees, and trees of different stems may have equal names.
  for (const Stem& stem : grown.plant.stems) {
    progress.check();
    std::vector<OperationRecord> told;
    for (const OperationRecord& record : stem.skeleton.operations) {
      if (!record.operation.starts_with(own)) continue;
      counts[{record.operation, record.iteration, record.act}] += 1;
      const bool is_asked =
          record.operation == request.operation && (!request.iteration || *request.iteration == record.iteration);
      if (!is_asked) continue;
      ++chosen;
      if (chosen <= kMaxPlaces) told.push_back(record);
    }
    if (told.empty()) continue;
    const std::map<ShootName, Value::List> courses = courses_of(stem, told, max);
    for (const OperationRecord& record : told) {
      places.push_back(place_value(record, courses.at({record.part, record.tree, record.shoot})));
    }
  }
  Value::List acts;
  for (const auto& [what, count] : counts)
    acts.push_back(Value::List{std::get<0>(what), std::get<1>(what), std::get<2>(what), count});
  const auto left = static_cast<double>(chosen - places.size());
  // Not written as `condition ? Value(x) : Value()`: GCC 12 then warns of an uninitialised string at -O1.
  Value iteration;
  if (last) iteration = *last;
  return Value::Object{{"iteration", std::move(iteration)},
                       {"training", expanded_training(*prototype)},
                       {"acts", std::move(acts)},
                       {"places", std::move(places)},
                       {"left", left}};
}

}  // namespace meristem::studio
