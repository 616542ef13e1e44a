// SPDX-License-Identifier: Apache-2.0
// Grows and shows one document, in a loop of small jobs. The loop grows the newest state, makes meshes of the permitted
// detail, sends a packet, and waits until the page has shown it. A mutex guards the requests; caches belong to the
// worker's thread.
#include "grower.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <utility>

#include "job_messages.h"
#include "job_watch.h"
#include "meristem/base/large_memory.h"
#include "meristem/base/visible_text.h"
#include "meristem/document/json.h"
#include "meristem/graph/instances.h"
#include "meristem/output/picture/obstacle_meshes.h"
#include "meristem/plant/plant_variant.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

constexpr double kLarge = 20;  // a document with this many times the triangles of a draft shows a draft first

Value number_value(std::uint64_t number) { return static_cast<double>(number); }

bool have_same_shape(const Stem& a, const Stem& b) {
  const auto is_alike = [](const StemPart& one, const StemPart& other) {
    return one.component == other.component && one.material == other.material && one.surface == other.surface;
  };
  const Skeleton& one = a.skeleton;
  const Skeleton& other = b.skeleton;
  return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(), is_alike) &&
         a.part_of_axis == b.part_of_axis && one.parent == other.parent && one.position == other.position &&
         one.radius == other.radius && one.axis == other.axis;
}

bool have_same_shape(const Mesh& one, const Mesh& other) {
  return &one == &other ||
         (one.positions == other.positions && one.triangles == other.triangles && one.uvs == other.uvs);
}

/// Returns true if two plants differ only in their looks.
bool have_same_shape(const Plant& a, const Plant& b) {
  const auto stems_are_alike = [](const Stem& one, const Stem& other) { return have_same_shape(one, other); };
  const auto prototypes_are_alike = [](const OrganPrototype& one, const OrganPrototype& other) {
    return one.component == other.component && one.material == other.material &&
           have_same_shape(*one.mesh, *other.mesh);
  };
  const auto organs_are_alike = [](const Organ& one, const Organ& other) {
    return one.prototype == other.prototype && one.frame.axes == other.frame.axes &&
           one.frame.origin == other.frame.origin;
  };
  return std::equal(a.stems.begin(), a.stems.end(), b.stems.begin(), b.stems.end(), stems_are_alike) &&
         std::equal(a.prototypes.begin(), a.prototypes.end(), b.prototypes.begin(), b.prototypes.end(),
                    prototypes_are_alike) &&
         std::equal(a.organs.begin(), a.organs.end(), b.organs.begin(), b.organs.end(), organs_are_alike);
}

/// Returns a document at a time. Returns the document itself if its keys change nothing.
std::shared_ptr<const Document> standing_at(const std::shared_ptr<const Document>& document, double time,
                                            const Progress& progress) {
  std::optional<Document> other;
  document_at(*document, time, other, &progress);
  return other ? std::make_shared<const Document>(*std::move(other)) : document;
}

Value reuse_value(const std::vector<ReuseCount>& grown, const std::vector<ReuseCount>& clothed) {
  Value::List list;
  for (const std::vector<ReuseCount>* counts : {&grown, &clothed}) {
    for (const auto& [what, count] : *counts) {
      list.push_back(
          Value::Object{{"what", what}, {"made", number_value(count.made)}, {"reused", number_value(count.reused)}});
    }
  }
  return list;
}

Value component_counts(const MeshScene& scene) {
  std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> counts;
  for (const MeshInstances& instances : scene.meshes) {
    counts[instances.component].first += instances.count();
    counts[instances.component].second += instances.triangle_count();
  }
  Value::Object object;
  for (const auto& [component, count] : counts) {
    object.emplace_back(
        component, Value::Object{{"instances", number_value(count.first)}, {"triangles", number_value(count.second)}});
  }
  return object;
}

/// Returns true if a draft must come first, because the plant has many triangles.
bool is_large(const GrownPlant& grown, const ShownParts& parts) {
  if (!parts.surface || parts.drag_triangles >= parts.rest_triangles) return false;
  return static_cast<double>(grown.about_triangles) > kLarge * static_cast<double>(parts.drag_triangles);
}

