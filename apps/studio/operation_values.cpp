// SPDX-License-Identifier: Apache-2.0
#include "operation_values.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "meristem/components/expanded.h"
#include "meristem/output/skeleton/operation_csv.h"
#include "meristem/plant/axis_labels.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kMostPlaces = 2000;   // that are told of an operation
constexpr std::size_t kMostCourse = 60000;  // positions of their shoots

using ShootName = std::pair<std::uint32_t, std::string>;  // number of the tree, label

Value point_value(Vec3 v) { return Value::List{v.x, v.y, v.z}; }

/// The positions of shoots of a component that stand now.
std::map<ShootName, Value::List> courses_of(const Plant& plant, const std::string& component,
                                            std::map<ShootName, Value::List> wanted, const Progress& progress) {
  std::size_t positions = 0;
  for (const Stem& stem : plant.stems) {
    progress.check();
    const Skeleton& skeleton = stem.skeleton;
    const std::vector<std::string> labels = axis_labels(skeleton);
    std::vector<Value::List*> course_of_axis(labels.size(), nullptr);
    std::vector<std::uint32_t> tree(skeleton.node_count());
    std::uint32_t trees = 0;
    for (NodeIndex node = 0; node < skeleton.node_count() && positions < kMostCourse; ++node) {
      const AxisIndex axis = skeleton.axis[node];
      const bool is_own = stem.part(axis).component == component;
      if (skeleton.is_root(node)) tree[node] = is_own ? trees++ : 0;
      if (!skeleton.is_root(node)) tree[node] = tree[skeleton.parent[node]];
      if (!is_own) continue;
      Value::List*& course = course_of_axis[axis];
      if (course == nullptr) {
        const auto found = wanted.find({tree[node], labels[axis]});
        if (found == wanted.end()) continue;
        course = &found->second;
        if (!skeleton.is_root(node)) course->push_back(point_value(skeleton.position[skeleton.parent[node]]));
      }
      course->push_back(point_value(skeleton.position[node]));
      ++positions;
    }
  }
  return wanted;
}

}  // namespace

Value operations_value(const GrownWish& grown, const OperationsRequest& request, const Progress& progress) {
  const auto prototype = std::ranges::find(grown.document->graph.components, request.component, &Prototype::id);
  if (prototype == grown.document->graph.components.end()) return {};
  const std::optional<int> last = last_iteration(*prototype);

  const std::string own = "components." + request.component + ".";
  std::map<std::tuple<std::string, int, std::string>, double> counts;
  std::vector<OperationRecord> chosen;
  for (OperationRecord& record : operation_records(grown.plant)) {
    if (!record.operation.starts_with(own)) continue;
    counts[{record.operation, record.iteration, record.act}] += 1;
    const bool is_asked =
        record.operation == request.operation && (!request.iteration || *request.iteration == record.iteration);
    if (is_asked) chosen.push_back(std::move(record));
  }
  Value::List acts;
  for (const auto& [what, count] : counts)
    acts.push_back(Value::List{std::get<0>(what), std::get<1>(what), std::get<2>(what), count});

  const std::size_t told = std::min(chosen.size(), kMostPlaces);
  std::map<ShootName, Value::List> courses;
  for (std::size_t k = 0; k < told; ++k) courses[{chosen[k].tree, chosen[k].shoot}];
  if (!courses.empty()) courses = courses_of(grown.plant, request.component, std::move(courses), progress);
  Value::List places;
  for (std::size_t k = 0; k < told; ++k) {
    const OperationRecord& record = chosen[k];
    places.push_back(Value::Object{{"act", record.act},
                                   {"iteration", record.iteration},
                                   {"tree", static_cast<double>(record.tree)},
                                   {"shoot", record.shoot},
                                   {"metamer", static_cast<double>(record.metamer)},
                                   {"position", point_value(record.position)},
                                   {"metamers", static_cast<double>(record.metamers)},
                                   {"course", courses[{record.tree, record.shoot}]}});
  }
  return Value::Object{{"iteration", last ? Value(*last) : Value()},
                       {"acts", std::move(acts)},
                       {"places", std::move(places)},
                       {"left", static_cast<double>(chosen.size() - told)}};
}

}  // namespace meristem::studio
