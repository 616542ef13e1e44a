// SPDX-License-Identifier: Apache-2.0
// Reads the requests of a page. Each kind of request has a function that reads its members by name, type and range.
// Everything unknown or out of range is refused with the member's full name.
#include "request.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "meristem/document/json.h"
#include "meristem/grow/lsystem/grammar.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

constexpr double kGreatestWhole = 9007199254740992;  // doubles hold all whole numbers up to here
constexpr std::size_t kMostParts = 100'000;          // maximum number of splices, edits or values of one request
constexpr std::size_t kMostStills = 16;
constexpr double kWidestStill = 512;     // pixels
constexpr double kMostModules = 20'000;  // maximum number of modules in one answer
constexpr std::size_t kMostExpressions = 1000;
constexpr std::size_t kMostSwept = 64;   // maximum number of values of a sweep
constexpr double kGreatestLength = 1e6;  // metres

/// Reads the members of a request, or of an object in it, and refuses invalid values.
class Members {
 public:
  /// `owner` is the name of the object in its request. Empty: the request itself.
  explicit Members(const Value& object, std::string owner = "") : object_(object), owner_(std::move(owner)) {}

  const std::string& owner() const { return owner_; }

  bool has(const char* name) const {
    const Value* member = object_.find(name);
    return member != nullptr && !member->is_null();
  }

  const Value& value(const char* name) const {
    const Value* member = object_.find(name);
    if (member == nullptr) {
      throw Refusal(fmt::format("{} has no '{}'", owner_.empty() ? "the request" : "'" + owner_ + "'", name));
    }
    return *member;
  }

  const std::string& text(const char* name) const {
    const std::string* text = value(name).text();
    if (text == nullptr) throw Refusal(fmt::format("'{}' is not a text", full(name)));
    return *text;
  }

  double number(const char* name, double low, double high) const {
    const double* number = value(name).number();
    if (number == nullptr || !(*number >= low && *number <= high))
      throw Refusal(fmt::format("'{}' is not a number from {} to {}", full(name), low, high));
    return *number;
  }

  /// Returns a whole number from -2^31 to 2^31 - 1.
  int integer(const char* name, double low, double high) const {
    return static_cast<int>(checked_whole(name, low, high));
  }
  std::uint64_t whole(const char* name, double low = 0, double high = kGreatestWhole) const {
    return static_cast<std::uint64_t>(checked_whole(name, low, high));
  }

  bool flag(const char* name) const {
    const bool* flag = value(name).boolean();
    if (flag == nullptr) throw Refusal(fmt::format("'{}' is neither true nor false", full(name)));
    return *flag;
  }

  const Value::List& list(const char* name) const {
    const Value::List* list = value(name).list();
    if (list == nullptr) throw Refusal(fmt::format("'{}' is not a list", full(name)));
    if (list->size() > kMostParts) throw Refusal(fmt::format("'{}' has more than {} parts", full(name), kMostParts));
    return *list;
  }

  const Value::Object& object(const char* name) const {
    const Value::Object* object = value(name).object();
    if (object == nullptr) throw Refusal(fmt::format("'{}' is not an object", full(name)));
    if (object->size() > kMostParts) throw Refusal(fmt::format("'{}' has more than {} parts", full(name), kMostParts));
    return *object;
  }

  /// Returns the members of a nested object.
  Members within(const char* name) const {
    object(name);
    return Members(value(name), full(name));
  }

  std::optional<std::string> optional_text(const char* name) const {
    return has(name) ? std::optional(text(name)) : std::nullopt;
  }
  std::optional<bool> optional_flag(const char* name) const {
    return has(name) ? std::optional(flag(name)) : std::nullopt;
  }
  std::optional<std::uint64_t> optional_whole(const char* name, double low = 0, double high = kGreatestWhole) const {
    return has(name) ? std::optional(whole(name, low, high)) : std::nullopt;
  }