/// Returns a budget as a share of `all` triangles, below 1.
double share_of(std::uint64_t budget, std::uint64_t all) {
  return std::min(0.99, static_cast<double>(budget) / static_cast<double>(std::max<std::uint64_t>(all, 1)));
}

}  // namespace

GrowthView ShownParts::view() const {
  if (!is_recorded && !step) return {};
  return {.step = step, .request = TraceRequest::all(), .of = of};
}

void Grower::leave() {
  const std::lock_guard lock(mutex_);
  if (running_ != nullptr) running_->cancel();
  stopped_ = Stopped::nothing;
  is_other_ = true;
  grown_ = nullptr;
  done_ = requested_;
}

void Grower::open(GrowthRequest request) {
  const std::lock_guard lock(mutex_);
  if (running_ != nullptr) running_->cancel();
  request_ = std::move(request);
  ++requested_;
  last_input_ = {};
  grown_ = nullptr;
  shown_ = {};
  fits_ = true;
  forgets_ = true;
  is_other_ = true;
  schedule();
}

void Grower::want(GrowthRequest request, bool at_once) {
  const std::lock_guard lock(mutex_);
  if (at_once && running_ != nullptr) running_->cancel();
  request_ = std::move(request);
  ++requested_;
  last_input_ = Clock::now();
  schedule();
}

void Grower::set_parts(const ShownParts& parts) {
  const std::lock_guard lock(mutex_);
  if (parts == parts_) return;
  if (parts.time != parts_.time || parts.view() != parts_.view()) {
    ++requested_;
    last_input_ = Clock::now();
  }
  parts_ = parts;
  schedule();
}

ShownParts Grower::parts() const {
  const std::lock_guard lock(mutex_);
  return parts_;
}

void Grower::acknowledge(std::uint64_t packet) {
  const std::lock_guard lock(mutex_);
  if (packet != awaited_) return;
  awaited_ = 0;
  if (shown_.is_draft) last_seen_ = Clock::now();
  schedule();
}

void Grower::send_all() {
  const std::lock_guard lock(mutex_);
  forgets_ = true;
  shown_ = {};
  awaited_ = 0;  // the page that requests everything has lost the packet on its way
  schedule();
}

void Grower::cancel() {
  const std::lock_guard lock(mutex_);
  if (running_ != nullptr) running_->cancel();
  done_ = requested_;
}

void Grower::go_on() {
  const std::lock_guard lock(mutex_);
  const Stopped stopped = std::exchange(stopped_, Stopped::nothing);
  if (stopped == Stopped::nothing) return;
  if (stopped == Stopped::growth) ++requested_;
  if (stopped == Stopped::meshing) shown_ = {};
  schedule();
}

void Grower::pause(bool is_paused) {
  const std::lock_guard lock(mutex_);
  is_paused_ = is_paused;
  schedule();
}

void Grower::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  if (running_ != nullptr) running_->cancel();
}

std::shared_ptr<const GrownPlant> Grower::grown() const {
  const std::lock_guard lock(mutex_);
  return grown_;
}

void Grower::ask(std::function<void(const LastGrown* last)> question) {
  host_.growth.post([self = shared_from_this(), question = std::move(question)] {
    const std::shared_ptr<const GrownPlant> grown = self->grown();
    if (grown == nullptr) return question(nullptr);
    const LastGrown last{*grown, self->whole_meshes(*grown), self->cache_};
    question(&last);
  });
}

void Grower::schedule() {
  if (is_scheduled_ || is_closed_) return;
  is_scheduled_ = true;
  host_.growth.post([self = shared_from_this()] { self->work(); });
}

void Grower::work() {
  {
    const std::lock_guard lock(mutex_);
    is_scheduled_ = false;
    if (is_closed_) return;
  }
  grow();
  show();
}

