// SPDX-License-Identifier: Apache-2.0
// The requests of the page and their reader. The tables in protocol/ describe their members in messages.
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
  bool only_if_good = false;  ///< true: the edits are refused if they would bring errors into a text without errors
};
struct DragRequest {
  std::vector<Override> values;
};
/// The growth step that is shown, and whether growth is recorded for overlays.
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
/// Asks for overlays on the plant (OverlayPart).
struct OverlaysRequest {
  std::vector<std::string> parts;
};
struct ShownRequest {
  std::uint64_t packet = 0;
};
struct AllRequest {};
struct CancelRequest {
  std::optional<double> re;  ///< number of the request whose job is cancelled; unset: the growth
};
/// Continues the growth or meshing that reached its time limit.
struct ContinueRequest {};
struct PauseRequest {
  bool paused = false;
};
struct FilesRequest {
  std::string folder;
};
struct SaveRequest {
  std::string path;
  std::string hash;  ///< hash of the page's text; the server writes only this text
  std::optional<std::string> saved;
  bool over = false;
};
struct ModelsRequest {};
struct MeasuresRequest {
  bool light = false;       ///< true: also measure the light on every organ
  double layer_height = 0;  ///< height of the layers for leaf area by height, metres; 0: no layers
};
/// Asks for the names of all measures.
struct MeasureRowsRequest {};
/// Measures the document with each of several values at a path.
struct SweepRequest {
  std::string path;
  std::vector<double> values;
  bool light = false;
};
/// Asks for the instance of a component that is visible at a position.
struct InstanceRequest {
  std::string component;
  Frame frame;       ///< frame of the visible part; the identity for stems
  Vec3 position{0};  ///< position on its surface
};
/// Asks for a shoot of a component's stems by its name, or for a neighbouring shoot in the tree.
struct ShootRequest {
  enum class Go { nowhere, parent, child, next, previous };
  /// A shoot's name, as answers give it.
  struct Name {
    std::uint32_t stem = 0;     ///< number of the stem among the component's stems
    std::uint32_t tree = 0;     ///< number of the shoot's root among the stem's roots
    std::string shoot;          ///< label
    std::uint32_t metamer = 0;  ///< position on the shoot
  };
  std::string component;
  std::optional<Name> of;  ///< unset: the first shoot of the component
  Go go = Go::nowhere;     ///< step from the named shoot to the requested one
};
/// Asks for the position of the first instance of a component.
struct StandRequest {
  std::string component;
};
/// Asks for the values of expressions of a component, or of the rest of the document.
struct WorkedOutRequest {
  std::optional<std::string> component;  ///< component whose first instance is used; unset: only the document
  std::vector<std::pair<std::string, std::string>> expressions;  ///< path in the document, text
};
/// Asks for the curves from which a grass leaf component draws its leaves.
struct CurvesRequest {
  std::string component;
  std::optional<int> rank;  ///< rank of the requested leaf; unset: any
  std::optional<int> leaf;  ///< number of the leaf within its rank
};
/// Asks for the attraction points of a component's crown.
struct CloudRequest {
  std::string component;
};
/// Asks for the effects of operations on the trees of a component.
struct OperationsRequest {
  std::string component;
  std::string operation;         ///< path of the operation whose positions are requested; empty: no positions
  std::optional<int> iteration;  ///< iteration after which it acted; unset: any
};
/// Asks for the components of a shipped model.
struct PartsRequest {
  std::string model;
};
/// Asks for a part of the open document, of a shipped model, or of a text.
struct PartRequest {
  std::optional<std::string> model;
  std::optional<std::string> text;
  std::vector<std::string> components;  ///< ids; empty: all components except cameras
};

/// The camera of a picture.
struct CameraOptions {
  Vec3 position{0};
  Vec3 target{0};
  double field_of_view_deg = 35;  ///< vertical
};

/// Options of an export: format, detail, time and pictures.
struct ExportOptions {
  std::string format;                 ///< an ending with its dot
  std::optional<std::string> name;    ///< name without ending; unset: the document's name
  int lod = 0;                        ///< number of coarser levels that are written too
  std::string instances;              ///< automatic (or empty), rows, nodes
  std::optional<std::uint64_t> seed;  ///< seed that replaces the document's
  double time = 0;                    ///< seconds
  std::optional<int> width;           ///< width of pictures, pixels
  std::optional<int> height;
  std::optional<int> samples;
  bool transparent = false;
  std::optional<CameraOptions> camera;
  std::optional<film::FrameTimes> frames;  ///< times of a film or of several pictures; unset: all of a film, or one
                                           ///< picture
};
struct ExportRequest {
  ExportOptions options;
};
struct CommandRequest {
  ExportOptions options;
};

/// Asks for small pictures of the document with other values, to show the effect of a value.
struct StillsRequest {
  std::vector<std::vector<Override>> states;  ///< values of each picture
  int width = 96;                             ///< of each picture, pixels
  int height = 96;
  CameraOptions camera;
  bool fits = true;  ///< true: moves the camera back until it shows the whole of the largest plant
};
/// Asks for the derivation of the grammar of an lsystem component.
struct GrammarRequest {
  std::string component;
  std::optional<int> step;             ///< steps after which the word is requested; unset: the component's number of
                                       ///< steps
  std::optional<std::uint64_t> key{};  ///< key of the instance's site; unset or unknown: `number` is used
  std::uint64_t number = 0;            ///< number of the instance among all instances of the component
  bool is_drawn = false;               ///< true: applies interpretation rules to the word
  std::uint64_t first = 0;             ///< index of the first module in the answer
  std::uint64_t count = 4000;          ///< maximum number of modules in the answer
};
/// Asks for the clocks that begin up to a time of the document.
struct ClocksRequest {
  double up_to = 0;  ///< seconds
};
/// Asks for a small version of a picture that the document names or might name.
struct PictureRequest {
  std::string file;  ///< path as the document writes it, relative to its folder
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

/// Returns the number of a message that is otherwise invalid, for its refusal. Returns nothing if it has no number.
std::optional<double> request_id(std::string_view message) noexcept;

/// Reads a request. Throws a Refusal for messages that are not as the protocol describes them.
NumberedRequest read_request(std::string_view message);

}  // namespace meristem::studio
