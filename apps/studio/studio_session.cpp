// SPDX-License-Identifier: Apache-2.0
// Handles a page's document and the requests with an immediate answer. Requests with a later answer are in
// session_jobs.cpp.
#include "studio_session.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "export_job.h"
#include "meristem/base/version.h"
#include "meristem/base/visible_text.h"
#include "meristem/document/json.h"
#include "meristem/document/models.h"
#include "named_files.h"
#include "overlays_value.h"
#include "part_values.h"
#include "refusal.h"
#include "text_units.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

constexpr int kProtocol = 1;
constexpr const char* kUntitled = "untitled.json";

Value text_or_null(const std::optional<std::string>& text) { return text ? Value(*text) : Value(); }

Value limits_value(const StudioLimits& limits) {
  return Value::Object{{"message_bytes", static_cast<double>(limits.message_bytes)},
                       {"messages_per_second", limits.messages_per_second},
                       {"job_seconds", limits.job_seconds},
                       {"film_seconds", limits.film_seconds},
                       {"memory_bytes", static_cast<double>(limits.memory_bytes)},
                       {"connections", limits.connections}};
}

std::string text_member(const Value& document, const char* name) {
  const Value* member = document.find(name);
  return member != nullptr && member->text() != nullptr ? *member->text() : std::string();
}

bool is_model(const Host& host, const std::string& name) {
  const std::vector<std::string> models = model_names(host.models_folder), films = film_names(host.models_folder);
  return std::ranges::find(models, name) != models.end() || std::ranges::find(films, name) != films.end();
}