/// Runs a part of the work and reports its progress. Faults and limits are sent as messages.
template <class Work>
void Grower::run(const std::string& hash, Stopped if_stopped, Work&& work) {
  JobMessages messages(outbox_, "grow");
  JobWatch watch(messages.progress(), host_.limits);
  const std::uint64_t number = [&] {
    const std::lock_guard lock(mutex_);
    running_ = &messages.progress();
    // The request to continue growing is kept while older results are shown.
    if (if_stopped == Stopped::growth || stopped_ == Stopped::meshing) stopped_ = Stopped::nothing;
    return requested_;
  }();
  try {
    work(messages);
  } catch (const Cancelled&) {
    if (const std::optional<Refusal> limit = watch.reached()) {
      Value::Object members = limit->members();
      const bool can_go_on = watch.has_reached_time();
      members.emplace_back("continues", can_go_on);
      if (can_go_on) {
        const std::lock_guard lock(mutex_);
        if (requested_ == number && !is_other_ && stopped_ == Stopped::nothing) stopped_ = if_stopped;
      }
      send_failure(hash, limit->what(), std::move(members));
    }
  } catch (const InputError& error) {
    send_failure(hash, error.what(), {{"faults", errors_value(error.diagnostics(), {}, "")}});
  } catch (const std::bad_alloc&) {
    send_failure(hash, "there is not enough memory (memory_bytes)", {{"limit", "memory_bytes"}});
  } catch (const std::exception& error) {
    send_failure(hash, error.what(), {});
  }
  const std::lock_guard lock(mutex_);
  running_ = nullptr;
  if (requested_ != number) schedule();
}

void Grower::send_failure(const std::string& hash, const std::string& message, Value::Object members) {
  {
    const std::lock_guard lock(mutex_);
    if (is_closed_ || is_other_) return;
  }
  Value::Object failed{{"is", "failed"}, {"job", "grow"}, {"hash", hash}, {"message", visible_lines(message)}};
  for (auto& member : members) failed.push_back(std::move(member));
  outbox_->send_text(write_json_line(failed));
}

void Grower::grow() {
  GrowthRequest request;
  double time = 0;
  GrowthView view;
  std::uint64_t number = 0;
  bool is_first = false;  // of another document
  {
    const std::lock_guard lock(mutex_);
    if (done_ == requested_ || is_paused_ || request_.document == nullptr) return;
    request = request_;
    time = parts_.time;
    view = parts_.view();
    number = requested_;
    done_ = number;  // counts as done even if it fails
    is_first = std::exchange(is_other_, false);
    if (is_first) {
      for (GrowthCache* cache : {&cache_, &mesh_caches_[0], &mesh_caches_[1]}) cache->clear();
      meshes_ = nullptr;
      meshes_of_ = nullptr;
    }
  }
  if (is_first) give_back_memory();
  run(request.hash, Stopped::growth, [&](JobMessages& messages) {
    const std::shared_ptr<const Document> document = standing_at(request.document, time, messages.progress());
    GrownDocument grown = grow_document(*document, messages.progress(),
                                        {.time = time, .up_to = GrownPart::plant, .cache = &cache_, .view = view});
    if (request.is_dragged) pictures_.lend(document->graph, grown.plant.materials);
    grown.up_to = GrownPart::meshes;  // meshes are made later, when their permitted detail is known
    complete_growth(*document, grown, messages.progress(), {.time = time, .cache = &cache_});
    auto made = std::make_shared<GrownPlant>(GrownPlant{.request = request,
                                                        .time = time,
                                                        .document = document,
                                                        .view = view,
                                                        .plant = std::move(grown.plant),
                                                        .traces = std::move(grown.traces)});
    made->about_triangles = static_cast<std::uint64_t>(about_triangles(made->plant));
    stages_ = messages.stages();
    grown_reuse_ = reuse_of(cache_);
    if (!request.is_dragged && document->scene.fingerprint) {
      made->placed = instance_counts(document->graph, document->scene, time, messages.progress(), &cache_, view);
    }
    const std::lock_guard lock(mutex_);
    if (!is_other_) grown_ = std::move(made);
  });
}

