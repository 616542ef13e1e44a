// SPDX-License-Identifier: Apache-2.0
// Messages about measures of the document.
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kMaxSwept = 64;  // values of one sweep

const Record& measures_members() {
  static const Record record =
      RecordTable<MeasuresRequest>("MeasuresRequest", "Measures the document.")
          .flag("light", &MeasuresRequest::light, "True: also measures the light on organs.")
          .or_default()
          .number("layer_height", &MeasuresRequest::layer_height, {0, kMaxPosition, Unit::metre},
                  "Height of the layers for leaf area by height. 0: no layers.")
          .or_default();
  return record;
}

const Record& measures_answer() {
  static const Record record =
      WrittenRecord("MeasuresAnswer", "Measures of the document.")
          .member("measures", forms::map(forms::any()), "Measures by name, as `meristem measure --json` prints them.");
  return record;
}

const Record& measure_rows_members() {
  static const Record record = RecordTable<MeasureRowsRequest>("MeasureRowsRequest", "Lists all measures.");
  return record;
}

const Record& measure_row() {
  static const Record record = WrittenRecord("MeasureRow", "A measure.")
                                   .member("name", forms::text(), "Name in `measures`.")
                                   .member("unit", forms::text(), "Unit, or an empty text.")
                                   .member("doc", forms::text(), "Description.");
  return record;
}

const Record& measure_rows_answer() {
  static const Record record = WrittenRecord("MeasureRowsAnswer", "All measures.")
                                   .member("rows", forms::list(forms::record(measure_row)), "In their order.");
  return record;
}

const Record& sweep_members() {
  static const Record record =
      RecordTable<SweepRequest>("SweepRequest",
                                "Measures the document with each of several values. Each value has `job_seconds`.")
          .text("path", &SweepRequest::path, "Path of a variable or a number.")
          .several("values", forms::list(forms::number(), kMaxSwept, 1), &SweepRequest::values, "The values.")
          .flag("light", &SweepRequest::light, "True: also measures the light on organs.")
          .or_default();
  return record;
}

const Record& sweep_point() {
  static const Record record = WrittenRecord("SweepPoint", "The document with one of the values.")
                                   .member("value", forms::number(), "The value.")
                                   .optional("measures", forms::map(forms::any()), "Measures by name.")
                                   .optional("faults", errors(), "Faults with this value, instead of measures.")
                                   .one_of({"measures", "faults"});
  return record;
}

const Record& sweep_answer() {
  static const Record record =
      WrittenRecord("SweepAnswer", "Measures for each value.")
          .member("sweep", forms::list(forms::record(sweep_point)), "In the order of the values.");
  return record;
}

}  // namespace

ProtocolGroup measure_messages() {
  using enum AnswerTime;
  return {
      .name = "measures",
      .doc = "Messages about measures of the document.",
      .requests = {request_type<MeasuresRequest>("measures", newest, measures_members, measures_answer),
                   request_type<MeasureRowsRequest>("measure_rows", at_once, measure_rows_members, measure_rows_answer),
                   request_type<SweepRequest>("sweep", newest, sweep_members, sweep_answer)}};
}

}  // namespace meristem::studio
