// SPDX-License-Identifier: Apache-2.0
#include "protocol/common_records.h"

#include "protocol/record_table.h"
#include "request.h"

namespace meristem::studio {

namespace {

const Record& variable_record() {
  static const Record record =
      WrittenRecord("Variable", "A variable of the document.")
          .member("name", forms::text(), "Name in expressions.")
          .member("value", forms::number(), "Present value, also for variables that have an expression.")
          .member("min", forms::number(), "Smallest value.")
          .member("max", forms::number(), "Largest value.")
          .member("unit", forms::text(), "Unit, or an empty text.")
          .member("doc", forms::text(), "Description, or an empty text.")
          .member("expression", forms::or_null(forms::text()),
                  "The expression that gives the value. Null: the value is a number.")
          .member("private", forms::flag(), "True: the variable is not shown to users.");
  return record;
}

}  // namespace

const Record& no_members() {
  static const Record record = WrittenRecord("NoMembers", "An object without members.");
  return record;
}

const Record& error_record() {
  static const Record record =
      WrittenRecord("Fault", "An error or a warning about a text.")
          .member("severity", forms::choice({"error", "warning"}), "A text with errors is not grown.")
          .member("message", forms::text(), "Description of the fault.")
          .member("expected", forms::text(), "Expected value, or an empty text.")
          .member("nearest", forms::text(), "The nearest valid name, or an empty text.")
          .member("path", forms::text(), "Path in the document, or an empty text.")
          .member("line", forms::or_null(forms::whole()), "Line, from 1. Null: unknown.")
          .member("column", forms::or_null(forms::whole()), "Column in characters, from 1. Null: unknown.")
          .member("offset", forms::or_null(forms::whole()), "Position in the text. Null: unknown.")
          .member("text", forms::text(), "The whole fault on one line, as a terminal shows it.");
  return record;
}

Form errors() { return forms::list(forms::record(error_record)); }

Form job_name() {
  return forms::choice({"grow", "export", "measure", "sweep", "stills", "grammar", "picture", "question"});
}

std::vector<ValueOverride> overrides_of(const Value::Object& values) {
  std::vector<ValueOverride> overrides;
  for (const auto& [path, value] : values)
    overrides.push_back({.path = path, .value = value, .name = "the value of " + path});
  return overrides;
}

const Record& implied_record() {
  static const Record record =
      WrittenRecord("ImpliedLink", "A link that is not in the text: a component places another one itself.")
          .member("from", forms::text(), "The component that places.")
          .member("to", forms::text(), "The component that is placed.");
  return record;
}

const Record& reading_record() {
  static const Record record =
      WrittenRecord("Reading", "The facts that the server reads from a text.")
          .optional("superseded", forms::flag(),
                    "True: a newer message made the reading useless. The other members are missing.")
          .member("good", forms::flag(), "True: the text has no errors.")
          .member("faults", errors(), "Errors and warnings.")
          .member("tree", forms::any(),
                  "The text as plain JSON. Null: the text is not JSON, so the page keeps the last tree.")
          .member("variables", forms::list(forms::record(variable_record)), "Variables. Empty if the text has errors.")
          .member("implied", forms::list(forms::record(implied_record)),
                  "Implied links of the last text without errors.")
          .member("notes", forms::map(forms::text()), "Comments on components, by component.")
          .alone("superseded", true);
  return record;
}

const Record& refused_record() {
  static const Record record =
      WrittenRecord("Refused", "The reason why a request was refused.")
          .member("message", forms::text(), "Reason of the refusal, for users.")
          .optional("faults", errors(), "Faults of the document.")
          .optional("limit", forms::text(), "Name of the reached limit of the server.")
          .optional("cancelled", forms::flag(), "True: the request was cancelled by the page, or by a newer request.")
          .optional("stale", forms::flag(), "True: the server has another text than the page.")
          .optional("changed", forms::flag(), "True: the file on the disk is not as the page expects.");
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
          .member("path", forms::text(), "Path in the component.")
          .member("value", forms::number(), "Value at this instance.");
  static const Record record =
      WrittenRecord("FoundInstance", "An instance of a component.")
          .member("component", forms::text(), "Id of the component.")
          .member("key", forms::text(), "16 hexadecimal digits that identify the instance among all instances.")
          .member("i", forms::whole(), "Number among its siblings, from 0.")
          .member("n", forms::whole(), "Number of siblings.")
          .member("u", forms::number(), "Position among the siblings or along the stem, 0 to 1.")
          .member("order", forms::whole(), "Branching order.")
          .member("depth", forms::whole(), "Depth of recursion.")
          .member("position", forms::vector({.unit = Unit::metre}), "Position in the world.")
          .member("values", forms::list(forms::record([]() -> const Record& { return value_record; })),
                  "Parameters that differ from instance to instance.")
          .member("shoot", forms::or_null(forms::text()),
                  "Label of its axis within the stem of the component. Null: an organ.")
          .optional("stem", forms::whole(), "Number of the stem among the stems of the component. Given with a label.")
          .optional("tree", forms::whole(),
                    "Number of the root of the shoot among the roots of the stem. Given with a label.")
          .optional("metamer", forms::whole(),
                    "Metamer at the nearer end of the visible segment, counted from the base of the axis. Given with a "
                    "label.")
          .optional(
              "course", forms::list(forms::number(), kMaxNumbers),
              "Three numbers for each node of the axis, the node from which it springs first. Given with a label.")
          .optional("metamers", forms::list(forms::whole(), kMaxNumbers),
                    "Number of the metamer that ends at each of these nodes. Given with a label.")
          .member("iteration", forms::or_null(forms::whole()),
                  "Iteration after which operations on the tree would act. Null: the component has no operations.");
  return record;
}

}  // namespace meristem::studio