/// Returns the tree of a text, or null if the text is not JSON.
Value tree_of(const std::string& text, const Progress* progress = nullptr) {
  try {
    return parse_json(text, {}, progress);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

StudioSession::StudioSession(Host& host, std::shared_ptr<Outbox> outbox, std::shared_ptr<Readings> readings)
    : host_(host),
      outbox_(std::move(outbox)),
      grower_(std::make_shared<Grower>(host, outbox_)),
      readings_(readings != nullptr ? std::move(readings) : std::make_shared<Readings>()) {
  outbox_->send_text(write_json_line(Value::Object{{"is", "hello"},
                                                   {"protocol", kProtocol},
                                                   {"version", std::string(version())},
                                                   {"root", host_.root.name()},
                                                   {"root_key", text_hash(host_.root.path())},
                                                   {"document", text_or_null(host_.document)},
                                                   {"model", text_or_null(host_.model)},
                                                   {"formats", formats_value()},
                                                   {"overlays", overlay_parts_value()},
                                                   {"limits", limits_value(host_.limits)}}));
}

StudioSession::~StudioSession() {
  for (const auto& jobs : {jobs_, stills_, derivations_, sweeps_, measures_}) jobs->close();
  grower_->close();
}

void StudioSession::receive(std::string_view message) {
  std::optional<double> id;
  readings_->begin_next();
  try {
    if (message.size() > host_.limits.message_bytes) {
      throw limit_refusal(fmt::format("the message has {} bytes; at most {} are allowed (message_bytes)",
                                      message.size(), host_.limits.message_bytes),
                          "message_bytes");
    }
    require_rate();
    const NumberedRequest request = read_request(message);
    id = request.id;
    std::optional<Answer> done = std::visit([&](const auto& asked) { return act(request.id, asked); }, request.request);
    if (done) answer(request.id, std::move(*done));
    // Called only now, so that no packet of a document comes before the answer that opens it.
    if (std::exchange(is_opened_, false)) grower_->open({.document = document_, .hash = hash_});
    watch_file();
    return;
  } catch (const Cancelled&) {
    refuse(id, "cancelled", {{"cancelled", true}});
  } catch (const Refusal& refusal) {
    refuse(id ? id : request_id(message.substr(0, host_.limits.message_bytes)), refusal.what(), refusal.members());
  } catch (const InputError& error) {
    refuse(id, error.what(), {{"faults", errors_value(error.diagnostics(), {}, "")}});
  } catch (const std::bad_alloc&) {
    refuse(id, "there is not enough memory (memory_bytes)", {{"limit", "memory_bytes"}});
  } catch (const std::exception& error) {
    refuse(id, error.what(), {});
  }
  take_unread_drag();
}

void StudioSession::require_rate() {
  const auto now = std::chrono::steady_clock::now();
  while (!received_.empty() && now - received_.front() >= std::chrono::seconds(1)) received_.pop_front();
  if (received_.size() >= static_cast<std::size_t>(host_.limits.messages_per_second)) {
    throw limit_refusal(fmt::format("more than {} messages came within a second (messages_per_second)",
                                    host_.limits.messages_per_second),
                        "messages_per_second");
  }
  received_.push_back(now);
}

void StudioSession::refuse(std::optional<double> id, const std::string& message, const Value::Object& members) {
  Value::Object refusal{{"is", "refused"}, {"re", id ? Value(*id) : Value()}, {"message", visible_lines(message)}};
  for (const auto& member : members) refusal.push_back(member);
  outbox_->send_text(write_json_line(refusal));
}

void StudioSession::answer(double id, Answer answer) {
  Value::Object done{{"is", "done"}, {"re", id}};
  for (auto& member : answer) done.push_back(std::move(member));
  outbox_->send_text(write_json_line(done));
}

Session& StudioSession::session() {
  if (!session_) throw Refusal("no document is open");
  return *session_;
}

void StudioSession::require_base(const std::string& base) {
  session();
  if (base != hash_) throw Refusal("the edit belongs to another text than the server's", {{"stale", true}});
}

/// Replaces the session by a new one, whose text is not read yet. Arguments are passed by value, because they may come
/// from the session that is destroyed.
void StudioSession::begin_session(std::string text, std::string file) {
  session_ = std::make_unique<Session>(
      std::move(text), std::move(file), host_.registry,
      SessionOptions{.root = root_, .models = host_.models_folder, .max_undone = 0, .reads_at_once = false});
  hash_ = text_hash(session_->text());
  unread_drag_.reset();
}

/// Reads the text and adds its facts to the answer. If a newer message makes the reading useless, answers that it was
/// superseded and returns false.
bool StudioSession::read_text(double id, MessageKind kind, Answer& answer) {
  const std::size_t members = answer.size();
  try {
    const Readings::Reading reading(*readings_, id, kind);
    if (unread_drag_) session().set_overrides(unread_drag_->values, &reading.progress());
    unread_drag_.reset();
    session().read(&reading.progress());
    add_reading(answer, session(), path_.value_or(title_), reading.progress());
    return true;
  } catch (const Cancelled&) {
    answer.resize(members);
    answer.emplace_back("superseded", true);
    return false;
  }
}

/// Reads the text if an earlier reading was superseded, because the present request needs it.
void StudioSession::read_now(double id) {
  const Readings::Reading reading(*readings_, id, MessageKind::other);
  session().read(&reading.progress());
}

/// Shows the document of the text if it has no errors.
void StudioSession::show(bool at_once) {
  if (!session().is_good()) return;
  document_ = session().shared_document();
  grower_->want({.document = document_, .hash = hash_, .is_dragged = !session().overrides().empty()}, at_once);
}

/// Watches which other pages have the file open, and reports them to the page. Called after the answer with the file's
/// path.
void StudioSession::watch_file() {
  if (watched_ == path_) return;
  watched_ = path_;
  watch_ = path_ ? std::make_shared<OpenFileWatch>(host_, outbox_, *path_) : nullptr;
  if (watch_) watch_->begin();
}

/// Adds the facts of a text that was read to an answer. `name` is the name of the file in messages.
void StudioSession::add_reading(Answer& answer, const Session& read, const std::string& name,
                                const Progress& progress) const {
  answer.emplace_back("good", read.is_good());
  answer.emplace_back("faults", errors_value(read.errors(), read.text(), name));
  answer.emplace_back("tree", tree_of(read.text(), &progress));
  answer.emplace_back("variables", read.is_good() ? variables_value(read.document()->variables) : Value::List{});
  answer.emplace_back("implied",
                      read.document() != nullptr ? implied_links_value(read.document()->graph) : Value::List{});
  answer.emplace_back("notes", notes_value(read.text(), &progress));
}

std::string StudioSession::model_text(const std::string& model) const {
  if (!is_model(host_, model)) throw Refusal("there is no such model");
  return read_text_file(model_path(host_.models_folder, model));
}

StudioSession::Opened StudioSession::opened(const OpenRequest& request) const {
  if (request.model) {
    std::string shipped = model_text(*request.model);
    return {.text = request.text ? *request.text : std::move(shipped),
            .file = model_path(host_.models_folder, *request.model),
            .root = host_.models_folder,
            .path = {},
            .name = *request.model};
  }
  Opened opened{.root = host_.root.path(), .path = request.path};
  if (request.path) {
    opened.file = host_.root.absolute(*request.path);
    opened.name = fs::path(*request.path).filename().string();
    if (!request.text) opened.text = host_.root.read(*request.path);
    opened.saved = request.text ? host_.root.hash_on_disk(*request.path) : text_hash(opened.text);
  } else {
    opened.file = (fs::path(opened.root) / kUntitled).string();
    opened.name = "untitled";
  }
  if (request.text) opened.text = *request.text;
  return opened;
}

/// Applies the values of a drag whose reading was stopped by a request that was then refused.
void StudioSession::take_unread_drag() {
  if (!unread_drag_) return;
  try {
    const Readings::Reading reading(*readings_, unread_drag_->request, MessageKind::drag);
    session().set_overrides(unread_drag_->values, &reading.progress());
    unread_drag_.reset();
    show(session().overrides().empty());
  } catch (const std::exception&) {
    // Stopped again: the newer message either has other values or applies these.
  }
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const OpenRequest& request) {
  Opened found = opened(request);
  auto next = std::make_unique<Session>(
      std::move(found.text), std::move(found.file), host_.registry,
      SessionOptions{.root = found.root, .models = host_.models_folder, .max_undone = 0, .reads_at_once = false});
  Answer said;
  {
    // If this is cancelled, the previous document stays.
    const Readings::Reading reading(*readings_, id, MessageKind::open);
    next->read(&reading.progress());
    add_reading(said, *next, found.path.value_or(found.name), reading.progress());
  }
  cancel_jobs();
  grower_->leave();
  still_maker_ = std::make_shared<StillMaker>();
  sweep_maker_ = std::make_shared<SweepMaker>();
  root_ = found.root;
  path_ = found.path;
  model_ = request.model;
  title_ = found.name;
  session_ = std::move(next);
  unread_drag_.reset();
  hash_ = text_hash(session_->text());
  document_ = session_->is_good() ? session_->shared_document() : nullptr;
  is_opened_ = true;
  Answer answer{{"path", text_or_null(path_)},
                {"model", text_or_null(model_)},
                {"name", title_},
                {"text", session_->text()},
                {"hash", hash_},
                {"saved", text_or_null(found.saved)}};
  answer.insert(answer.end(), std::make_move_iterator(said.begin()), std::make_move_iterator(said.end()));
  return answer;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const SpliceRequest& request) {
  require_base(request.base);
  try {
    session().change_text(in_bytes(session().text(), request.patch));
  } catch (const std::invalid_argument& error) {
    throw Refusal(error.what(), {{"stale", true}});
  }
  hash_ = text_hash(session().text());
  Answer answer{{"hash", hash_}};
  if (read_text(id, MessageKind::text, answer)) show(false);
  return answer;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const TextRequest& request) {
  begin_session(request.text, session().file());
  Answer answer{{"hash", hash_}};
  if (read_text(id, MessageKind::text, answer)) show(false);
  return answer;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const EditRequest& request) {
  require_base(request.base);
  read_now(id);
  const std::string before = session().text();
  const bool was_dragged = !session().overrides().empty();
  const bool was_good = session().is_good();
  const Readings::Reading reading(*readings_, id, MessageKind::edit);
  const Progress* progress = &reading.progress();
  const Change change = session().edit(request.edits, progress);
  Answer answer;
  try {
    if (request.only_if_good && was_good && !session().is_good()) {
      Value errors = errors_value(session().errors(), session().text(), path_.value_or(title_));
      const std::string message = session().errors()[0].message;
      session().edit_text(change.inverse, progress);
      throw Refusal(message, {{"faults", std::move(errors)}});
    }
    if (was_dragged) session().set_overrides({}, progress);
    answer = {{"patch", patch_value(in_units(before, change.patch))},
              {"inverse", patch_value(in_units(session().text(), change.inverse))},
              {"hash", text_hash(session().text())}};
    add_reading(answer, session(), path_.value_or(title_), *progress);
  } catch (const Cancelled&) {
    session().change_text(change.inverse);
    throw;
  }
  hash_ = text_hash(session().text());
  unread_drag_.reset();
  show(was_dragged);
  return answer;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const DragRequest& request) {
  const bool was_dragged = !session().overrides().empty();
  try {
    const Readings::Reading reading(*readings_, id, MessageKind::drag);
    session().set_overrides(request.values, &reading.progress());
    unread_drag_.reset();
  } catch (const Cancelled&) {
    unread_drag_ = UnreadDrag{id, request.values};
    return Answer{{"faults", Value::List{}}, {"superseded", true}};
  }
  Answer answer{{"faults", session().is_good() ? Value::List{} : errors_value(session().errors(), {}, "")}};
  if (was_dragged || !request.values.empty()) show(request.values.empty());
  return answer;
}

std::optional<StudioSession::Answer> StudioSession::act(double, const ViewRequest& request) {
  ShownParts parts = grower_->parts();
  if (request.drag_triangles) parts.drag_triangles = *request.drag_triangles;
  if (request.rest_triangles) parts.rest_triangles = *request.rest_triangles;
  if (request.surface) parts.surface = *request.surface;
  if (request.skeleton) parts.skeleton = *request.skeleton;
  if (request.time) parts.time = *request.time;
  if (request.growth) {
    parts.step = request.growth->step;
    parts.is_recorded = request.growth->is_recorded;
    parts.of = request.growth->of;
  }
  grower_->set_parts(parts);
  return Answer{};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const ShownRequest& request) {
  grower_->acknowledge(request.packet);
  return Answer{};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const AllRequest&) {
  grower_->send_all();
  return Answer{};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const CancelRequest& request) {
  if (request.re) cancel_jobs(request.re);
  if (!request.re) grower_->cancel();
  return Answer{};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const ContinueRequest&) {
  grower_->go_on();
  return Answer{};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const PauseRequest& request) {
  grower_->pause(request.paused);
  return Answer{};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const FilesRequest& request) {
  Value::List files;
  for (const FolderEntry& entry : host_.root.list(request.folder)) {
    files.push_back(
        Value::Object{{"name", entry.name}, {"folder", entry.is_folder}, {"bytes", static_cast<double>(entry.bytes)}});
  }
  return Answer{{"folder", request.folder}, {"files", std::move(files)}};
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const SaveRequest& request) {
  const std::string& text = session().text();
  const std::string hash = text_hash(text);
  if (hash != request.hash) {
    throw Refusal("the page holds another text than the server; nothing was written", {{"stale", true}});
  }
  host_.root.write(request.path, text, request.saved, request.over);
  const bool is_elsewhere = path_ != request.path;
  path_ = request.path;
  model_ = {};
  title_ = fs::path(request.path).filename().string();
  Answer answer{{"path", request.path}, {"name", title_}, {"saved", hash}};
  if (!is_elsewhere) return answer;
  // Files that the document names are now searched relative to its new folder.
  if (session().document() != nullptr) {
    const std::string folder = fs::path(request.path).parent_path().generic_string();
    const NamedFileCopies copies = copy_named_files(*session().document(), root_, host_.root, folder);
    answer.emplace_back("copied", copied_value(copies));
    answer.emplace_back("omitted", omitted_value(copies));
  }
  root_ = host_.root.path();
  begin_session(text, host_.root.absolute(request.path));
  if (read_text(id, MessageKind::edit, answer)) show(false);
  return answer;
}

std::optional<StudioSession::Answer> StudioSession::act(double, const ModelsRequest&) {
  Value::List models;
  for (const std::string& name : model_names(host_.models_folder)) {
    const Value document = tree_of(read_text_file(model_path(host_.models_folder, name)));
    models.push_back(Value::Object{{"name", name},
                                   {"title", text_member(document, "name")},
                                   {"description", text_member(document, "description")},
                                   {"picture", host_.has_picture != nullptr && host_.has_picture(name)}});
  }
  return Answer{{"models", std::move(models)}};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const PartsRequest& request) {
  const std::string text = model_text(request.model);
  const Document document = read_document(text, model_path(host_.models_folder, request.model), host_.registry,
                                          {.root = host_.models_folder, .models = host_.models_folder});
  return Answer{{"tree", tree_of(text)}, {"implied", implied_links_value(document.graph)}};
}

std::optional<StudioSession::Answer> StudioSession::act(double, const PartRequest& request) {
  const std::string text = request.text ? *request.text : request.model ? model_text(*request.model) : session().text();
  const Value tree = parse_json(text);
  std::vector<std::string> components = request.components;
  if (components.empty()) components = placeable_components(tree, host_.registry);
  if (components.empty()) throw Refusal("the text has no components");
  Value::List names;
  for (const std::string& id : components) names.push_back(id);
  return Answer{{"text", plant_part(text, components)},
                {"components", std::move(names)},
                {"roots", part_roots_value(tree, components)}};
}

}  // namespace meristem::studio
