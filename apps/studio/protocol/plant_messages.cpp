// SPDX-License-Identifier: Apache-2.0
// Questions about the grown plant: derivations, overlays, places and values of components.
#include <charconv>

#include "meristem/grow/lsystem/grammar.h"
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kMaxExpressions = 1000;
constexpr double kMaxModules = 20'000;  // modules in one answer
constexpr const char* kComponentDoc = "Id of the component.";
constexpr Span kLeafNumber{.min = -kMaxIteration, .max = kMaxIteration};

/// Reads a key of 16 hexadecimal digits.
void read_key(GrammarRequest& request, const Value& value, const DocumentPath&) {
  const std::string& digits = *value.text();
  const char* const end = digits.data() + digits.size();
  std::uint64_t key = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, key, 16);
  if (digits.size() != 16 || error != std::errc() || stop != end)
    throw Refusal("'instance' is not the key of an instance: 16 hexadecimal digits");
  request.key = key;
}

const Record& grammar_members() {
  static const Record record =
      RecordTable<GrammarRequest>(
          "GrammarRequest",
          "Derives the grammar of a component. Refused if the text has faults, and with `faults` beyond limits.")
          .text("component", &GrammarRequest::component, kComponentDoc)
          .whole("step", &GrammarRequest::step, {0, kMaxSteps},
                 "Steps of the derivation. Null: the steps of the component.")
          .read("instance", forms::text(), read_key,
                "Key of an instance. Missing, or without an instance: by `number`.")
          .optional()
          .whole("number", &GrammarRequest::number, {0, kMaxWhole}, "Number of the instance.")
          .or_default()
          .flag("drawn", &GrammarRequest::is_drawn, "True: the word after the rules of interpretation.")
          .or_default()
          .whole("first", &GrammarRequest::first, {0, kMaxWhole}, "Index of the first module of the answer.")
          .or_default()
          .whole("count", &GrammarRequest::count, {0, kMaxModules}, "Maximum number of modules of the answer.")
          .or_default();
  return record;
}

const Record& derived_instance() {
  static const Record record = WrittenRecord("DerivedInstance", "The instance whose grammar was derived.")
                                   .member("number", forms::whole(), "Number among the instances of the component.")
                                   .member("of", forms::whole(), "Number of instances of the component.")
                                   .member("key", forms::text(), "Key of the instance.");
  return record;
}

const Record& derivation_record() {
  static const Record record =
      WrittenRecord("Derivation", "The derivation of a grammar.")
          .member("text", forms::or_null(forms::text()),
                  "Text of the grammar. Null: the component has no instance or no grammar, and the other members are "
                  "missing.")
          .member("instance", forms::record(derived_instance), "The instance whose grammar was derived.")
          .member("steps", forms::whole(), "Number of steps of the component.")
          .member("step", forms::whole(), "Number of steps of this word.")
          .member("interpreted", forms::flag(), "True: the grammar has rules of interpretation.")
          .member("count", forms::whole(), "Number of modules of the word.")
          .member("counts", forms::list(forms::tuple({{"symbol", forms::text()}, {"count", forms::whole()}})),
                  "Number of modules by symbol.")
          .member("first", forms::whole(), "Index of the first module of the answer.")
          .member("modules", forms::list(forms::text()), "Texts of the modules.")
          .member("places", forms::list(forms::number(), kMaxNumbers),
                  "Seven numbers for each drawn module of the answer: its index, its beginning and its end. Empty if "
                  "this word is not drawn.")
          .alone("text", Value());
  return record;
}

const Record& grammar_answer() {
  static const Record record = WrittenRecord("GrammarAnswer", "A derivation.")
                                   .member("derivation", forms::record(derivation_record), "The derivation.");
  return record;
}

const Record& overlays_members() {
  static const Record record =
      RecordTable<OverlaysRequest>(
          "OverlaysRequest",
          "Requests overlays on the last grown plant. Overlays with `recorded` need recorded growth.")
          .several("parts", forms::list(forms::text()), &OverlaysRequest::parts, "Names of `overlays` of `hello`.");
  return record;
}

