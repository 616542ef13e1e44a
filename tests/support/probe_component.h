// SPDX-License-Identifier: Apache-2.0
// Components for tests of the sinks: a probe, whose expansion each test gives, and a child that records the sites at
// which it stands.
#pragma once

#include <functional>
#include <vector>

#include "meristem/graph/component.h"
#include "tests/support/build_graph.h"

namespace meristem::probe {

struct Probe : ComponentBase {
  PartCount parts{2.5};
  double size = 1;
  double age = 1;
};

using Expansion = std::function<void(const Probe& probe, const Site& site, Emitter& out)>;

/// A child's site, and its time in seconds.
struct Seen {
  Site site;
  double time = 0;
  bool has_directions = false;
};

/// Returns the types `camera`, `probe`, `stems` (a probe that makes stems), `seer` (the child) and `many` (three
/// children, a metre apart).
const Registry& registry();
/// Returns a camera, a component of this type below it, and a seer on that component.
GraphBuilder builder_of(const std::string& type, LinkKind kind = LinkKind::child);
/// Returns a graph of three probes, each with a seer.
GraphBuilder three_probes();
/// Grows a graph whose probes expand by `with`.
Plant grow(const GraphBuilder& builder, Expansion with, double time = 0);
/// Returns the sites of the seers of the last growth, by their number.
const std::vector<Seen>& seen();

Mesh triangle();
Frame shifted(float x);
/// Returns a stem of two segments, a metre each.
Skeleton straight_stem(const Site& site);

}  // namespace meristem::probe
