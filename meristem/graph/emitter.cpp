// SPDX-License-Identifier: Apache-2.0
// Collects the geometry, stems and sites of instances. Each call stores a part in the frame and with the keys of the
// present instance. Shared counters are updated in groups, since an atomic addition per site would slow threads down. A
// trimmed or growing stem keeps its whole skeleton, so that children keep their positions and random numbers.
#include "meristem/graph/emitter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "meristem/base/fingerprint.h"
#include "meristem/base/hash.h"
#include "meristem/base/math.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/emitter_context.h"
#include "meristem/graph/omission.h"
#include "meristem/graph/thickness_left.h"
#include "meristem/graph/vanished.h"
#include "meristem/plant/operation_record.h"

namespace meristem {

namespace {

// Number of sites that are counted in one addition; an atomic addition for each would slow threads down
constexpr std::uint64_t kCountedTogether = 1024;

// Stands for the number of siblings of a site that was cut off with a part of the stem
constexpr std::uint32_t kCutOff = 0;

bool is_finite(const Frame& frame) {
  const auto finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  return finite(frame.origin) && finite(frame.axes[0]) && finite(frame.axes[1]) && finite(frame.axes[2]);
}

/// Throws an InputError because a limit was exceeded. `message` contains the limit, but not the count, which depends on
/// other threads.
[[noreturn]] void throw_past(std::string message, std::uint64_t limit, std::string_view limit_name, std::string path) {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = fmt::format("at most {} (limits.{})", limit, limit_name),
                              .path = std::move(path)});
}

/// Moves a skeleton in world space along with its frame. Returns the factor of its size.
float move_geometry(Skeleton& skeleton, const Frame& from, const Frame& to) {
  const Mat3 axes = to.axes * glm::inverse(from.axes);
  for (Vec3& position : skeleton.position) position = to.origin + axes * (position - from.origin);
  const auto scale = static_cast<float>(math::pow(std::abs(glm::determinant(axes)), 1.0 / 3));
  for (float& radius : skeleton.radius) radius *= scale;
  const Frame moved{.axes = axes, .origin = to.origin - axes * from.origin};
  for (OperationRecord& record : skeleton.operations) move_record(record, moved, scale);
  return scale;
}

}  // namespace

std::uint64_t shape_key(std::initializer_list<double> numbers) {
  return hash64(std::string_view(reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(double)));
}

const Scene& Emitter::scene() const { return context_->scene; }
const Surroundings& Emitter::surroundings() const {
  static const Surroundings nothing;
  return surroundings_ != nullptr ? *surroundings_ : nothing;
}
const Directions& Emitter::directions() const {
  const bool is_said = surroundings_ != nullptr && surroundings_->directions != nullptr;
  return is_said ? *surroundings_->directions : context_->directions;
}
const SizeLimits& Emitter::limits() const { return context_->limits; }
const std::string& Emitter::component() const { return context_->prototype.id; }
Progress& Emitter::progress() const { return *context_->progress; }
double Emitter::time() const { return site_.clock.at(context_->time); }
bool Emitter::varies(std::size_t offset) const {
  return std::ranges::any_of(context_->prototype.varyings, [&](const Varying& varying) {
    return (varying.way.empty() ? varying.offset : varying.way[0].offset) == offset;
  });
}

RandomKey Emitter::component_key() const { return context_->key; }

void Emitter::instance(const ComponentBase& base, const Site& site, std::size_t index,
                       FunctionRef<void(const Site&)> expand) {
  const bool omitted = is_left_out(base, site, context_->time);
  if (omitted && !base.omit_keeps_children) return;
  instance_ = index;
  visible_ = !omitted && !base.hidden;
  begin_instance(base, site);
  if (has_vanished(site_.frame)) return;
  expand(site_);
  end_instance();
}

