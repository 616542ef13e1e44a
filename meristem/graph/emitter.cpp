// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/emitter.h"

#include <string_view>

#include "meristem/base/hash.h"
#include "meristem/graph/component.h"

namespace meristem {

std::uint64_t shape_key(std::initializer_list<double> numbers) {
  return hash64(std::string_view(reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(double)));
}

void Emitter::instance(const ComponentBase& base, const Site& site, std::size_t index,
                       FunctionRef<void(const Site&)> expand) {
  const bool omitted =
      (base.omit && base.omit->contains(site, time_)) || (base.only && !base.only->contains(site, time_));
  if (omitted && !base.omit_keeps_children) return;
  instance_ = index;
  visible_ = !omitted && !base.hidden;
  site_ = site;
  site_.frame = site.frame * base.frame.frame();
  geometry_frame_ = site_.frame * base.place.frame();

  const std::size_t first_child = child_sites.size();
  const std::size_t first_branch = branch_sites.size();
  expand(site_);
  if (child_sites.size() == first_child) child_site(Frame{});
  number_siblings(child_sites, first_child);
  number_siblings(branch_sites, first_branch);
}

void Emitter::organ(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make) {
  if (!visible_) return;
  const auto [found, is_new] = prototype_by_key_.try_emplace(key, static_cast<std::uint32_t>(prototypes.size()));
  if (is_new) prototypes.push_back({key, std::make_shared<const Mesh>(make())});
  organs.push_back({geometry_frame_ * local, found->second, site_.birth});
}

void Emitter::stem(Skeleton skeleton, const Surface& surface) {
  stems.push_back({std::move(skeleton), surface, site_, visible_});
}

void Emitter::child_site(const Frame& local, float length, float radius) {
  Site& site = child_sites.emplace_back(site_below(local, 0));
  site.u = 1;
  site.length = length;
  site.radius = radius;
}

void Emitter::branch_site(const Frame& local, float u, float length, float radius) {
  Site& site = branch_sites.emplace_back(site_below(local, 0));
  site.u = u;
  site.length = length;
  site.radius = radius;
}

Site Emitter::site_below(const Frame& local, std::uint32_t i) const {
  Site below = site_;
  below.frame = site_.frame * local;
  below.i = i;
  return below;
}

void Emitter::number_siblings(std::vector<Site>& sites, std::size_t first) {
  const auto count = static_cast<std::uint32_t>(sites.size() - first);
  for (std::uint32_t k = 0; k < count; ++k) {
    sites[first + k].i = k;
    sites[first + k].n = count;
  }
}

}  // namespace meristem
