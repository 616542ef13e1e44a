// SPDX-License-Identifier: Apache-2.0
// Messages about exported files and small pictures of the document.
#include "meristem/shape/detail/detail.h"
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kMaxStills = 16;
constexpr Span kPicturePixels{.min = 1, .max = 16384};
constexpr Span kStillPixels{.min = 16, .max = 512};

const Record& export_frames_record() {
  static const Record record =
      RecordTable<film::FrameTimes>("ExportFrames", "The times of pictures.")
          .number("from", &film::FrameTimes::from, {0, kMaxSeconds, Unit::second}, "Time of the first picture.")
          .number("to", &film::FrameTimes::to, {0, kMaxSeconds, Unit::second}, "Time that no picture exceeds.")
          .number("step", &film::FrameTimes::step, {1e-6, kMaxSeconds, Unit::second},
                  "Time between pictures. A larger step makes fewer pictures.")
          .rule([](const film::FrameTimes& frames, const Value&) -> std::string {
            const std::string wanted = film::wanting(frames);
            return wanted.empty() ? "" : "needs " + wanted;
          });
  return record;
}

const Record& export_options() {
  static const Record record =
      RecordTable<ExportOptions>("ExportOptions", "Options of an export.")
          .whole("lod", &ExportOptions::lod, {0, kCoarsestDetail}, "Number of coarser levels that are written too.")
          .or_default()
          .several("instances", forms::choice({"automatic", "rows", "nodes"}), &ExportOptions::instances,
                   "How instances are stored. Only for formats that can store them.")
          .or_default("automatic")
          .whole("seed", &ExportOptions::seed, {0, kMaxWhole}, "Seed instead of the seed of the document.")
          .number("time", &ExportOptions::time, {-kMaxSeconds, kMaxSeconds, Unit::second}, "Time of the document.")
          .or_default()
          .whole("width", &ExportOptions::width, kPicturePixels,
                 "Width of pictures, pixels. Missing: the document's own.")
          .whole("height", &ExportOptions::height, kPicturePixels,
                 "Height of pictures, pixels. Missing: the document's own.")
          .whole("samples", &ExportOptions::samples, {1, 65536},
                 "Rays per pixel of pictures. More rays make smoother pictures and take longer.")
          .flag("transparent", &ExportOptions::transparent, "True: pictures have no background.")
          .or_default()
          .record("camera", &ExportOptions::camera, export_camera, "Camera of pictures. Missing: the document's own.")
          .record("frames", &ExportOptions::frames, export_frames_record,
                  "Times of a film, or of several pictures. Missing: a film of the whole animation, or one picture.");
  return record;
}

/// Describes a request with the options of an export.
template <class R>
Record export_request(std::string name, std::string doc) {
  const auto options = [](R& request) -> ExportOptions& { return request.options; };
  return RecordTable<R>(std::move(name), std::move(doc))
      .text(
          "format", [](R& request) -> std::string& { return request.options.format; }, "An ending of `formats`.")
      .text(
          "name", [](R& request) -> std::optional<std::string>& { return request.options.name; },
          "Name of the file, without an ending. Null: the name of the document.")
      .record("options", options, export_options, "Options of the export.")
      .optional();
}

const Record& export_members() {
  static const Record record =
      export_request<ExportRequest>("ExportRequest", "Makes a file of the document for a download.");
  return record;
}

const Record& command_members() {
  static const Record record =
      export_request<CommandRequest>("CommandRequest", "Names the command line that exports the same files.");
  return record;
}

const Record& made_file() {
  static const Record record = WrittenRecord("MadeFile", "A file that can be downloaded.")
                                   .member("name", forms::text(), "Name of the file.")
                                   .member("bytes", forms::whole(), "Size of the file.")
                                   .member("address", forms::text(), "Address below the token: `downloads/3/oak.glb`.")
                                   .member("holds", forms::list(forms::text()),
                                           "Names of the files in a zip archive. Empty: the file is no archive.");
  return record;
}

const Record& export_answer() {
  static const Record record =
      WrittenRecord("ExportAnswer", "An exported file.")
          .member("file", forms::record(made_file), "The file. Several files come as a zip archive.");
  return record;
}

const Record& command_answer() {
  static const Record record = WrittenRecord("CommandAnswer", "A command line.")
                                   .member("command", forms::text(), "The command that exports the same files.");
  return record;
}

const Record& stills_members() {
  static const Record record =
      RecordTable<StillsRequest>(
          "StillsRequest",
          "Makes small pictures of the document with other values. The document and the view do not change.")
          .read(
              "states", forms::list(forms::map(forms::any()), kMaxStills),
              [](StillsRequest& request, const Value& value, const DocumentPath&) {
                for (const Value& state : *value.list()) request.states.push_back(overrides_of(*state.object()));
              },
              "Values of each picture, by their paths as in `drag`. Empty: cancels the previous request.")
          .whole("width", &StillsRequest::width, kStillPixels, "Width of each picture, pixels.")
          .optional()
          .whole("height", &StillsRequest::height, kStillPixels, "Height of each picture, pixels.")
          .optional()
          .record("camera", &StillsRequest::camera, export_camera, "Camera of each picture.")
          .optional()
          .flag("fit", &StillsRequest::fits,
                "True: moves the camera back until it shows the whole of the largest plant.")
          .or_default()
          .rule([](const StillsRequest& request, const Value& members) -> std::string {
            for (const char* name : {"width", "height", "camera"}) {
              const Value* member = members.find(name);
              const bool is_missing = member == nullptr || member->is_null();
              if (is_missing && !request.states.empty()) return std::string("has no '") + name + "'";
            }
            return "";
          });
  return record;
}

const Record& still_record() {
  static const Record record = WrittenRecord("Still", "A small picture of a state of the document.")
                                   .optional("picture", forms::text(), "A PNG in base 64 without a background.")
                                   .optional("faults", errors(), "Faults of the state, which then has no picture.")
                                   .one_of({"picture", "faults"});
  return record;
}

const Record& stills_answer() {
  static const Record record =
      WrittenRecord("StillsAnswer", "Small pictures.")
          .member("stills", forms::list(forms::record(still_record)), "A picture for each state.");
  return record;
}

}  // namespace

ProtocolGroup export_messages() {
  using enum AnswerTime;
  return {.name = "export",
          .doc = "Messages about exported files and small pictures of the document.",
          .requests = {request_type<ExportRequest>("export", later, export_members, export_answer),
                       request_type<CommandRequest>("command", at_once, command_members, command_answer),
                       request_type<StillsRequest>("stills", newest, stills_members, stills_answer)}};
}

}  // namespace meristem::studio