void Emitter::begin_instance(const ComponentBase& base, const Site& site) {
  site_ = site;
  surroundings_ = site.surroundings;
  site_.frame = instance_frame(base, site.frame, context_->prototype.type->tropism, directions());
  const Frame place = base.place.frame();
  is_placed_ = place.axes != Mat3(1) || place.origin != Vec3(0);
  geometry_frame_ = site_.frame * place;
  if (!is_finite(site_.frame) || !is_finite(geometry_frame_)) {
    throw InputError(
        Diagnostic{.message = fmt::format("the frame of instance {} of {} is not finite", site.i, site.n),
                   .expected = "smaller scales and shifts, in this component or in those that it stands on",
                   .path = "components." + component()});
  }
  tint_ = context_->tinting.tint(base, site.key.child("colour"));
  base_ = &base;
  parent_section_ = std::exchange(site_.section, 0);
  section_ = 0;
  has_child_sites_ = false;
  stems_of_instance_ = 0;
  organs_of_instance_ = 0;
  stands_as_grown_ = false;
  expected_ = 0;
  parts_ = nullptr;
  site_.part = 1;
  first_child_ = child_sites.size();
  first_branch_ = branch_sites.size();
  first_named_ = named_sites.size();
  const ComponentTraits& traits = *context_->prototype.type;
  if (is_individual() && !traits.bears_plants && !traits.speaks_of_space) {
    founded.push_back({site_.individual, site_.frame.origin, deformation_at(site_), site_.row});
  }
}

/// Completes the sites for children, removes sites that no link uses, and numbers the others.
void Emitter::end_instance() {
  if (!has_child_sites_) child_site(Frame{});
  if (context_->wants_branch_sites && !context_->prototype.type->makes_stems && branch_sites.size() == first_branch_) {
    child_sites.read(first_child_, child_sites.size(), [&](const Site& site) { branch_sites.add(site); });
  }
  if (!context_->wants_child_sites) child_sites.truncate(first_child_);
  if (section_ != 0) {
    child_sites.change(first_child_, [&](Site& site) {
      site.section = section_;
      site.surface = site_.surface;
      return true;
    });
  }
  if (parts_ != nullptr) keyed_parts_ = keys_of_parts();
  // In components with ribs the count is for the ribs, and there is one child at the tip.
  finish_sites(child_sites, first_child_, parts_ != nullptr && !context_->prototype.type->has_ribs);
  finish_sites(branch_sites, first_branch_, parts_ != nullptr);
  number_named_sites();
  for (SiteList* const sites : {&child_sites, &branch_sites, &named_sites}) sites->pack_chunks();
  if (uncounted_ >= kCountedTogether / 8) count_sites();
}

/// Numbers the instance's sites and removes the sites that were cut off.
void Emitter::finish_sites(SiteList& sites, std::size_t first, bool has_parts) {
  const auto count = static_cast<std::uint32_t>(sites.size() - first);
  std::uint32_t k = 0;
  sites.change(first, [&](Site& site) {
    site.i = k++;
    if (site.n == kCutOff) return false;
    site.n = count;
    if (has_parts) tell_part(site);
    return true;
  });
}

/// Returns the keys of the count of parts that the instance has announced, or null if it has no keys.
const Varying* Emitter::keys_of_parts() const {
  const auto offset = reinterpret_cast<const std::byte*>(parts_) - reinterpret_cast<const std::byte*>(base_);
  const auto is_its = [&](const Varying& varying) {
    return varying.way.empty() && varying.offset == static_cast<std::size_t>(offset) && varying.keys != nullptr;
  };
  const auto keyed = std::ranges::find_if(context_->prototype.varyings, is_its);
  return keyed == context_->prototype.varyings.end() || keyed->expression ? nullptr : &*keyed;
}

/// Sets when the part at a site of a count appears, and the size of the last part.
void Emitter::tell_part(Site& site) const {
  const auto last = static_cast<float>(parts_->last());
  site.part = last;
  if (site.i + 1 == site.n && last < 1) site.frame.axes *= last;
  if (keyed_parts_ == nullptr) return;
  const double appeared = keyed_parts_->keys->first.since(site.i + 1.0, time());
  site.appeared = std::max(site_.appeared, appeared);
}

