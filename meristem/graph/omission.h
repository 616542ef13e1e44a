// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/graph/table/site.h"

namespace meristem {

/// Returns true if a component's `omit` and `only` leave out the instance at this site.
inline bool is_left_out(const ComponentBase& base, const Site& site, double time) {
  return (base.omit && base.omit->contains(site, time)) || (base.only && !base.only->contains(site, time));
}

}  // namespace meristem
