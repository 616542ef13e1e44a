// SPDX-License-Identifier: Apache-2.0
// The requests of the page and their reader. The tables in protocol/ describe the members.
// An unset optional member is missing in the message, or null.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "apps/film/frames.h"
#include "meristem/base/frame.h"
#include "meristem/document/document.h"
#include "meristem/document/edit/session.h"
#include "text_units.h"

namespace meristem::studio {

struct OpenRequest {
  std::optional<std::string> path;
  std::optional<std::string> model;
  std::optional<std::string> text;
};

struct SpliceRequest {
  std::string base;
  std::vector<UnitSplice> patch;
};

struct TextRequest {
  std::string text;
};

struct EditRequest {
  std::string base;
  std::vector<SessionEdit> edits;
  bool only_if_good = false;
};

struct DragRequest {
  std::vector<ValueOverride> values;
};

/// Empty `of`: all plants.
struct ShownGrowth {
  std::optional<int> step;
  bool is_recorded = false;
  std::string of{};
};

struct ViewRequest {
  std::optional<std::uint64_t> drag_triangles;
  std::optional<std::uint64_t> rest_triangles;
  std::optional<bool> surface;
  std::optional<bool> skeleton;
  std::optional<double> time;
  std::optional<ShownGrowth> growth;
};

struct OverlaysRequest {
  std::vector<std::string> parts;
};

struct ShownRequest {
  std::uint64_t packet = 0;
};

struct AllRequest {};

struct CancelRequest {
  std::optional<double> re;
};

struct ContinueRequest {};

struct PauseRequest {
  bool paused = false;
};

struct FilesRequest {
  std::string folder;
};

struct SaveRequest {
  std::string path;
  std::string hash;
  std::optional<std::string> saved;
  bool over = false;
};

struct ModelsRequest {};

struct MeasuresRequest {
  bool light = false;
  double layer_height = 0;
};

struct MeasureRowsRequest {};

struct SweepRequest {
  std::string path;
  std::vector<double> values;
  bool light = false;
};

struct InstanceRequest {
  std::string component;
  Frame frame;
  Vec3 position{0};
};

struct RequestedShoot {
  std::uint32_t stem = 0;
  std::uint32_t tree = 0;
  std::string shoot;
  std::uint32_t metamer = 0;
};

struct ShootRequest {
  /// Steps from a shoot to another one; `nowhere`: the shoot itself.
  enum class Go { nowhere, parent, child, next, previous };

  using Name = RequestedShoot;

  std::string component;
  std::optional<Name> of;
  Go go = Go::nowhere;
};

struct StandRequest {
  std::string component;
};

struct WorkedOutRequest {
  std::optional<std::string> component;
  std::vector<std::pair<std::string, std::string>> expressions;
};

struct CurvesRequest {
  std::string component;
  std::optional<int> rank;
  std::optional<int> leaf;
};

struct CloudRequest {
  std::string component;
};

struct OperationsRequest {
  std::string component;
  std::string operation;
  std::optional<int> iteration;
};

struct PartsRequest {
  std::string model;
};

struct PartRequest {
  std::optional<std::string> model;
  std::optional<std::string> text;
  std::vector<std::string> components;
};

struct CameraOptions {
  Vec3 position{0};
  Vec3 target{0};
  double field_of_view_deg = 35;
};

/// `format` and `name` are members of the request, the others of its `options`.
struct ExportOptions {
  std::string format;
  std::optional<std::string> name;
  int lod = 0;
  std::string instances;
  std::optional<std::uint64_t> seed;
  double time = 0;
  std::optional<int> width;
  std::optional<int> height;
  std::optional<int> samples;
  bool transparent = false;
  std::optional<CameraOptions> camera;
  std::optional<film::FrameTimes> frames;
};

struct ExportRequest {
  ExportOptions options;
};

struct CommandRequest {
  ExportOptions options;
};

struct StillsRequest {
  std::vector<std::vector<ValueOverride>> states;
  int width = 96;
  int height = 96;
  CameraOptions camera;
  bool fits = true;
};

/// `key` names an instance; unset or unknown: `number` does.
struct GrammarRequest {
  std::string component;
  std::optional<int> step;
  std::optional<std::uint64_t> key{};
  std::uint64_t number = 0;
  bool is_drawn = false;
  std::uint64_t first = 0;
  std::uint64_t count = 4000;
};

struct ClocksRequest {
  double up_to = 0;
};

struct PictureRequest {
  std::string file;
  int size = 96;
};

using Request = std::variant<OpenRequest, SpliceRequest, TextRequest, EditRequest, DragRequest, ViewRequest,
                             ShownRequest, AllRequest, CancelRequest, ContinueRequest, PauseRequest, FilesRequest,
                             SaveRequest, ModelsRequest, MeasuresRequest, MeasureRowsRequest, SweepRequest,
                             InstanceRequest, ShootRequest, StandRequest, WorkedOutRequest, CurvesRequest, CloudRequest,
                             OperationsRequest, PartsRequest, PartRequest, ExportRequest, CommandRequest, StillsRequest,
                             GrammarRequest, ClocksRequest, PictureRequest, OverlaysRequest>;

struct NumberedRequest {
  double id = 0;
  Request request;
};

/// Returns the number of a message that is otherwise invalid, for its refusal. Returns nothing if it has no number.
std::optional<double> request_id(std::string_view message) noexcept;

/// Reads a request. Throws a Refusal for messages that are not as the protocol describes them.
NumberedRequest read_request(std::string_view message);

}  // namespace meristem::studio
