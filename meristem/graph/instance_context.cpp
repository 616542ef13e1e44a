// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/instance_context.h"

#include "meristem/graph/present_instance.h"

namespace meristem {

const Scene& InstanceContext::scene() const { return present_->context->scene; }

const Surroundings& InstanceContext::surroundings() const {
  static const Surroundings nothing;
  return present_->surroundings != nullptr ? *present_->surroundings : nothing;
}

const Directions& InstanceContext::directions() const {
  const std::shared_ptr<const Directions>& own = surroundings().directions;
  return own != nullptr ? *own : present_->context->directions;
}

const SizeLimits& InstanceContext::limits() const { return present_->context->limits; }

const std::string& InstanceContext::component() const { return present_->prototype().id; }

RandomKey InstanceContext::component_key() const { return present_->context->key; }

std::span<const Varying> InstanceContext::varyings() const { return present_->prototype().varyings; }

Progress& InstanceContext::progress() const { return *present_->context->progress; }

double InstanceContext::time() const { return present_->time(); }

bool InstanceContext::grows_in_time() const { return present_->grows_in_time(); }

const Animation& InstanceContext::animation() const { return *present_->context->animation; }

const GrowthTrace* InstanceContext::watched_growth() const { return present_->watched_growth.get(); }

}  // namespace meristem
