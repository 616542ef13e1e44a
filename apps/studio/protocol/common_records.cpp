// SPDX-License-Identifier: Apache-2.0
#include "protocol/common_records.h"

#include "protocol/record_table.h"
#include "request.h"

namespace meristem::studio {

using namespace forms;

namespace {

const Record& variable_record() {
  static const Record record =
      WrittenRecord("Variable", "A variable of the document.")
          .member("name", text(), "Name in expressions.")
          .member("value", number(), "Present value, also for variables that have an expression.")
          .member("min", number(), "Smallest value.")
          .member("max", number(), "Largest value.")
          .member("unit", text(), "Unit, or an empty text.")
          .member("doc", text(), "Description, or an empty text.")
          .member("expression", or_null(text()), "The expression that gives the value. Null: the value is a number.")
          .member("private", flag(), "True: the variable is not shown to users.");
  return record;
}

}  // namespace

const Record& no_members() {
  static const Record record = WrittenRecord("NoMembers", "An object without members.");
  return record;
}

const Record& fault_record() {
  static const Record record = WrittenRecord("Fault", "An error or a warning about a text.")
                                   .member("severity", choice({"error", "warning"}), "A text with errors is not grown.")
                                   .member("message", text(), "Description of the fault.")
                                   .member("expected", text(), "Expected value, or an empty text.")
                                   .member("nearest", text(), "The nearest valid name, or an empty text.")
                                   .member("path", text(), "Path in the document, or an empty text.")
                                   .member("line", or_null(whole()), "Line, from 1. Null: unknown.")
                                   .member("column", or_null(whole()), "Column in characters, from 1. Null: unknown.")
                                   .member("offset", or_null(whole()), "Position in the text. Null: unknown.")
                                   .member("text", text(), "The whole fault on one line, as a terminal shows it.");
  return record;
}

Form faults() { return list(forms::record(fault_record)); }

Form job_name() { return choice({"grow", "export", "measure", "sweep", "stills", "grammar", "picture", "question"}); }

std::vector<Override> overrides_of(const Value::Object& values) {
  std::vector<Override> overrides;
  for (const auto& [path, value] : values)
    overrides.push_back({.path = path, .value = value, .name = "the value of " + path});
  return overrides;
}

const Record& implied_record() {
  static const Record record =
      WrittenRecord("ImpliedLink", "A link that is not in the text: a component places another one itself.")
          .member("from", text(), "The component that places.")
          .member("to", text(), "The component that is placed.");
  return record;
}

const Record& reading_record() {
  static const Record record =
      WrittenRecord("Reading", "The facts that the server reads from a text.")
          .optional("superseded", flag(),
                    "True: a newer message made the reading useless. The other members are missing.")
          .member("good", flag(), "True: the text has no errors.")
          .member("faults", faults(), "Errors and warnings.")
          .member("tree", any(), "The text as plain JSON. Null: the text is not JSON, so the page keeps the last tree.")
          .member("variables", list(forms::record(variable_record)), "Variables. Empty if the text has errors.")
          .member("implied", list(forms::record(implied_record)), "Implied links of the last text without errors.")
          .member("notes", map(text()), "Comments on components, by component.")
          .alone("superseded", true);
  return record;
}

const Record& refused_record() {
  static const Record record =
      WrittenRecord("Refused", "The reason why a request was refused.")
          .member("message", text(), "Reason of the refusal, for users.")
          .optional("faults", faults(), "Faults of the document.")
          .optional("limit", text(), "Name of the reached limit of the server.")
          .optional("cancelled", flag(), "True: the request was cancelled by the page, or by a newer request.")
          .optional("stale", flag(), "True: the server has another text than the page.")
          .optional("changed", flag(), "True: the file on the disk is not as the page expects.");
  return record;
}

const Record& export_camera() {
  static const Record record = RecordTable<CameraOptions>("ExportCamera", "The camera of a picture.")
                                   .vector("position", &CameraOptions::position,
                                           {-kMaxPosition, kMaxPosition, Unit::metre}, "Position of the camera.")
                                   .vector("target", &CameraOptions::target, {-kMaxPosition, kMaxPosition, Unit::metre},
                                           "Point in the middle of the picture.")
                                   .number("field_of_view", &CameraOptions::field_of_view_deg, {1, 150, Unit::degree},
                                           "Vertical angle of view. A larger angle shows more.");
  return record;
}

const Record& instance_record() {
  static const Record value_record =
      WrittenRecord("InstanceValue", "A parameter that differs from instance to instance.")
          .member("path", text(), "Path in the component.")
          .member("value", number(), "Value at this instance.");
  static const Record record =
      WrittenRecord("FoundInstance", "An instance of a component.")
          .member("component", text(), "Id of the component.")
          .member("key", text(), "16 hexadecimal digits that identify the instance among all instances.")
          .member("i", whole(), "Number among its siblings, from 0.")
          .member("n", whole(), "Number of siblings.")
          .member("u", number(), "Position among the siblings or along the stem, 0 to 1.")
          .member("order", whole(), "Branching order.")
          .member("depth", whole(), "Depth of recursion.")
          .member("position", vector({.unit = Unit::metre}), "Position in the world.")
          .member("values", list(forms::record([]() -> const Record& { return value_record; })),
                  "Parameters that differ from instance to instance.")
          .member("shoot", or_null(text()), "Label of its axis within the stem of the component. Null: an organ.")
          .optional("stem", whole(), "Number of the stem among the stems of the component. Given with a label.")
          .optional("tree", whole(), "Number of the root of the shoot among the roots of the stem. Given with a label.")
          .optional("metamer", whole(),
                    "Metamer at the nearer end of the visible segment, counted from the base of the axis. Given with a "
                    "label.")
          .optional(
              "course", list(number(), kMaxNumbers),
              "Three numbers for each node of the axis, the node from which it springs first. Given with a label.")
          .optional("metamers", list(whole(), kMaxNumbers),
                    "Number of the metamer that ends at each of these nodes. Given with a label.")
          .member("iteration", or_null(whole()),
                  "Iteration after which operations on the tree would act. Null: the component has no operations.");
  return record;
}

}  // namespace meristem::studio