bool Grower::is_shown(const Sight& sight) const {
  return shown_.grown == sight.grown && shown_.parts == sight.parts && (!shown_.is_draft || sight.is_draft);
}

/// Shows the newest state in up to two packets: a draft while the user drags, and the full detail later. Shows nothing
/// while the page has not drawn the last packet yet.
void Grower::show() {
  const std::optional<NextView> next = next_view();
  if (!next) return;
  const GrownPlant& grown = *next->sight.grown;
  if (next->forgets) {
    packets_.forget();
    pictures_.clear();
  }
  bool is_sent = false;
  run(grown.request.hash, Stopped::meshing, [&](JobMessages& messages) {
    std::string packet = packet_of(*next, messages);
    const Value::Object message = grown_message(grown, messages);
    const std::lock_guard lock(mutex_);
    if (is_closed_ || is_other_) return;
    awaited_ = packets_.number();
    outbox_->send_text(write_json_line(message));
    outbox_->send_packet(std::move(packet));
    is_sent = true;
  });
  const std::lock_guard lock(mutex_);
  fits_ = fits_ || (next->fits && !is_sent);
}

/// Returns what the page must show now, and marks it as shown. Returns nothing if the page shows it already, or must
/// wait. Schedules the full detail if this is a draft.
std::optional<Grower::NextView> Grower::next_view() {
  const std::lock_guard lock(mutex_);
  if (awaited_ != 0 || grown_ == nullptr || is_closed_) return std::nullopt;
  // While a newer state can still be continued, the view does not change.
  if (stopped_ == Stopped::growth && shown_.grown == grown_ && shown_.parts == parts_) return std::nullopt;
  // A slow page sees a draft late. The time until full detail then starts when it has shown the draft.
  const Clock::time_point still = std::max(last_input_, last_seen_) + host_.still_after;
  // A single edit is shown in full at once. So is a drag that moves nothing, for example of a colour.
  const bool moves = grown_->request.is_dragged && !(shown_.grown != nullptr && !shown_.is_draft &&
                                                     have_same_shape(shown_.grown->plant, grown_->plant));
  Sight sight = {.grown = grown_, .parts = parts_, .is_draft = moves && Clock::now() < still};
  const bool waits = sight.is_draft;
  if (forgets_ && is_large(*grown_, parts_)) sight.is_draft = true;
  if (waits) {
    host_.growth.post_at(still, [self = shared_from_this()] {
      const std::lock_guard later(self->mutex_);
      self->schedule();
    });
  }
  if (is_shown(sight)) return std::nullopt;
  shown_ = sight;  // set even if the packet fails, so that it is tried once
  return NextView{std::move(sight), std::exchange(fits_, false), std::exchange(forgets_, false)};
}

/// Returns the packet of the changes from the last view to this one. Makes meshes if surfaces are shown.
std::string Grower::packet_of(const NextView& view, JobMessages& messages) {
  const Sight& sight = view.sight;
  const GrownPlant& grown = *sight.grown;
  double share = 1;
  std::shared_ptr<const MeshScene> meshes;
  std::uint64_t all = grown.about_triangles;
  if (sight.parts.surface) {
    make_meshes(sight, messages.progress());
    all = meshes_->triangles;
    if (!meshes_->is_whole) share = share_of(sight.budget(), all);
    meshes = with_shown_pictures(grown);
  }
  const PlantTotals totals = totals_of(grown.plant);
  return packets_.next({.meshes = meshes.get(),
                        .skeletons = sight.parts.skeleton ? &grown.plant : nullptr,
                        .max_segments = static_cast<std::size_t>(sight.budget()),
                        .obstacles = sight.parts.surface ? &obstacles_of(grown, messages.progress()) : nullptr,
                        .scene = &grown.document->scene},
                       {.hash = grown.request.hash,
                        .is_draft = sight.is_draft,
                        .fits = view.fits,
                        .share = share,
                        .all = {.triangles = all, .instances = totals.organs + totals.stems, .nodes = totals.nodes}},
                       messages.progress());
}