 private:
  double checked_whole(const char* name, double low, double high) const {
    const double whole = number(name, low, high);
    if (whole != std::floor(whole)) throw Refusal(fmt::format("'{}' is not a whole number", full(name)));
    return whole;
  }
  std::string full(const char* name) const { return owner_.empty() ? name : owner_ + '.' + name; }

  const Value& object_;
  const std::string owner_;
};

constexpr double kMostSeconds = 1e9;
constexpr double kMostIteration = 1e6;
constexpr double kMostGrowthSteps = 1e6;

double checked_time(const Members& members) { return members.number("time", -kMostSeconds, kMostSeconds); }

std::vector<UnitSplice> splices_of(const Members& members) {
  std::vector<UnitSplice> splices;
  for (const Value& value : members.list("patch")) {
    const Value::List* parts = value.list();
    const auto is_count = [](const Value& part) {
      const double* number = part.number();
      return number != nullptr && *number >= 0 && *number <= kGreatestWhole && *number == std::floor(*number);
    };
    if (parts == nullptr || parts->size() != 3 || !is_count((*parts)[0]) || !is_count((*parts)[1]) ||
        (*parts)[2].text() == nullptr) {
      throw Refusal("a splice is [offset, length, \"replacement\"]");
    }
    splices.push_back({static_cast<std::size_t>(*(*parts)[0].number()), static_cast<std::size_t>(*(*parts)[1].number()),
                       *(*parts)[2].text()});
  }
  return splices;
}

std::vector<std::string> texts_of(const Members& members, const char* name) {
  std::vector<std::string> texts;
  for (const Value& value : members.list(name)) {
    if (value.text() == nullptr) throw Refusal(fmt::format("'{}' is not a list of texts", name));
    texts.push_back(*value.text());
  }
  return texts;
}

InsertPart part_edit(const Members& members) {
  InsertPart edit{.text = members.text("paste"),
                  .index = members.optional_whole("index"),
                  .link_index = members.optional_whole("link_index")};
  if (!members.has("names")) return edit;
  for (const auto& [name, other] : members.object("names")) {
    if (other.text() == nullptr) throw Refusal("'names' gives a component another name that is no text");
    edit.names.emplace_back(name, *other.text());
  }
  return edit;
}

PartRequest part_request(const Members& members) {
  PartRequest request{.model = members.optional_text("model"), .text = members.optional_text("text"), .components = {}};
  if (request.model && request.text) throw Refusal("a part is taken from a model or from a text");
  if (members.has("components")) request.components = texts_of(members, "components");
  return request;
}

Edit edit_of(const Value& value) {
  const Members members(value);
  if (members.has("set")) return SetValue{members.text("set"), members.value("value")};
  if (members.has("unset")) return UnsetValue{members.text("unset")};
  if (members.has("insert")) {
    return InsertValue{members.text("insert"), members.value("value"), members.optional_whole("index")};
  }
  if (members.has("remove")) return RemoveValue{members.text("remove")};
  if (members.has("rename")) return RenameValue{members.text("rename"), members.text("name")};
  if (members.has("move")) return MoveValue{members.text("move"), members.whole("index")};
  if (members.has("note")) return SetNote{members.text("note"), members.text("text")};
  if (members.has("paste")) return part_edit(members);
  throw Refusal("an edit is one of set, unset, insert, remove, rename, move, note and paste");
}

std::vector<Edit> edits_of(const Members& members) {
  std::vector<Edit> edits;
  for (const Value& value : members.list("edits")) edits.push_back(edit_of(value));
  return edits;
}

std::vector<Override> overrides_of(const Value::Object& values) {
  std::vector<Override> overrides;
  for (const auto& [path, value] : values)
    overrides.push_back({.path = path, .value = value, .name = "the value of " + path});
  return overrides;
}

OpenRequest open_request(const Members& members) {
  OpenRequest request{.path = members.optional_text("path"),
                      .model = members.optional_text("model"),
                      .text = members.optional_text("text")};
  const bool is_one = request.model ? !request.path : request.path || request.text;
  if (!is_one) throw Refusal("a document is opened by its path, by a model's name, or by a text");
  return request;
}

