// SPDX-License-Identifier: Apache-2.0
// Stores the sites for the children of instances. When an instance ends, its sites are numbered, and sites that no link
// uses are removed. The limit on sites is shared by all threads. Sites are counted there in groups, since an atomic
// addition per site would slow threads down.
#include "meristem/graph/site_sink.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <unordered_map>
#include <utility>

#include "meristem/base/fingerprint.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/present_instance.h"
#include "meristem/graph/thickness_left.h"

namespace meristem {

namespace {

constexpr std::uint64_t kCountedTogether = 1024;  // sites per addition to the shared count

constexpr std::uint32_t kCutOff = 0;  // number of siblings of a site that was cut off with a part of the stem

}  // namespace

void SiteSink::begin_instance() {
  const Emitted& emitted = present_->emitted;
  has_child_sites_ = false;
  expected_ = 0;
  parts_.reset();
  first_child_ = emitted.child_sites.size();
  first_branch_ = emitted.branch_sites.size();
  first_named_ = emitted.named_sites.size();
}

/// Completes the sites for children, removes sites that no link uses, and numbers the others.
void SiteSink::end_instance() {
  Emitted& emitted = present_->emitted;
  const EmitterContext& context = *present_->context;
  const ComponentTraits& traits = *present_->prototype().type;
  SiteList &children = emitted.child_sites, &branches = emitted.branch_sites;
  if (!has_child_sites_) add(Frame{});
  if (context.wants_branch_sites && !traits.makes_stems && branches.size() == first_branch_) {
    children.read(first_child_, children.size(), [&](const Site& site) { branches.add(site); });
  }
  if (!context.wants_child_sites) children.truncate(first_child_);
  if (present_->section != 0) {
    children.change(first_child_, [&](Site& site) {
      site.section = present_->section;
      site.surface = present_->site.surface;
      return true;
    });
  }
  if (parts_) keyed_parts_ = keys_of_parts();
  // In components with ribs the count is for the ribs, and there is one child at the tip.
  finish(children, first_child_, parts_.has_value() && !traits.has_ribs);
  finish(branches, first_branch_, parts_.has_value());
  number_named();
  for (SiteList* const sites : {&children, &branches, &emitted.named_sites}) sites->pack_chunks();
  if (uncounted_ >= kCountedTogether / 8) count_sites();
}

/// Numbers the instance's sites and removes the sites that were cut off.
void SiteSink::finish(SiteList& sites, std::size_t first, bool has_parts) {
  const auto count = static_cast<std::uint32_t>(sites.size() - first);
  std::uint32_t k = 0;
  sites.change(first, [&](Site& site) {
    site.i = k++;
    if (site.n == kCutOff) return false;
    site.n = count;
    if (has_parts) set_part(site);
    return true;
  });
}

/// Returns the keys of the count of parts that the instance has announced, or null if it has no keys.
const Varying* SiteSink::keys_of_parts() const {
  const std::vector<Varying>& varyings = present_->prototype().varyings;
  const auto keyed = std::ranges::find_if(varyings, [&](const Varying& varying) {
    return varying.way.empty() && varying.offset == parts_->offset() && varying.keys != nullptr;
  });
  return keyed == varyings.end() || keyed->expression ? nullptr : &*keyed;
}

/// Sets when the part at a site of a count appears, and the size of the last part.
void SiteSink::set_part(Site& site) const {
  const auto last = static_cast<float>(parts_->value().last());
  site.part = last;
  if (site.i + 1 == site.n && last < 1) site.frame.axes *= last;
  if (keyed_parts_ == nullptr) return;
  const double appeared = keyed_parts_->keys->first.since(site.i + 1.0, present_->time());
  site.appeared = std::max(present_->site.appeared, appeared);
}

/// Numbers the named sites and removes the sites that were cut off. Each name is counted separately.
void SiteSink::number_named() {
  SiteList& sites = present_->emitted.named_sites;
  std::vector<std::uint32_t>& names = present_->emitted.site_names;
  if (sites.size() == first_named_) return;
  std::unordered_map<std::uint32_t, std::uint32_t> count, number;
  for (std::size_t k = first_named_; k < names.size(); ++k) ++count[names[k]];
  std::size_t kept = first_named_, next = first_named_;
  sites.change(first_named_, [&](Site& site) {
    const std::uint32_t name = names[next++];
    site.i = number[name]++;
    if (site.n == kCutOff) return false;
    site.n = count[name];
    names[kept++] = name;
    return true;
  });
  names.resize(kept);
}

void SiteSink::add(const Frame& local, float length, float radius) {
  const float scale = present_->scale();
  add_child(present_->site.frame * local, scale * length, scale * radius);
}

void SiteSink::add_at_tip(const Frame& frame, float length, float radius) {
  const EmittedStem& stem = present_->emitted.stems.back();
  SiteList& sites = present_->emitted.child_sites;
  const std::size_t before = sites.size();
  add_child(frame, stem.length_left() * length, radius);
  if (stem.trimmed == nullptr || sites.size() == before) return;
  put_on_stem({static_cast<NodeIndex>(stem.trimmed->whole().node_count() - 1), 1}, sites.back());
}

void SiteSink::add_child(const Frame& frame, float length, float radius) {
  const EmitterContext& context = *present_->context;
  has_child_sites_ = true;
  const bool for_branches = context.wants_branch_sites && !present_->prototype().type->makes_stems;
  if (context.wants_child_sites || for_branches) add_site(present_->emitted.child_sites, frame, 1, length, radius);
}

void SiteSink::add_for_branches(const Frame& local, float u, float length, float radius) {
  if (!present_->context->wants_branch_sites) return;
  const float scale = present_->scale();
  add_site(present_->emitted.branch_sites, present_->site.frame * local, u, scale * length, scale * radius);
}

void SiteSink::add_on_stem(const Frame& frame, float u, float length, float radius, StemPosition position) {
  if (!present_->context->wants_branch_sites) return;
  put_on_stem(position, add_site(present_->emitted.branch_sites, frame, u, length, radius));
}

void SiteSink::add_named(std::uint32_t name, const Frame& frame, float length, float radius, NodeIndex node) {
  if (++uncounted_ == kCountedTogether) count_sites();
  present_->emitted.site_names.push_back(name);
  Site& site = present_->emitted.named_sites.add(present_->site);
  site.frame = frame;
  site.u = 1;
  site.length = length;
  site.radius = radius;
  if (node == kNoNode) return;
  put_on_stem({node, 1}, site);
  if (site.n != kCutOff) site.order = present_->emitted.stems.back().skeleton.order[site.node];
}

/// Adds a site. It stands at the end of the last stem that the instance has emitted. Without such a stem, it keeps the
/// stem on which the instance stands.
Site& SiteSink::add_site(SiteList& sites, const Frame& frame, float u, float length, float radius) {
  if (++uncounted_ == kCountedTogether) count_sites();
  Site& site = sites.add(present_->site);
  site.frame = frame;
  site.u = u;
  site.length = length;
  site.radius = radius;
  if (present_->stem_count == 0) return site;
  const EmittedStem& stem = present_->emitted.stems.back();
  site.stem = stem.id();
  site.node = static_cast<NodeIndex>(stem.skeleton.node_count() - 1);
  site.along = 1;
  if (stem.skeleton.node_count() > 0) site.individual = stem.individual_at(site.node);
  return site;
}

/// Moves a site at a position of the whole last emitted stem to the rest of the stem. Marks the site as cut off if the
/// position is gone.
void SiteSink::put_on_stem(StemPosition whole, Site& site) const {
  const EmittedStem& stem = present_->emitted.stems.back();
  const std::optional<StemPosition> left = stem.left_of(whole);
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

/// Returns the last site of `add_named` or of `add`. Returns null if no link uses the sites of `add`.
Site* SiteSink::last(bool is_named) {
  Emitted& emitted = present_->emitted;
  if (is_named) return &emitted.named_sites.back();
  return emitted.child_sites.size() == first_child_ ? nullptr : &emitted.child_sites.back();
}

void SiteSink::give(std::span<const double> numbers, bool to_named) {
  Site* const site = last(to_named);
  const std::vector<std::uint32_t>& slots = present_->prototype().given_slots;
  if (site == nullptr || slots.empty()) return;  // the graph has no names for the numbers
  assert(numbers.size() == slots.size());
  SiteValues values;
  if (present_->site.values != nullptr) values = *present_->site.values;
  values.names = present_->context->site_names_hash;
  values.numbers.resize(present_->context->site_names, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < slots.size(); ++k) values.numbers[slots[k]] = numbers[k];
  site->values = std::make_shared<const SiteValues>(std::move(values));
}

void SiteSink::from_row(std::uint32_t row, bool is_named) {
  if (Site* const site = last(is_named)) site->row = row;
}

void SiteSink::born(double step) {
  if (!present_->grows_in_time() || !present_->stands_as_grown) return;
  Site& site = present_->emitted.named_sites.back();
  site.birth = static_cast<float>(step);
  site.appeared = step / *present_->context->animation->steps_per_second;
}

void SiteSink::expect(std::uint64_t count) {
  expected_ = count;
  const EmitterContext& context = *present_->context;
  if (context.instances.load(std::memory_order_relaxed) + count > context.limits.instances) throw_too_many();
}

std::uint32_t SiteSink::expect_parts(const ComponentMember<PartCount>& count) {
  parts_ = count;
  expect(count.value().parts());
  return count.value().parts();
}

std::vector<double> SiteSink::per_child(const PerChild& number, std::uint32_t count) const {
  if (!number.varying || count == 0) return std::vector<double>(count, number.plain);
  std::vector<Site> children(count, present_->site);
  const RandomKey key = present_->site.key.child("children");
  for (std::uint32_t k = 0; k < count; ++k) {
    children[k].i = k;
    children[k].n = count;
    children[k].key = key.child(k);
    if (parts_) children[k].part = static_cast<float>(parts_->value().last());
  }
  const VaryingValues evaluated(std::span(&*number.varying, 1), children, present_->context->time);
  std::vector<double> values(count);
  for (std::uint32_t k = 0; k < count; ++k) values[k] = evaluated.value(0, k);
  return values;
}

bool SiteSink::begin_clock(double delay, double speed) {
  Site& site = present_->site;
  const double start = site.appeared + delay;
  const bool has_started = present_->time() >= start;
  site.clock = {.start = site.clock.when(start), .speed = site.clock.speed * speed, .is_local = true};
  site.appeared = 0;
  return has_started;
}

void SiteSink::surround(Surroundings surroundings) {
  Fingerprint hash;
  surroundings.hash = 0;
  const Prototype& prototype = present_->prototype();
  if (const std::optional<std::uint64_t> site = hash_of(present_->site); site && prototype.fingerprint) {
    hash.add(*prototype.fingerprint).add(*site).add(prototype.depends_on_time ? present_->time() : 0);
    surroundings.hash = std::max<std::uint64_t>(1, hash.hash());
  }
  present_->site.surroundings = std::make_shared<const Surroundings>(std::move(surroundings));
}

/// Adds the sites that are not counted yet to the shared count.
void SiteSink::count_sites() {
  EmitterContext& context = *present_->context;
  const std::uint64_t before = context.instances.fetch_add(uncounted_, std::memory_order_relaxed);
  if (before + uncounted_ > context.limits.instances) throw_too_many();
  uncounted_ = 0;
}

void SiteSink::throw_too_many() const {
  const EmitterContext& context = *present_->context;
  const std::uint64_t limit = context.limits.instances;
  // If instances differ, threads decide which of them exceeds the limit. The message therefore names all of them.
  const bool is_one = context.together == 1;
  std::string who = fmt::format("'{}'", context.prototype.id);
  if (!is_one) who = fmt::format("{} instances of {}", context.together, who);
  if (context.prototype.varyings.empty() && expected_ > 0) {
    who += fmt::format(" with {} children{}", expected_, is_one ? "" : " each");
  }
  throw_past_limit(fmt::format("{} {} sites to more than {} instances", who, is_one ? "offers" : "offer", limit), limit,
                   "instances", context.multiplier);
}

}  // namespace meristem
