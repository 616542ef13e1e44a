// SPDX-License-Identifier: Apache-2.0
// What the page asks for, as protocol.md defines it, read from the text of a message.
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
  std::vector<Edit> edits;
  bool only_if_good = false;  ///< refused where a text without errors would then have some
};
struct DragRequest {
  std::vector<Override> values;
};
/// The step of growth that is shown, and whether growth is recorded for overlays.
struct ShownGrowth {
  std::optional<int> step;
  bool is_recorded = false;
  std::string of{};  ///< id of the component whose plants the step is for; empty: all
};
struct ViewRequest {
  std::optional<std::uint64_t> drag_triangles;
  std::optional<std::uint64_t> rest_triangles;
  std::optional<bool> surface;
  std::optional<bool> skeleton;
  std::optional<double> time;
  std::optional<ShownGrowth> growth;
};
/// What is shown over the plant: OverlayPart.
struct OverlaysRequest {
  std::vector<std::string> parts;
};
struct ShownRequest {
  std::uint64_t packet = 0;
};
struct AllRequest {};
struct CancelRequest {
  std::optional<double> re;  ///< number of the request whose job is meant; unset: growth in hand
};
/// Goes on with the growth or meshing that reached its time limit.
struct ContinueRequest {};
struct PauseRequest {
  bool paused = false;
};
struct FilesRequest {
  std::string folder;
};
struct SaveRequest {
  std::string path;
  std::string hash;  ///< of the page's text; the server writes no other text
  std::optional<std::string> saved;
  bool over = false;
};
struct ModelsRequest {};
struct MeasuresRequest {
  bool light = false;       ///< whether the light on every organ is measured
  double layer_height = 0;  ///< metres: height of the layers for leaf area by height; 0: none
};
/// What the measures are called.
struct MeasureRowsRequest {};
/// Measures of the document with each of some values at a path.
struct SweepRequest {
  std::string path;
  std::vector<double> values;
  bool light = false;
};
/// What a component's instance is that is seen somewhere.
struct InstanceRequest {
  std::string component;
  Frame frame;       ///< of what is seen of it; the world's own for stems
  Vec3 position{0};  ///< on its surface
};
/// A shoot of a component's stems, by its name, or one that stands beside it in the tree.
struct ShootRequest {
  enum class Go { nowhere, parent, child, next, previous };
  /// As an answer names it.
  struct Name {
    std::uint32_t stem = 0;     ///< number of the stem among those of the component
    std::uint32_t tree = 0;     ///< number of its root among those of that stem
    std::string shoot;          ///< label
    std::uint32_t metamer = 0;  ///< the place on it
  };
  std::string component;
  std::optional<Name> of;  ///< unset: the first shoot of the component
  Go go = Go::nowhere;     ///< from there to the one that is asked for
};
/// Where the first instance of a component stands.
struct StandRequest {
  std::string component;
};
/// What expressions of a component, or of the rest of the document, come to.
struct WorkedOutRequest {
  std::optional<std::string> component;  ///< whose first instance counts; unset: the document alone
  std::vector<std::pair<std::string, std::string>> expressions;  ///< path in the document, text
};
/// The curves that a grass leaf component draws its leaves from.
struct CurvesRequest {
  std::string component;
  std::optional<int> rank;  ///< of the leaf that is asked for; unset: any
  std::optional<int> leaf;  ///< its number within the rank
};
/// The attraction points of a component's crown.
struct CloudRequest {
  std::string component;
};
/// What operations have done to the trees of a component.
struct OperationsRequest {
  std::string component;
  std::string operation;         ///< path of the one whose places are told; empty: none
  std::optional<int> iteration;  ///< after which it acted; unset: after any
};
/// Asks for the components of a shipped model.
struct PartsRequest {
  std::string model;
};
/// A part of the open document, of a shipped model, or of a text.
struct PartRequest {
  std::optional<std::string> model;
  std::optional<std::string> text;
  std::vector<std::string> components;  ///< none: all but cameras
};

/// From where a picture is seen.
struct CameraOptions {
  Vec3 position{0};
  Vec3 target{0};
  double field_of_view_deg = 35;  ///< vertical
};

/// What is written how.
struct ExportOptions {
  std::string format;                 ///< an ending, with its dot
  std::optional<std::string> name;    ///< without ending; the document's if not given
  int lod = 0;                        ///< coarser levels that are written too
  std::string instances;              ///< automatic (or empty), rows, nodes
  std::optional<std::uint64_t> seed;  ///< in place of the document's
  double time = 0;                    ///< seconds
  std::optional<int> width;           ///< of pictures, pixels
  std::optional<int> height;
  std::optional<int> samples;
  bool transparent = false;
  std::optional<CameraOptions> camera;
  std::optional<film::FrameTimes> frames;  ///< of a film, and of pictures that are several then; a film's is else all
};
struct ExportRequest {
  ExportOptions options;
};
struct CommandRequest {
  ExportOptions options;
};

/// Small pictures of the document with other values, for a page that shows what a value does.
struct StillsRequest {
  std::vector<std::vector<Override>> states;  ///< values of each picture
  int width = 96;                             ///< of each picture, pixels
  int height = 96;
  CameraOptions camera;
  bool fits = true;  ///< whether the camera goes as far back as shows all of the largest plant
};
/// How the grammar of an lsystem component derives.
struct GrammarRequest {
  std::string component;
  std::optional<int> step;             ///< steps after which the word is asked for; unset: those of the component
  std::optional<std::uint64_t> key{};  ///< of the site of the instance that is meant; unset, or of none: by its number
  std::uint64_t number = 0;            ///< of the instance among all of the component
  bool is_drawn = false;               ///< whether interpretation rules are applied to it
  std::uint64_t first = 0;             ///< index of the first module that is told
  std::uint64_t count = 4000;          ///< most modules that are told
};
/// The clocks that begin up to a time of the document.
struct ClocksRequest {
  double up_to = 0;  ///< seconds
};
/// A picture that the document names, or might name, made small.
struct PictureRequest {
  std::string file;  ///< as the document writes it: from its own folder
  int size = 96;     ///< pixels along the longer side
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

/// The number of a message that is no good otherwise, for its refusal; nothing where it has none.
std::optional<double> request_id(std::string_view message) noexcept;

/// Throws a Refusal for everything that protocol.md does not allow.
NumberedRequest read_request(std::string_view message);

}  // namespace meristem::studio