ViewRequest view_request(const Members& members) {
  ViewRequest request{.drag_triangles = members.optional_whole("drag_triangles", 100, 1e9),
                      .rest_triangles = members.optional_whole("rest_triangles", 100, 1e9),
                      .surface = members.optional_flag("surface"),
                      .skeleton = members.optional_flag("skeleton")};
  if (members.has("time")) request.time = checked_time(members);
  if (members.has("growth")) {
    const Members growth = members.within("growth");
    request.growth.emplace();
    if (growth.has("step")) request.growth->step = static_cast<int>(growth.whole("step", 0, kMostGrowthSteps));
    request.growth->is_recorded = growth.flag("recorded");
    request.growth->of = growth.optional_text("of").value_or("");
  }
  return request;
}

Vec3 vector_of(const Members& members, const char* name) {
  const Value::List& list = members.list(name);
  Vec3 vector(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const double* number = list.size() == 3 ? list[k].number() : nullptr;
    if (number == nullptr || !(std::abs(*number) <= 1e6))
      throw Refusal(fmt::format("'{}' is not a list [x, y, z]", name));
    vector[static_cast<int>(k)] = static_cast<float>(*number);
  }
  return vector;
}

CameraOptions camera_of(const Members& members) {
  return {.position = vector_of(members, "position"),
          .target = vector_of(members, "target"),
          .field_of_view_deg = members.number("field_of_view", 1, 150)};
}

/// The frame has three rows of [axes, origin].
InstanceRequest instance_request(const Members& members) {
  InstanceRequest request{
      .component = members.text("component"), .frame = {}, .position = vector_of(members, "position")};
  const Value::List& rows = members.list("frame");
  for (std::size_t k = 0; k < 12; ++k) {
    const double* number = rows.size() == 12 ? rows[k].number() : nullptr;
    if (number == nullptr || !(std::abs(*number) <= 1e9)) throw Refusal("'frame' is not a list of 12 numbers");
    const auto row = static_cast<int>(k / 4);
    const auto column = static_cast<int>(k % 4);
    (column == 3 ? request.frame.origin[row] : request.frame.axes[column][row]) = static_cast<float>(*number);
  }
  return request;
}

ShootRequest::Go way_of(const std::string& name) {
  using Go = ShootRequest::Go;
  constexpr std::array<std::pair<const char*, Go>, 4> kWays{
      {{"parent", Go::parent}, {"child", Go::child}, {"next", Go::next}, {"previous", Go::previous}}};
  for (const auto& [known, way] : kWays) {
    if (name == known) return way;
  }
  throw Refusal("'go' is none of parent, child, next, previous");
}

ShootRequest shoot_request(const Members& members) {
  ShootRequest request{.component = members.text("component"), .of = {}};
  if (members.has("of")) {
    const Members of = members.within("of");
    const auto number = [&](const char* name) { return static_cast<std::uint32_t>(of.whole(name, 0, kNoStem - 1.0)); };
    request.of = {
        .stem = number("stem"), .tree = number("tree"), .shoot = of.text("shoot"), .metamer = number("metamer")};
  }
  if (members.has("go")) request.go = way_of(members.text("go"));
  return request;
}

WorkedOutRequest worked_out_request(const Members& members) {
  WorkedOutRequest request{.component = members.optional_text("component"), .expressions = {}};
  const Value::Object& given = members.object("expressions");
  if (given.size() > kMostExpressions)
    throw Refusal(fmt::format("'expressions' has more than {} parts", kMostExpressions));
  for (const auto& [path, text] : given) {
    if (text.text() == nullptr) throw Refusal("'expressions' is not an object of texts by their paths");
    request.expressions.emplace_back(path, *text.text());
  }
  return request;
}

CurvesRequest curves_request(const Members& members) {
  CurvesRequest request{.component = members.text("component"), .rank = {}, .leaf = {}};
  if (members.has("rank")) request.rank = members.integer("rank", -kMostIteration, kMostIteration);
  if (members.has("leaf")) request.leaf = members.integer("leaf", -kMostIteration, kMostIteration);
  return request;
}