/// Numbers the named sites and removes the sites that were cut off. Each name is counted separately.
void Emitter::number_named_sites() {
  if (named_sites.size() == first_named_) return;
  std::unordered_map<std::uint32_t, std::uint32_t> count, number;
  for (std::size_t k = first_named_; k < site_names.size(); ++k) ++count[site_names[k]];
  std::size_t kept = first_named_, next = first_named_;
  named_sites.change(first_named_, [&](Site& site) {
    const std::uint32_t name = site_names[next++];
    site.i = number[name]++;
    if (site.n == kCutOff) return false;
    site.n = count[name];
    site_names[kept++] = name;
    return true;
  });
  site_names.resize(kept);
}

Emitted Emitter::take() {
  organs.pack();
  child_sites.pack();
  branch_sites.pack();
  named_sites.pack();
  return std::move(static_cast<Emitted&>(*this));
}

void Emitter::organ(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint) {
  add_organ(local, key, false, make, tint_ * tint);
}

void Emitter::blade(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint) {
  add_organ(local, key, true, make, context_->prototype.type->blades.has_document_colours ? tint_ * tint : tint);
}

void Emitter::add_organ(const Frame& local, std::uint64_t key, bool is_blade, FunctionRef<Mesh()> make, Vec3 tint) {
  if (!visible_) return;
  const auto [found, is_new] = prototype_by_key_.try_emplace(key, static_cast<std::uint32_t>(prototypes.size()));
  if (is_new) prototypes.push_back({key, shared_mesh(key, make), is_blade});
  note_deformation();
  organs.add({geometry_frame_ * local, found->second, tint, site_.birth, number_of_individual(), next_name()});
}

/// Records the deformation of the following organs if it differs from the previous one.
void Emitter::note_deformation() {
  const std::shared_ptr<const Deformation>& own = deformation_at(site_);
  const bool is_other = deformed.empty() ? own != nullptr : deformed.back().deformation != own;
  if (is_other) deformed.push_back({organs.size(), own});
}

/// Returns the number, within the block, of the plant to which the instance belongs.
std::uint32_t Emitter::number_of_individual() {
  if (!individuals.empty() && individuals.back() == site_.individual) {
    return static_cast<std::uint32_t>(individuals.size() - 1);
  }
  const auto [found, is_new] =
      individual_by_id_.try_emplace(site_.individual, static_cast<std::uint32_t>(individuals.size()));
  if (is_new) individuals.push_back(site_.individual);
  return found->second;
}

void Emitter::plant(const Frame& local, std::shared_ptr<const PlantSource> source, PlantRequest request) {
  request.time = time();
  plants.push_back({geometry_frame_ * local, std::move(source), std::move(request), site_.birth, visible_,
                    deformation_at(site_), site_.row, next_name()});
}

void Emitter::give(std::span<const double> numbers, bool to_named) {
  if (!to_named && child_sites.size() == first_child_) return;  // no link uses it
  Site& site = to_named ? named_sites.back() : child_sites.back();
  const std::vector<std::uint32_t>& slots = context_->prototype.given_slots;
  if (slots.empty()) return;  // the graph has no names for the numbers
  assert(numbers.size() == slots.size());
  SiteValues values;
  if (site_.values != nullptr) values = *site_.values;
  values.names = context_->site_names_hash;
  values.numbers.resize(context_->site_names, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < slots.size(); ++k) values.numbers[slots[k]] = numbers[k];
  site.values = std::make_shared<const SiteValues>(std::move(values));
}

void Emitter::from_row(std::uint32_t row, bool is_named) {
  if (!is_named && child_sites.size() == first_child_) return;  // no link uses it
  Site& site = is_named ? named_sites.back() : child_sites.back();
  site.row = row;
}