/// Returns the message that precedes a packet: the counts of the plant, the times of all stages, and what was reused.
Value::Object Grower::grown_message(const GrownPlant& grown, JobMessages& messages) {
  std::vector<std::pair<std::string, double>> stages = std::exchange(stages_, {});
  for (auto& stage : messages.stages()) stages.push_back(std::move(stage));
  Value::List times;
  for (const auto& [name, milliseconds] : stages) {
    times.push_back(Value::Object{{"name", name}, {"ms", std::round(milliseconds * 10) / 10}});
  }
  Value::Object message{{"is", "grown"}, {"hash", grown.request.hash}, {"dragged", grown.request.is_dragged}};
  message.emplace_back("stages", std::move(times));
  message.emplace_back("reuse", reuse_value(std::exchange(grown_reuse_, {}), std::exchange(clothed_reuse_, {})));
  for (auto& member : counts_value(grown)) message.push_back(std::move(member));
  return message;
}

Value::Object Grower::counts_value(const GrownPlant& grown) const {
  const PlantTotals totals = totals_of(grown.plant);
  Value::Object counts{{"nodes", number_value(totals.nodes)}};
  const MeshScene* const whole = whole_meshes(grown);
  counts.emplace_back("instances", number_value(whole != nullptr ? whole->instance_count() : totals.organs));
  counts.emplace_back("triangles", whole != nullptr ? number_value(whole->triangle_count()) : Value());
  Value::Object placed;
  for (std::size_t k = 0; k < grown.placed.size(); ++k) {
    placed.emplace_back(grown.document->graph.components[k].id, number_value(grown.placed[k]));
  }
  counts.emplace_back("placed", grown.placed.empty() ? Value() : Value(std::move(placed)));
  counts.emplace_back("components", whole != nullptr ? component_counts(*whole) : Value());
  counts.emplace_back("step", grown.traces.shown_step());
  counts.emplace_back("steps", grown.view.request.any() ? Value(grown.traces.last_step) : Value());
  Value::Object growing;
  for (const ComponentSteps& one : grown.traces.steps) growing.emplace_back(one.component, one.last_step);
  counts.emplace_back("growing", grown.view.request.any() ? Value(std::move(growing)) : Value());
  return counts;
}

/// Returns the meshes of obstacles. They are made once for each list of bodies, which equal documents share.
const MeshScene& Grower::obstacles_of(const GrownPlant& grown, Progress& progress) {
  const Obstacles& obstacles = grown.document->scene.obstacles;
  if (&obstacles.bodies() != &obstacles_.bodies()) {
    obstacle_meshes_ = obstacle_meshes(obstacles, progress);
    obstacles_ = obstacles;
  }
  return obstacle_meshes_;
}

/// Returns the last meshes if they show the whole plant, else null.
const MeshScene* Grower::whole_meshes(const GrownPlant& grown) const {
  return meshes_of_.get() == &grown && meshes_->is_whole ? &meshes_->scene : nullptr;
}

/// Makes the meshes for a packet, unless the last meshes already show the whole plant.
void Grower::make_meshes(const Sight& sight, Progress& progress) {
  if (whole_meshes(*sight.grown) != nullptr && meshes_->triangles <= sight.budget()) return;
  GrowthCache& cache = mesh_caches_[sight.is_draft ? 1 : 0];
  meshes_ = std::make_shared<const ViewMeshes>(
      view_meshes(*sight.grown->document, sight.grown->plant, {.triangles = sight.budget()}, progress, &cache));
  meshes_of_ = sight.grown;
  clothed_reuse_ = reuse_of(cache);
}

/// Returns the last meshes. Pictures that the page has replace pictures that look alike.
std::shared_ptr<const MeshScene> Grower::with_shown_pictures(const GrownPlant& grown) {
  std::shared_ptr<const MeshScene> scene(meshes_, &meshes_->scene);
  std::vector<Material> materials = scene->materials;
  if (!pictures_.keep(grown.document->graph, materials)) return scene;
  return std::make_shared<const MeshScene>(MeshScene{std::move(materials), scene->meshes});
}

}  // namespace meristem::studio