OperationsRequest operations_request(const Members& members) {
  OperationsRequest request{.component = members.text("component"),
                            .operation = members.optional_text("operation").value_or(""),
                            .iteration = {}};
  if (members.has("iteration")) request.iteration = static_cast<int>(members.whole("iteration", 0, kMostIteration));
  return request;
}

film::FrameTimes frames_of(const Members& members) {
  const film::FrameTimes frames{.from = members.number("from", 0, kMostSeconds),
                                .to = members.number("to", 0, kMostSeconds),
                                .step = members.number("step", 1e-6, kMostSeconds)};
  const std::string wanted = film::wanting(frames);
  if (!wanted.empty()) throw Refusal(fmt::format("'{}' needs {}", members.owner(), wanted));
  return frames;
}

ExportOptions export_options(const Members& members) {
  ExportOptions options{.format = members.text("format"), .name = members.optional_text("name")};
  if (!members.has("options")) return options;
  const Members given = members.within("options");
  options.lod = static_cast<int>(given.optional_whole("lod", 0, kCoarsestDetail).value_or(0));
  options.instances = given.optional_text("instances").value_or("");
  options.seed = given.optional_whole("seed");
  if (given.has("time")) options.time = checked_time(given);
  const auto pixels = [&](const char* name) -> std::optional<int> {
    if (!given.has(name)) return std::nullopt;
    return static_cast<int>(given.whole(name, 1, 16384));
  };
  options.width = pixels("width");
  options.height = pixels("height");
  if (given.has("samples")) options.samples = static_cast<int>(given.whole("samples", 1, 65536));
  options.transparent = given.optional_flag("transparent").value_or(false);
  if (given.has("camera")) options.camera = camera_of(given.within("camera"));
  if (given.has("frames")) options.frames = frames_of(given.within("frames"));
  return options;
}

StillsRequest stills_request(const Members& members) {
  StillsRequest request;
  const Value::List& states = members.list("states");
  if (states.size() > kMostStills) throw Refusal(fmt::format("'states' has more than {} parts", kMostStills));
  for (const Value& state : states) {
    if (state.object() == nullptr) throw Refusal("a state is an object of values by their paths");
    if (state.object()->size() > kMostParts) throw Refusal(fmt::format("a state has more than {} parts", kMostParts));
    request.states.push_back(overrides_of(*state.object()));
  }
  if (states.empty()) return request;
  request.width = static_cast<int>(members.whole("width", 16, kWidestStill));
  request.height = static_cast<int>(members.whole("height", 16, kWidestStill));
  request.camera = camera_of(members.within("camera"));
  request.fits = members.optional_flag("fit").value_or(true);
  return request;
}

MeasuresRequest measures_request(const Members& members) {
  MeasuresRequest request{.light = members.optional_flag("light").value_or(false)};
  if (members.has("layer_height")) request.layer_height = members.number("layer_height", 0, kGreatestLength);
  return request;
}

SweepRequest sweep_request(const Members& members) {
  SweepRequest request{
      .path = members.text("path"), .values = {}, .light = members.optional_flag("light").value_or(false)};
  for (const Value& value : members.list("values")) {
    if (value.number() == nullptr || !std::isfinite(*value.number()))
      throw Refusal("'values' is not a list of numbers");
    request.values.push_back(*value.number());
  }
  if (request.values.empty() || request.values.size() > kMostSwept)
    throw Refusal(fmt::format("'values' has 1 to {} numbers", kMostSwept));
  return request;
}

/// Returns the number of 16 hexadecimal digits.
std::uint64_t key_of(const std::string& text) {
  std::uint64_t key = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, key, 16);
  if (text.size() != 16 || error != std::errc() || stop != end)
    throw Refusal("'instance' is not the key of an instance");
  return key;
}