void Emitter::surround(Surroundings said) {
  Fingerprint hash;
  said.hash = 0;
  const Prototype& prototype = context_->prototype;
  if (const std::optional<std::uint64_t> site = hash_of(site_); site && prototype.fingerprint) {
    hash.add(*prototype.fingerprint).add(*site).add(prototype.depends_on_time ? time() : 0);
    said.hash = std::max<std::uint64_t>(1, hash.hash());
  }
  site_.surroundings = std::make_shared<const Surroundings>(std::move(said));
}

void Emitter::section(const Frame& local, std::uint64_t key, bool is_capped, FunctionRef<LoftSection()> make) {
  if (!visible_) return;
  std::shared_ptr<const SectionOutline>& outline = outline_by_key_[key];
  if (outline == nullptr) {
    SectionOutline made{.key = key, .section = make()};
    for (const Vec3 point : made.section.points) made.extent = std::max(made.extent, glm::length(point));
    outline = std::make_shared<const SectionOutline>(std::move(made));
  }
  // One random colour holds for a whole surface.
  const bool is_first = parent_section_ == 0;
  if (is_first) site_.surface = site_.key;
  section_ = std::max<std::uint64_t>(1, site_.key.child("section").bits());
  sections.push_back({.outline = outline,
                      .frame = geometry_frame_ * local,
                      .is_capped = is_capped,
                      .id = section_,
                      .parent = parent_section_,
                      .tint = is_first ? tint_ : context_->tinting.tint(*base_, site_.surface.child("colour")),
                      .birth = site_.birth,
                      .individual = site_.individual,
                      .deformation = deformation_at(site_)});
}

std::shared_ptr<const Mesh> Emitter::shared_mesh(std::uint64_t key, FunctionRef<Mesh()> make) {
  std::shared_ptr<const Mesh> mesh = context_->meshes.find(key);
  if (mesh == nullptr) {
    Mesh made = make();
    lay_picture(context_->prototype.base().texture, made);
    mesh = context_->meshes.keep(key, std::make_shared<const Mesh>(std::move(made)));
  }
  const std::uint64_t limit = context_->limits.mesh_bytes;
  if (context_->mesh_bytes + context_->meshes.bytes() <= limit) return mesh;
  throw_past(fmt::format("the shapes of '{}' take more than {} bytes", component(), limit), limit, "mesh_bytes",
             "components." + component());
}

bool Emitter::grows_in_time() const {
  return context_->prototype.type->grows_in_time && context_->animation != nullptr &&
         context_->animation->steps_per_second && !context_->growth_step;
}

double Emitter::grown_to(double last) {
  growth_steps = std::max(growth_steps, static_cast<int>(std::ceil(last)));
  if (context_->growth_step) return std::clamp<double>(*context_->growth_step, 0, last);
  return grows_in_time() ? std::clamp(time() * *animation().steps_per_second, 0.0, last) : last;
}

const Animation& Emitter::animation() const { return *context_->animation; }

/// Returns the stem trimmed by the surroundings and the time, or null if it stays whole. A growing stem is cut at its
/// present size, even if it would otherwise be fitted.
std::shared_ptr<const TrimmedStem> Emitter::trimmed_stem(Skeleton skeleton, TrimMode trim, const GrowingStem* growing,
                                                         double pipe_exponent) const {
  const Crown* const body = surroundings().trim.get();
  const bool is_cut = body != nullptr && trim != TrimMode::none;
  const auto reach = [&](Vec3 from, Vec3 to) { return body->reach(from, to); };
  if (growing == nullptr) {
    if (!is_cut) return nullptr;
    TrimmedSkeleton left = trim_skeleton(skeleton, reach, trim);
    if (left.is_whole) return nullptr;
    return std::make_shared<const TrimmedStem>(std::move(skeleton), std::move(left), trim);
  }
  TrimmedSkeleton standing = standing_at(skeleton, growing->spans, growing->step, pipe_exponent);
  if (is_cut) {
    TrimmedSkeleton left = trim_skeleton(standing.skeleton, reach, TrimMode::cut);
    if (!left.is_whole) standing = one_after_other(std::move(standing), std::move(left));
  }
  return std::make_shared<const TrimmedStem>(std::move(skeleton), std::move(standing), TrimMode::cut);
}

