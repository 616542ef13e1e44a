// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/emitted.h"

namespace meristem {

std::optional<StemPosition> EmittedStem::left_of(StemPosition whole) const {
  return trimmed == nullptr ? std::optional(whole) : trimmed->left_of(whole);
}

float EmittedStem::length_left() const {
  if (trimmed == nullptr) return 1;
  if (trimmed->left().node_count() == 0) return 0;
  return arcs_along_axes(trimmed->left()).back() / arcs_along_axes(trimmed->whole()).back();
}

}  // namespace meristem