GrammarRequest grammar_request(const Members& members) {
  GrammarRequest request{.component = members.text("component"), .step = {}};
  if (members.has("step")) request.step = static_cast<int>(members.whole("step", 0, kMostSteps));
  if (members.has("instance")) request.key = key_of(members.text("instance"));
  request.number = members.optional_whole("number").value_or(0);
  request.is_drawn = members.optional_flag("drawn").value_or(false);
  request.first = members.optional_whole("first").value_or(0);
  request.count = members.optional_whole("count", 0, kMostModules).value_or(request.count);
  return request;
}

Request request_of(const std::string& what, const Members& members) {
  if (what == "open") return open_request(members);
  if (what == "splice") return SpliceRequest{members.text("base"), splices_of(members)};
  if (what == "text") return TextRequest{members.text("text")};
  if (what == "edit") {
    return EditRequest{members.text("base"), edits_of(members), members.optional_flag("only_if_good").value_or(false)};
  }
  if (what == "drag") return DragRequest{overrides_of(members.object("values"))};
  if (what == "view") return view_request(members);
  if (what == "shown") return ShownRequest{members.whole("packet")};
  if (what == "all") return AllRequest{};
  if (what == "cancel") {
    return members.has("re") ? CancelRequest{static_cast<double>(members.whole("re"))} : CancelRequest{};
  }
  if (what == "continue") return ContinueRequest{};
  if (what == "pause") return PauseRequest{members.flag("paused")};
  if (what == "files") return FilesRequest{members.text("folder")};
  if (what == "save") {
    return SaveRequest{members.text("path"), members.text("hash"), members.optional_text("saved"),
                       members.optional_flag("over").value_or(false)};
  }
  if (what == "models") return ModelsRequest{};
  if (what == "stills") return stills_request(members);
  if (what == "grammar") return grammar_request(members);
  if (what == "overlays") return OverlaysRequest{texts_of(members, "parts")};
  if (what == "clocks") return ClocksRequest{members.number("up_to", 0, kMostSeconds)};
  if (what == "picture") {
    return PictureRequest{members.text("file"), static_cast<int>(members.optional_whole("size", 16, 512).value_or(96))};
  }
  if (what == "measures") return measures_request(members);
  if (what == "measure_rows") return MeasureRowsRequest{};
  if (what == "sweep") return sweep_request(members);
  if (what == "instance") return instance_request(members);
  if (what == "shoot") return shoot_request(members);
  if (what == "stand") return StandRequest{members.text("component")};
  if (what == "worked_out") return worked_out_request(members);
  if (what == "curves") return curves_request(members);
  if (what == "cloud") return CloudRequest{members.text("component")};
  if (what == "operations") return operations_request(members);
  if (what == "parts") return PartsRequest{members.text("model")};
  if (what == "part") return part_request(members);
  if (what == "export") return ExportRequest{export_options(members)};
  if (what == "command") return CommandRequest{export_options(members)};
  throw Refusal(fmt::format("there is no request '{}'", what.substr(0, 40)));
}

/// Returns limits that accept a document of the maximum size with all of its characters escaped. A longer message is
/// then refused for its own length only.
Limits message_limits() {
  Limits limits;
  limits.document_bytes = std::numeric_limits<std::uint64_t>::max();
  limits.nesting += 8;
  return limits;
}

Value read_json(std::string_view message) {
  try {
    return parse_json(message, message_limits());
  } catch (const InputError& error) {
    throw Refusal(fmt::format("the message is not JSON: {}", error.what()));
  }
}

double id_of(const Value& message) {
  if (message.object() == nullptr) throw Refusal("the message is not an object");
  return static_cast<double>(Members(message).whole("id"));
}

}  // namespace

std::optional<double> request_id(std::string_view message) noexcept {
  try {
    return id_of(read_json(message));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

NumberedRequest read_request(std::string_view message) {
  const Value value = read_json(message);
  const double id = id_of(value);
  const Members members(value);
  return {id, request_of(members.text("do"), members)};
}

}  // namespace meristem::studio