namespace {

GrowingStem growing_stem(const Skeleton& whole, double step, double steps_per_second, double unfold,
                         double pipe_exponent) {
  GrowingStem growing{GrowthSpans(whole), step, steps_per_second, unfold, pipe_exponent};
  growing.step_of_node = steps_of_nodes(whole, growing.spans, step);
  return growing;
}

}  // namespace

/// Counts the nodes, takes the stem back to its step of growth, and trims it by the body of the surroundings. Stores
/// the rest with the whole skeleton, so that later calls can use the nodes of the whole. The stem gets a key of its
/// own, from its number in the instance. If the instance is a plant and the stem has several roots, each root becomes a
/// plant. If `place` moves the instance, stores a moved copy of the skeleton, which is the visible one.
void Emitter::stem(Skeleton skeleton, const SurfaceOptions& surface, const BranchPlacement* branching, TrimMode trim,
                   double pipe_exponent) {
  count_nodes(skeleton.node_count());
  std::shared_ptr<const GrowingStem> growing;
  if (grows_in_time() && !stands_as_grown_) {
    const double steps = *animation().steps_per_second;
    growing = std::make_shared<const GrowingStem>(
        growing_stem(skeleton, time() * steps, steps, animation().unfold * steps, pipe_exponent));
  }
  std::shared_ptr<const TrimmedStem> trimmed = trimmed_stem(skeleton, trim, growing.get(), pipe_exponent);
  if (trimmed != nullptr) skeleton = trimmed->left();
  if (branching == nullptr) {
    branching_ = nullptr;
  } else if (branching_ == nullptr || !(*branching_ == *branching)) {
    branching_ = std::make_shared<const BranchPlacement>(*branching);
  }
  EmittedStem& stem =
      stems.emplace_back(EmittedStem{std::move(skeleton), shared_surface(surface), branching_, site_, visible_, tint_});
  stem.trimmed = std::move(trimmed);
  stem.growing = std::move(growing);
  stem.site.key = site_.key.child("stem").child(stems_of_instance_++);
  if (is_individual()) tell_roots_apart(stem);
  if (is_placed_ && visible_) {
    auto moved = std::make_unique<Skeleton>(stem.skeleton);
    stem.moved_scale = move_geometry(*moved, site_.frame, geometry_frame_);
    stem.moved = std::move(moved);
  }
}

/// Returns a surface with its crown in world space. Stems with equal surfaces share it.
std::shared_ptr<const SurfaceOptions> Emitter::shared_surface(SurfaceOptions surface) {
  if (surface.crown) surface.crown->scale(glm::length(site_.frame.heading()));
  if (surface_ == nullptr || !(*surface_ == surface)) surface_ = std::make_shared<const SurfaceOptions>(surface);
  return surface_;
}

/// Makes each root of a plant's first stem a plant of its own. Parts that stand on no root belong to the first one.
void Emitter::tell_roots_apart(EmittedStem& stem) {
  const Skeleton& skeleton = stem.skeleton;
  if (stems_of_instance_ > 1 || std::count(skeleton.parent.begin(), skeleton.parent.end(), kNoNode) < 2) return;
  std::uint32_t roots = 0;
  stem.root_of_node.resize(skeleton.node_count());
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!skeleton.is_root(node)) {
      stem.root_of_node[node] = stem.root_of_node[skeleton.parent[node]];
      continue;
    }
    const Vec3 foot = skeleton.position[node];
    if (roots == 0) {
      founded.back().foot = foot;
    } else {
      founded.push_back({stem.individual_of_root(roots), foot, stem.deformation(), site_.row});
    }
    stem.root_of_node[node] = roots++;
  }
}

