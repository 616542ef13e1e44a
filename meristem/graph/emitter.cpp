// SPDX-License-Identifier: Apache-2.0
// Prepares each instance of a block: its frame, its colour, and whether it is visible. The component then emits its
// parts through the sinks, which share this instance (PresentInstance) and add to one list of parts (Emitted).
#include "meristem/graph/emitter.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/graph/omission.h"
#include "meristem/graph/present_instance.h"
#include "meristem/graph/vanished.h"

namespace meristem {

namespace {

bool is_finite(const Frame& frame) {
  const auto finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  return finite(frame.origin) && finite(frame.axes[0]) && finite(frame.axes[1]) && finite(frame.axes[2]);
}

}  // namespace

Emitter::Emitter(EmitterContext& context)
    : present_(std::make_unique<PresentInstance>(PresentInstance{.context = &context})),
      instance_(*present_),
      organs_(*present_),
      stems_(*present_),
      sites_(*present_) {}

Emitter::~Emitter() = default;

double Emitter::document_time() const { return present_->context->time; }

void Emitter::set_grown(std::vector<Skeleton> skeletons) { stems_.grown_ = std::move(skeletons); }

void Emitter::set_watched(std::shared_ptr<const GrowthTrace> watched) { present_->watched_growth = std::move(watched); }

void Emitter::instance(const ComponentBase& base, const Site& site, std::size_t index,
                       FunctionRef<void(const Site&)> expand) {
  const bool omitted = is_left_out(base, site, present_->context->time);
  if (omitted && !base.omit_keeps_children) return;
  present_->index = index;
  present_->is_visible = !omitted && !base.hidden;
  begin_instance(base, site);
  if (has_vanished(present_->site.frame)) return;
  expand(present_->site);
  sites_.end_instance();
}

void Emitter::begin_instance(const ComponentBase& base, const Site& site) {
  PresentInstance& present = *present_;
  const ComponentTraits& traits = *present.prototype().type;
  present.base = &base;
  present.site = site;
  present.surroundings = site.surroundings;
  present.site.frame = instance_frame(base, site.frame, traits.tropism, instance_.directions());
  const Frame place = base.place.frame();
  present.is_placed = place.axes != Mat3(1) || place.origin != Vec3(0);
  present.geometry_frame = present.site.frame * place;
  if (!is_finite(present.site.frame) || !is_finite(present.geometry_frame)) {
    throw InputError(
        Diagnostic{.message = fmt::format("the frame of instance {} of {} is not finite", site.i, site.n),
                   .expected = "smaller scales and shifts, in this component or in those that it stands on",
                   .path = present.path()});
  }
  present.tint = present.context->tinting.tint(base, site.key.child("colour"));
  present.site.part = 1;
  present.parent_section = std::exchange(present.site.section, 0);
  present.section = 0;
  present.stem_count = 0;
  present.stands_as_grown = false;
  organs_.begin_instance();
  sites_.begin_instance();
  if (present.is_individual() && !traits.bears_plants && !traits.speaks_of_space) {
    present.emitted.founded.push_back(
        {present.site.individual, present.site.frame.origin, deformation_at(present.site), present.site.row});
  }
}

Emitted Emitter::take() {
  Emitted& emitted = present_->emitted;
  emitted.organs.pack();
  emitted.child_sites.pack();
  emitted.branch_sites.pack();
  emitted.named_sites.pack();
  return std::move(emitted);
}

}  // namespace meristem
