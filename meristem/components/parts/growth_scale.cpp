// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/growth_scale.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "meristem/graph/vanished.h"

namespace meristem {

namespace {

class Nothing : public Grower {
 public:
  int step_limit() const override { return 0; }
  bool step(Progress&) override { return false; }
  Skeleton take_skeleton(Progress&) override { return {}; }
};

}  // namespace

std::optional<double> growth_scale(const Frame& frame) {
  const double scale = glm::length(frame.heading());
  const bool is_finite = std::isfinite(scale) && std::isfinite(glm::length(frame.origin));
  return is_finite && !has_vanished(frame) ? std::optional(scale) : std::nullopt;
}

std::unique_ptr<Grower> make_nothing() { return std::make_unique<Nothing>(); }

}  // namespace meristem