void Emitter::unseen_stem(Skeleton skeleton, TrimMode trim) {
  const bool was_visible = std::exchange(visible_, false);
  stem(std::move(skeleton), {}, nullptr, trim);
  visible_ = was_visible;
}

/// Returns the position, on the rest of the last emitted stem, of a position of the whole stem. Returns nothing if it
/// was trimmed away.
std::optional<StemPosition> Emitter::left_of(StemPosition whole) const {
  const auto& trimmed = stems.back().trimmed;
  return trimmed == nullptr ? std::optional(whole) : trimmed->left_of(whole);
}

std::optional<Frame> Emitter::on_stem_left(NodeIndex node, const Frame& frame) const {
  if (node == kNoNode || stems.back().trimmed == nullptr) return frame;
  const std::optional<StemPosition> left = left_of({node, 1});
  if (!left) return std::nullopt;
  Site moved{.frame = stems.back().trimmed->moved(frame, {node, 1}, *left)};
  if (stems.back().growing != nullptr) stems.back().trimmed->settle(*stems.back().growing, {node, 1}, *left, moved);
  return moved.frame;
}

float Emitter::length_left() const {
  const auto& trimmed = stems.back().trimmed;
  if (trimmed == nullptr) return 1;
  if (trimmed->left().node_count() == 0) return 0;
  return arcs_along_axes(trimmed->left()).back() / arcs_along_axes(trimmed->whole()).back();
}

void Emitter::child_site(const Frame& local, float length, float radius) {
  const float scale = glm::length(site_.frame.heading());
  offer_child(site_.frame * local, scale * length, scale * radius);
}

void Emitter::tip_site(const Frame& frame, float length, float radius) {
  const auto& trimmed = stems.back().trimmed;
  const std::size_t before = child_sites.size();
  offer_child(frame, length_left() * length, radius);
  if (trimmed == nullptr || child_sites.size() == before) return;
  put_on_stem({static_cast<NodeIndex>(trimmed->whole().node_count() - 1), 1}, child_sites.back());
}

void Emitter::offer_child(const Frame& frame, float length, float radius) {
  has_child_sites_ = true;
  const bool for_branches = context_->wants_branch_sites && !context_->prototype.type->makes_stems;
  if (context_->wants_child_sites || for_branches) add_site(child_sites, frame, 1, length, radius);
}

void Emitter::branch_site(const Frame& local, float u, float length, float radius) {
  const float scale = glm::length(site_.frame.heading());
  if (context_->wants_branch_sites) add_site(branch_sites, site_.frame * local, u, scale * length, scale * radius);
}

void Emitter::branch_site_on_stem(const Frame& frame, float u, float length, float radius, NodeIndex node,
                                  float along) {
  if (!context_->wants_branch_sites) return;
  add_site(branch_sites, frame, u, length, radius);
  put_on_stem({node, along}, branch_sites.back());
}

void Emitter::named_site(std::uint32_t name, const Frame& frame, float length, float radius, NodeIndex node) {
  if (++uncounted_ == kCountedTogether) count_sites();
  site_names.push_back(name);
  Site& site = named_sites.add(site_);
  site.frame = frame;
  site.u = 1;
  site.length = length;
  site.radius = radius;
  if (node == kNoNode) return;
  put_on_stem({node, 1}, site);
  if (site.n != kCutOff) site.order = stems.back().skeleton.order[site.node];
}

void Emitter::born(double step) {
  if (!grows_in_time() || !stands_as_grown_) return;
  Site& site = named_sites.back();
  site.birth = static_cast<float>(step);
  site.appeared = step / *animation().steps_per_second;
}

/// Moves a site at a position of the whole last emitted stem to the rest of the stem. Marks the site as cut off if the
/// position is gone.
void Emitter::put_on_stem(StemPosition whole, Site& site) const {
  const EmittedStem& stem = stems.back();
  const std::optional<StemPosition> left = left_of(whole);
  if (!left) {
    site.n = kCutOff;
    return;
  }
  if (stem.trimmed != nullptr) {
    site.frame = stem.trimmed->moved(site.frame, whole, *left);
    site.radius *= thickness_left(*stem.trimmed, whole, *left);
  }
  if (stem.growing != nullptr) stem.trimmed->settle(*stem.growing, whole, *left, site);
  site.stem = stem.id();
  site.node = left->node;
  site.along = left->along;
  site.individual = stem.individual_at(left->node);
}