const Record& coloured_points() {
  static const Record record = WrittenRecord("ColouredPoints", "Points with colours.")
                                   .member("positions", forms::array(), "Three f32 for each point.")
                                   .member("colours", forms::array(), "Four u8 for each point: sRGB and opacity.");
  return record;
}

const Record& overlay_label() {
  static const Record record = WrittenRecord("OverlayLabel", "A text at a point.")
                                   .member("at", forms::vector({.unit = Unit::metre}), "Position.")
                                   .member("text", forms::text(), "The text.");
  return record;
}

const Record& overlay_key() {
  static const Record record = WrittenRecord("OverlayKey", "The meaning of a colour.")
                                   .member("colour", forms::vector({.min = 0, .max = 1}), "sRGB.")
                                   .member("text", forms::text(), "The meaning.");
  return record;
}

const Record& overlay_layer() {
  static const Record record =
      WrittenRecord("PackedLayer", "One overlay.")
          .member("part", forms::text(), "Name of the overlay.")
          .member("points", forms::record(coloured_points), "Single points.")
          .member("lines", forms::record(coloured_points), "Two points for each line.")
          .member("arrows", forms::record(coloured_points), "Two points for each arrow.")
          .member("labels", forms::list(forms::record(overlay_label)), "Texts in space.")
          .member("legend", forms::list(forms::record(overlay_key)), "Meanings of the colours.");
  return record;
}

const Record& overlays_record() {
  static const Record record = WrittenRecord("OverlayLayers", "Overlays on the last grown plant.")
                                   .member("step", forms::whole(), "Growth step of the layers.")
                                   .member("layers", forms::list(forms::record(overlay_layer)), "The overlays.");
  return record;
}

const Record& overlays_answer() {
  static const Record record = WrittenRecord("OverlaysAnswer", "Overlays. The answer is a packet with their arrays.")
                                   .member("overlays", forms::record(overlays_record), "The overlays.");
  return record;
}

const Record& stand_members() {
  static const Record record =
      RecordTable<StandRequest>("StandRequest", "Requests the place of the first instance of a component.")
          .text("component", &StandRequest::component, kComponentDoc);
  return record;
}

const Record& stand_answer() {
  static const Record record =
      WrittenRecord("StandAnswer", "The place of a component.")
          .member("stand", forms::or_null(forms::list(forms::number(), 12, 12)),
                  "Frame of the site of the first instance, before the `frame` of the component: three rows of a 3x4 "
                  "matrix. Null: the component has no instance.");
  return record;
}

const Record& worked_out_members() {
  static const Record record =
      RecordTable<WorkedOutRequest>("WorkedOutRequest", "Computes values of expressions in the last grown plant.")
          .text("component", &WorkedOutRequest::component,
                "Component whose first instance gives the values that differ among instances. Missing: only the "
                "variables.")
          .several("expressions", forms::map(forms::text(), kMaxExpressions), &WorkedOutRequest::expressions,
                   "Expressions by their full paths in the document.");
  return record;
}

const Record& worked_out_answer() {
  static const Record record =
      WrittenRecord("WorkedOutAnswer", "Values of expressions.")
          .member("numbers", forms::map(forms::number()), "Values by the same paths. Unknown values are missing.");
  return record;
}

const Record& curves_members() {
  static const Record record =
      RecordTable<CurvesRequest>("CurvesRequest", "Requests the curves from which a grass leaf is drawn.")
          .text("component", &CurvesRequest::component, kComponentDoc)
          .whole("rank", &CurvesRequest::rank, kLeafNumber, "Rank of the leaf. Missing: any.")
          .whole("leaf", &CurvesRequest::leaf, kLeafNumber, "Number of the leaf within its rank. Missing: any.");
  return record;
}

const Record& leaf_name() {
  static const Record record =
      WrittenRecord("LeafName", "A leaf of the source of a grass leaf.")
          .member("rank", forms::or_null(forms::whole(kLeafNumber)), "Rank. Null: the source has no ranks.")
          .member("leaf", forms::or_null(forms::whole(kLeafNumber)), "Number within the rank.");
  return record;
}

