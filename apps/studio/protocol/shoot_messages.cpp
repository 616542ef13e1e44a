// SPDX-License-Identifier: Apache-2.0
// Questions about visible instances, their shoots, and the effects of operations on trees.
#include <array>

#include "meristem/plant/plant.h"
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"

namespace meristem::studio {

namespace {

constexpr double kMaxFrameNumber = 1e9;
constexpr Span kStemNumber{.min = 0, .max = kNoStem - 1.0};

/// Reads three rows of [axes, origin].
void read_frame(InstanceRequest& request, const Value& value, const DocumentPath&) {
  for (std::size_t k = 0; k < 12; ++k) {
    const auto row = static_cast<int>(k / 4);
    const auto column = static_cast<int>(k % 4);
    float& number = column == 3 ? request.frame.origin[row] : request.frame.axes[column][row];
    store_value(number, (*value.list())[k]);
  }
}

const Record& instance_members() {
  static const Record record =
      RecordTable<InstanceRequest>("InstanceRequest", "Finds the instance that made a visible part.")
          .text("component", &InstanceRequest::component, "Id of the component.")
          .read("frame", forms::list(forms::number({-kMaxFrameNumber, kMaxFrameNumber}), 12, 12), read_frame,
                "Frame of the visible part, three rows of a 3x4 matrix. For stems: "
                "`[1,0,0,0, 0,1,0,0, 0,0,1,0]`.")
          .vector("position", &InstanceRequest::position, {-kMaxPosition, kMaxPosition, Unit::metre},
                  "Position on its surface, in the world.");
  return record;
}

const Record& instance_answer() {
  static const Record record = WrittenRecord("InstanceAnswer", "An instance.")
                                   .member("instance", forms::or_null(forms::record(instance_record)),
                                           "The instance. Null: unknown, as in plants of other documents.");
  return record;
}

const Record& shoot_name() {
  static const Record record =
      RecordTable<ShootRequest::Name>("ShootName", "The name of a shoot, and a metamer on it.")
          .whole("stem", &ShootRequest::Name::stem, kStemNumber, "Number of the stem among the component's stems.")
          .whole("tree", &ShootRequest::Name::tree, kStemNumber, "Number of its root among the roots of the stem.")
          .text("shoot", &ShootRequest::Name::shoot, "Label of the axis.")
          .whole("metamer", &ShootRequest::Name::metamer, kStemNumber, "Metamer, counted from the base of the axis.");
  return record;
}

const Record& shoot_members() {
  using Go = ShootRequest::Go;
  static const Record record =
      RecordTable<ShootRequest>("ShootRequest", "Finds a shoot by its name, or a neighbouring shoot.")
          .text("component", &ShootRequest::component, "Id of the component.")
          .record("of", &ShootRequest::of, shoot_name, "The shoot. Missing: the first shoot of the component.")
          .choice("go", &ShootRequest::go,
                  {{"parent", Go::parent}, {"child", Go::child}, {"next", Go::next}, {"previous", Go::previous}},
                  "Step to a neighbour. `child`: the first shoot at or above the metamer, or else the last. `next`, "
                  "`previous`: among the shoots of the parent, or among all stems, round and round. Missing: the shoot "
                  "itself.")
          .optional();
  return record;
}

const Record& operations_members() {
  static const Record record =
      RecordTable<OperationsRequest>("OperationsRequest", "Lists the effects of operations on trees.")
          .text("component", &OperationsRequest::component, "Id of the component.")
          .text("operation", &OperationsRequest::operation, "Path of an operation whose places are listed.")
          .optional()
          .whole("iteration", &OperationsRequest::iteration, {0, kMaxIteration},
                 "Iteration after which it acted. Missing: any.");
  return record;
}

const Record& operation_place() {
  static const Record record = WrittenRecord("OperationPlace", "One act of an operation.")
                                   .member("act", forms::text(), "Kind of the act.")
                                   .member("iteration", forms::whole(), "Iteration after which it acted.")
                                   .member("tree", forms::whole(), "Number of the tree.")
                                   .member("shoot", forms::text(), "Label of the shoot.")
                                   .member("metamer", forms::whole(), "Metamer on the shoot.")
                                   .member("position", forms::vector({.unit = Unit::metre}), "Position in the world.")
                                   .member("metamers", forms::whole(), "Number of removed metamers.")
                                   .member("course", forms::list(forms::vector({.unit = Unit::metre})),
                                           "Positions of the shoot in its present state.");
  return record;
}

const Record& operation_effects() {
  static const Record record =
      WrittenRecord("OperationEffects", "The effects of operations on the trees that have grown last.")
          .member("iteration", forms::or_null(forms::whole()),
                  "Iteration after which further operations would act. Null: the component has no operations.")
          .member("training", forms::or_null(forms::list(forms::any())),
                  "Operations of a training, whose paths end in `.training.operations[K]`. Null: no training.")
          .member("acts",
                  forms::list(forms::tuple({{"path", forms::text()},
                                            {"iteration", forms::whole()},
                                            {"act", forms::text()},
                                            {"count", forms::whole()}})),
                  "Number of acts of each operation, after each iteration.")
          .member("places", forms::list(forms::record(operation_place)),
                  "Acts of the requested operation, at most 2,000.")
          .member("left", forms::whole(), "Number of acts that are left out.");
  return record;
}

const Record& operations_answer() {
  static const Record record = WrittenRecord("OperationsAnswer", "The effects of operations.")
                                   .member("operations", forms::or_null(forms::record(operation_effects)),
                                           "The effects. Null: there is no such component.");
  return record;
}

}  // namespace

ProtocolGroup shoot_messages() {
  using enum AnswerTime;
  return {.name = "shoots",
          .doc = "Questions about visible instances, their shoots, and the effects of operations on trees.",
          .requests = {request_type<InstanceRequest>("instance", later, instance_members, instance_answer),
                       request_type<ShootRequest>("shoot", later, shoot_members, instance_answer),
                       request_type<OperationsRequest>("operations", later, operations_members, operations_answer)}};
}

}  // namespace meristem::studio