void Emitter::add_site(SiteList& sites, const Frame& frame, float u, float length, float radius) {
  if (++uncounted_ == kCountedTogether) count_sites();
  Site& site = sites.add(site_);
  site.frame = frame;
  site.u = u;
  site.length = length;
  site.radius = radius;
  if (stems_of_instance_ == 0) return;  // the site then keeps the stem on which the instance stands
  const Skeleton& skeleton = stems.back().skeleton;
  site.stem = stems.back().id();
  site.node = static_cast<NodeIndex>(skeleton.node_count() - 1);
  site.along = 1;
  if (skeleton.node_count() > 0) site.individual = stems.back().individual_at(site.node);
}

std::vector<double> Emitter::per_child(const PerChild& number, std::uint32_t count) const {
  if (!number.varying || count == 0) return std::vector<double>(count, number.plain);
  std::vector<Site> children(count, site_);
  const RandomKey key = site_.key.child("children");
  for (std::uint32_t k = 0; k < count; ++k) {
    children[k].i = k;
    children[k].n = count;
    children[k].key = key.child(k);
    if (parts_ != nullptr) children[k].part = static_cast<float>(parts_->last());
  }
  const VaryingValues evaluated(std::span(&*number.varying, 1), children, context_->time);
  std::vector<double> values(count);
  for (std::uint32_t k = 0; k < count; ++k) values[k] = evaluated.value(0, k);
  return values;
}

void Emitter::expect_children(std::uint64_t count) {
  expected_ = count;
  const std::uint64_t limit = context_->limits.instances;
  if (context_->instances.load(std::memory_order_relaxed) + count > limit) throw_too_many_children();
}

std::uint32_t Emitter::expect_parts(const PartCount& count) {
  parts_ = &count;
  expect_children(count.parts());
  return count.parts();
}

bool Emitter::begin_clock(double delay, double speed) {
  const double start = site_.appeared + delay;
  InstanceClock own{.start = site_.clock.when(start), .speed = site_.clock.speed * speed, .is_local = true};
  const bool has_started = time() >= start;
  site_.clock = own;
  site_.appeared = 0;
  return has_started;
}

void Emitter::count_sites() {
  const std::uint64_t limit = context_->limits.instances;
  const std::uint64_t before = context_->instances.fetch_add(uncounted_, std::memory_order_relaxed);
  if (before + uncounted_ > limit) throw_too_many_children();
  uncounted_ = 0;
}

void Emitter::throw_too_many_children() const {
  const std::uint64_t limit = context_->limits.instances;
  // If instances differ, threads decide which of them exceeds the limit. The message therefore names all of them.
  const bool is_one = context_->together == 1;
  std::string who = fmt::format("'{}'", component());
  if (!is_one) who = fmt::format("{} instances of {}", context_->together, who);
  if (context_->prototype.varyings.empty() && expected_ > 0)
    who += fmt::format(" with {} children{}", expected_, is_one ? "" : " each");
  throw_past(fmt::format("{} {} sites to more than {} instances", who, is_one ? "offers" : "offer", limit), limit,
             "instances", context_->multiplier);
}

void Emitter::count_nodes(std::uint64_t more) {
  const std::uint64_t limit = context_->limits.nodes;
  if (context_->nodes.fetch_add(more, std::memory_order_relaxed) + more <= limit) return;
  throw_past(fmt::format("with '{}' there are more than {} nodes", component(), limit), limit, "nodes",
             "components." + component());
}

Skeleton Emitter::take_grown() {
  assert(instance_ < grown_.size());
  return std::move(grown_[instance_]);
}

}  // namespace meristem