const Record& curves_record() {
  const Form points = forms::list(forms::tuple({{"x", forms::number()}, {"y", forms::number()}}), kMaxNumbers);
  static const Record record =
      WrittenRecord("LeafCurves", "The curves from which a grass leaf is drawn.")
          .member("leaves", forms::list(forms::record(leaf_name), kMaxNumbers), "Leaves of the source.")
          .member("leaf", forms::record(leaf_name), "The leaf of these curves.")
          .member("midrib_points", points,
                  "Measured points: away from the stem and up along it, in the unit of the source.")
          .member("midrib", points, "Fitted midrib.")
          .member("distance", forms::number(), "Distance of the points from the fitted midrib.")
          .member("width_points", points, "Measured widths: share of the length, and share of the largest width.")
          .member("widths", points, "Fitted widths.")
          .member("midrib_file", forms::flag(), "True: the midrib comes from a file.")
          .member("width_file", forms::flag(), "True: the widths come from a file.")
          .member("length", forms::number({.unit = Unit::metre}), "Measured length. 0: no file gives it.")
          .member("width", forms::number({.unit = Unit::metre}), "Measured width. 0: no file gives it.");
  return record;
}

const Record& curves_answer() {
  static const Record record = WrittenRecord("CurvesAnswer", "The curves of a grass leaf.")
                                   .member("curves", forms::or_null(forms::record(curves_record)),
                                           "The curves. Null: the component is no grass leaf.");
  return record;
}

const Record& cloud_members() {
  static const Record record = RecordTable<CloudRequest>("CloudRequest", "Requests the attraction points of a crown.")
                                   .text("component", &CloudRequest::component, kComponentDoc);
  return record;
}

const Record& cloud_record() {
  static const Record record =
      WrittenRecord("CrownCloud", "The attraction points with which the first instance begins.")
          .member(
              "positions", forms::array(),
              "Three f32 for each point, relative to the root. More than 4,000 points are reduced to an even choice.")
          .member("count", forms::whole(), "Number of all points.");
  return record;
}

const Record& cloud_answer() {
  static const Record record =
      WrittenRecord("CloudAnswer", "The attraction points of a crown. The answer is a packet with their array.")
          .member("cloud", forms::or_null(forms::record(cloud_record)),
                  "The points. Null: the component fills no crown with points.");
  return record;
}

const Record& clocks_members() {
  static const Record record =
      RecordTable<ClocksRequest>("ClocksRequest", "Requests the clocks that have begun up to a time.")
          .number("up_to", &ClocksRequest::up_to, {0, kMaxSeconds, Unit::second},
                  "Time of the document up to which clocks begin.");
  return record;
}

const Record& begun_clocks() {
  static const Record record =
      WrittenRecord("BegunClocks", "The clocks that instances of a component have begun, each once.")
          .member("component", forms::text(), "Id of the component, a `sequence`.")
          .member("count", forms::whole(), "Number of clocks.")
          .member("blocks", forms::list(forms::tuple({{"start", forms::number()}, {"speed", forms::number()}})),
                  "The time of the document at which each clock shows 0, and its seconds per second of the document. "
                  "More than 400 clocks are reduced to an even choice.");
  return record;
}

const Record& clocks_answer() {
  static const Record record = WrittenRecord("ClocksAnswer", "The clocks of the plant.")
                                   .member("clocks", forms::list(forms::record(begun_clocks)), "By component.");
  return record;
}

}  // namespace

ProtocolGroup plant_messages() {
  using enum AnswerTime;
  return {.name = "plant",
          .doc = "Questions about the grown plant: derivations, overlays, places and values of components.",
          .requests = {request_type<GrammarRequest>("grammar", newest, grammar_members, grammar_answer),
                       request_type<OverlaysRequest>("overlays", later, overlays_members, overlays_answer),
                       request_type<StandRequest>("stand", later, stand_members, stand_answer),
                       request_type<WorkedOutRequest>("worked_out", later, worked_out_members, worked_out_answer),
                       request_type<CurvesRequest>("curves", later, curves_members, curves_answer),
                       request_type<CloudRequest>("cloud", later, cloud_members, cloud_answer),
                       request_type<ClocksRequest>("clocks", later, clocks_members, clocks_answer)}};
}

}  // namespace meristem::studio
