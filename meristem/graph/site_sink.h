// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/graph/component_member.h"
#include "meristem/graph/site_list.h"
#include "meristem/graph/table/count.h"
#include "meristem/graph/table/site.h"
#include "meristem/graph/table/varying.h"
#include "meristem/graph/trimmed_stem.h"

namespace meristem {

struct PresentInstance;

/// Collects the sites where children of instances stand. Throws InputError if they exceed the limit of instances.
class SiteSink {
 public:
  /// `present` must outlive the sink.
  explicit SiteSink(PresentInstance& present) : present_(&present) {}

  /// Emits a site for children, relative to the instance's frame. Its length and radius are relative to the frame, too.
  /// Several calls multiply the children. Without a call, children stand in the instance's frame, unless `no_children`
  /// was called.
  void add(const Frame& local, float length = 0, float radius = 0);
  /// Emits a site for children at the tip of the last emitted stem, which must be a single axis. The frame, the stem's
  /// length and the radius at the tip are in world space and belong to the whole stem.
  void add_at_tip(const Frame& frame, float length, float radius);
  /// Makes sites only by `add`: for components whose number of children may be 0.
  void no_children() { has_child_sites_ = true; }
  /// Emits a site for the children of branch links that differs from the sites of child links. Without a call, and for
  /// components without stems, these children stand at the sites of child links.
  void add_for_branches(const Frame& local, float u, float length, float radius);
  /// Emits a site for the children of branch links in world space, on the last emitted stem. It stands at `position` of
  /// the whole stem.
  void add_on_stem(const Frame& frame, float u, float length, float radius, StemPosition position);
  /// Emits a site in world space for a component that the instance places. `name` is its index in the type's `placed`.
  /// `node` is a node of the last emitted stem, or kNoNode.
  void add_named(std::uint32_t name, const Frame& frame, float length, float radius, NodeIndex node);

  /// Gives these numbers to the last site of `add` or `add_named`, under the names that the type's `gives` lists. All
  /// descendants can use them.
  void give(std::span<const double> numbers, bool to_named);
  /// Sets the row of a table that has placed the last site of `add` or `add_named`.
  void from_row(std::uint32_t row, bool is_named);
  /// Sets the growth step at which the last site of `add_named` appeared. Used if stems grow over time and the
  /// instance's stems have already grown.
  void born(double step);

  /// Announces that `count` sites will be emitted, before anything is made for them. Throws InputError if they exceed
  /// the limit.
  void expect(std::uint64_t count);
  /// Like `expect`, for a count of the instance's parameters, which may have a fraction. The site of the last child is
  /// scaled by the fractional part. Returns the number of sites to emit. If the count has keys, each child appears when
  /// the count reaches its number.
  std::uint32_t expect_parts(const ComponentMember<PartCount>& count);
  /// Returns a number for each of `count` children of the instance, in the struct's unit. Expressions use the
  /// children's i and n and own random numbers; everything else belongs to the instance.
  std::vector<double> per_child(const PerChild& number, std::uint32_t count) const;

  /// Begins a clock for all descendants of the instance. It starts `delay` seconds after the instance appears, by the
  /// instance's own clock, and runs at `speed`. Returns true if it has started.
  bool begin_clock(double delay, double speed);
  /// Sets the surroundings (light, gravity, deformation, trim body) of all descendants of this instance. Affects sites
  /// and stems emitted after this call. The surroundings may depend only on the instance's parameters and site.
  void surround(Surroundings surroundings);

 private:
  friend class Emitter;

  void begin_instance();
  void end_instance();
  void finish(SiteList& sites, std::size_t first, bool has_parts);
  void number_named();
  const Varying* keys_of_parts() const;
  void set_part(Site& site) const;
  Site* last(bool is_named);
  void add_child(const Frame& frame, float length, float radius);
  Site& add_site(SiteList& sites, const Frame& frame, float u, float length, float radius);
  void put_on_stem(StemPosition whole, Site& site) const;
  void count_sites();
  [[noreturn]] void throw_too_many() const;

  PresentInstance* present_;
  bool has_child_sites_ = false;
  std::size_t first_child_ = 0;
  std::size_t first_branch_ = 0;
  std::size_t first_named_ = 0;
  std::uint64_t uncounted_ = 0;  // number of sites that are not yet in the context's count
  std::uint64_t expected_ = 0;   // the present instance's number of children, if it has announced it
  std::optional<ComponentMember<PartCount>> parts_;  // the present instance's count of parts, if it has announced one
  const Varying* keyed_parts_ = nullptr;             // keys of this count, or null
};

}  // namespace meristem
