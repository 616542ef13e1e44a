// SPDX-License-Identifier: Apache-2.0
// Messages about the connection, the view and the growth of the document.
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"

namespace meristem::studio {

namespace {

constexpr Span kTriangles{.min = 100, .max = 1e9};

const Record& shown_growth() {
  static const Record record =
      RecordTable<ShownGrowth>("ShownGrowth", "The growth step that is shown.")
          .whole("step", &ShownGrowth::step, {0, kMaxIteration}, "Growth step of the plants. Null: the last step.")
          .flag("recorded", &ShownGrowth::is_recorded,
                "True: growth is recorded, for overlays and for the `steps` of `grown`.")
          .text("of", &ShownGrowth::of, "Component whose plants the step is for. Null: all plants.")
          .optional();
  return record;
}

const Record& view_members() {
  static const Record record =
      RecordTable<ViewRequest>("ViewRequest", "Sets what is shown. Changes come as a packet.")
          .whole("drag_triangles", &ViewRequest::drag_triangles, kTriangles,
                 "Maximum number of triangles while something moves, at first 60000.")
          .whole("rest_triangles", &ViewRequest::rest_triangles, kTriangles,
                 "Maximum number of triangles at rest, at first 250000.")
          .flag("surface", &ViewRequest::surface, "True: shows surfaces. At first true.")
          .flag("skeleton", &ViewRequest::skeleton, "True: shows skeletons. At first false.")
          .number("time", &ViewRequest::time, {-kMaxSeconds, kMaxSeconds, Unit::second},
                  "Time of the document, at first 0.")
          .record("growth", &ViewRequest::growth, shown_growth, "The growth step that is shown.");
  return record;
}

const Record& shown_members() {
  static const Record record =
      RecordTable<ShownRequest>("ShownRequest",
                                "Reports that a packet is shown. The next packet comes only after this message.")
          .whole("packet", &ShownRequest::packet, {0, kMaxWhole}, "Number of the packet.");
  return record;
}

const Record& cancel_members() {
  static const Record record =
      RecordTable<CancelRequest>("CancelRequest",
                                 "Cancels the work of one request, or the growth. The cancelled request is refused "
                                 "with `cancelled`. After a cancelled growth, the next change grows again.")
          .whole("re", &CancelRequest::re, {0, kMaxWhole},
                 "The `id` of the request, whose work runs, waits or reads the text. Missing: the growth.");
  return record;
}

const Record& pause_members() {
  static const Record record = RecordTable<PauseRequest>("PauseRequest", "Pauses or resumes growth.")
                                   .flag("paused", &PauseRequest::paused, "True: no new growth begins.");
  return record;
}

const Record& all_members() {
  static const Record record =
      RecordTable<AllRequest>("AllRequest", "Makes the next packet a whole scene, as after a lost context.");
  return record;
}

const Record& continue_members() {
  static const Record record = RecordTable<ContinueRequest>(
      "ContinueRequest",
      "Continues the growth that ended with `continues`, for `job_seconds` again. Finished results are reused. Does "
      "nothing if no growth was stopped, or after a newer change.");
  return record;
}

const Record& format_record() {
  static const Record record = WrittenRecord("Format", "A format of exported files.")
                                   .member("ending", forms::text(), "Ending of its files, with the dot.")
                                   .member("doc", forms::text(), "Description.")
                                   .member("levels", forms::flag(), "True: it can have levels of detail.")
                                   .member("instances", forms::flag(), "True: it can store instances.");
  return record;
}

const Record& overlay_part_record() {
  static const Record record = WrittenRecord("OverlayPart", "An overlay that can be shown over the plant.")
                                   .member("name", forms::text(), "Name in the request `overlays`.")
                                   .member("title", forms::text(), "Name for users.")
                                   .member("doc", forms::text(), "Description.")
                                   .member("recorded", forms::flag(), "True: it needs recorded growth.");
  return record;
}

const Record& limits_record() {
  static const Record record =
      WrittenRecord("StudioLimits", "The limits of the server.")
          .member("message_bytes", forms::whole(), "Maximum size of one message of the page.")
          .member("messages_per_second", forms::whole(), "Maximum number of messages within one second.")
          .member("job_seconds", forms::number({.unit = Unit::second}), "Time for one growth, export or measurement.")
          .member("film_seconds", forms::number({.unit = Unit::second}), "Time for one film.")
          .member("memory_bytes", forms::whole(), "Memory of the whole program while a job runs.")
          .member("connections", forms::whole(), "Maximum number of pages.");
  return record;
}

const Record& hello_record() {
  static const Record record =
      WrittenRecord("Hello", "The first message of a connection.")
          .member("protocol", forms::whole(), "Version of the protocol: 1.")
          .member("version", forms::text(), "Version of the program.")
          .member("root", forms::text(), "Name of the folder whose documents can be opened.")
          .member("root_key", forms::text(), "Identifies the folder among folders of its name.")
          .member("document", forms::or_null(forms::text()), "Path of the document to open first. Null: none.")
          .member("model", forms::or_null(forms::text()), "Name of the model to open first. Null: none.")
          .member("formats", forms::list(forms::record(format_record)), "Formats of exported files.")
          .member("overlays", forms::list(forms::record(overlay_part_record)),
                  "Overlays that can be shown over the plant.")
          .member("limits", forms::record(limits_record), "Limits of the server.");
  return record;
}

const Record& working_record() {
  static const Record record =
      WrittenRecord("Working", "Progress of a job, at most ten times a second.")
          .member("job", job_name(), "The job. `question` stands for requests about the last growth.")
          .optional("re", forms::whole(), "The `id` of the request. Missing: the growth.")
          .member("stage", forms::or_null(forms::text()), "Present stage of the job. Null: the job is over.")
          .member("share", forms::number({.min = 0, .max = 1}), "Finished share of the stage.");
  return record;
}

const Record& stage_record() {
  static const Record record = WrittenRecord("GrownStage", "A stage of the growth and its time.")
                                   .member("name", forms::text(), "Name of the stage.")
                                   .member("ms", forms::number(), "Time, milliseconds.");
  return record;
}

const Record& reuse_record() {
  static const Record record =
      WrittenRecord("GrownReuse", "The reuse of one kind of result.")
          .member("what", forms::text(), "Kind of result: instances, grown skeletons and so on.")
          .member("made", forms::whole(), "Number of new results.")
          .member("reused", forms::whole(), "Number of results from earlier growths.");
  return record;
}

const Record& component_count_record() {
  static const Record record = WrittenRecord("ComponentCount", "The size of a component in the scene.")
                                   .member("instances", forms::whole(), "Number of instances.")
                                   .member("triangles", forms::whole(), "Number of triangles of all instances.");
  return record;
}

const Record& grown_record() {
  static const Record record =
      WrittenRecord("Grown", "A grown plant. It comes right before each packet.")
          .member("hash", forms::text(), "Hash of the text that has grown.")
          .member("dragged", forms::flag(), "True: with the values of a drag.")
          .member("stages", forms::list(forms::record(stage_record)),
                  "Times of the stages. Reused stages are left out.")
          .member("reuse", forms::list(forms::record(reuse_record)),
                  "How much was reused. Kinds that the plant does not need are left out.")
          .member("nodes", forms::whole(), "Number of nodes of all skeletons.")
          .member("instances", forms::whole(), "Number of instances.")
          .member("triangles", forms::or_null(forms::whole()), "Number of triangles. Null: a coarser level is shown.")
          .member("placed", forms::or_null(forms::map(forms::whole())),
                  "Number of instances by component, without omitted ones. Null: a drag.")
          .member("components", forms::or_null(forms::map(forms::record(component_count_record))),
                  "Size of each component. Null: a coarser level is shown.")
          .member("step", forms::whole(), "Growth step that is shown.")
          .member("steps", forms::or_null(forms::whole()),
                  "Number of steps of the plants that the step is for. Null: growth is not recorded.")
          .member("growing", forms::or_null(forms::map(forms::whole())),
                  "Number of steps of the plants of each component that grows or places some. Null: growth is not "
                  "recorded.");
  return record;
}

const Record& failed_record() {
  static const Record record =
      WrittenRecord("Failed", "A growth that failed. The shown plant stays, even if it is a draft.")
          .member("job", job_name(), "The job: `grow`.")
          .member("hash", forms::text(), "Hash of the text.")
          .member("message", forms::text(), "Reason of the failure.")
          .optional("faults", errors(), "Reached limits of the document, and numbers that are not finite.")
          .optional("limit", forms::text(), "Name of the reached limit of the server.")
          .optional("continues", forms::flag(), "True: the work reached `job_seconds`, and `continue` continues it.");
  return record;
}

}  // namespace

ProtocolGroup view_messages() {
  using enum AnswerTime;
  return {
      .name = "view",
      .doc = "Messages about the connection, the view and the growth of the document.",
      .requests = {request_type<ViewRequest>("view", at_once, view_members, no_members),
                   request_type<ShownRequest>("shown", at_once, shown_members, no_members),
                   request_type<AllRequest>("all", at_once, all_members, no_members),
                   request_type<CancelRequest>("cancel", at_once, cancel_members, no_members),
                   request_type<ContinueRequest>("continue", at_once, continue_members, no_members),
                   request_type<PauseRequest>("pause", at_once, pause_members, no_members)},
      .messages = {
          {"hello", hello_record}, {"working", working_record}, {"grown", grown_record}, {"failed", failed_record}}};
}

}  // namespace meristem::studio
