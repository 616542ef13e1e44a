// SPDX-License-Identifier: Apache-2.0
// Fuzzes measured leaves: a file of midribs, a line of equals signs, and a file of widths. The result must be errors
// with their lines, or leaves that are fitted, aged, bent, reduced and meshed with finite numbers only.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "meristem/shape/grass/bend_leaf.h"
#include "meristem/shape/grass/fit_leaf.h"
#include "meristem/shape/grass/grass_blade.h"
#include "meristem/shape/grass/measured_leaves.h"
#include "meristem/shape/grass/midrib_family.h"
#include "meristem/shape/grass/reduce_leaf.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

constexpr std::string_view kBetween = "\n===\n";
constexpr std::size_t kMaxLeaves = 4;

void require_lines(const InputError& error, const SizeLimits& limits) {
  require(!error.diagnostics().empty() && error.diagnostics().size() <= limits.diagnostics);
  for (const Diagnostic& found : error.diagnostics()) require(!found.message.empty() && found.line >= 0);
}

std::vector<MeasuredCurve> midribs_of(std::string_view text, const SizeLimits& limits) {
  try {
    std::vector<Diagnostic> warnings;
    return read_midribs(text, limits, warnings);
  } catch (const InputError& error) {
    require_lines(error, limits);
    return {};
  }
}

std::vector<MeasuredCurve> widths_of(std::string_view text, const SizeLimits& limits) {
  try {
    std::vector<Diagnostic> warnings;
    return read_widths(text, limits, warnings);
  } catch (const InputError& error) {
    require_lines(error, limits);
    return {};
  }
}

/// Checks a leaf. A leaf with length 0 is invisible and always valid.
void require_leaf(const GrassLeaf& leaf) {
  require(std::isfinite(area(leaf)));
  if (leaf.length == 0) return;
  try {
    check_grass_leaf(leaf);
  } catch (const std::invalid_argument&) {
    require(false);
  }
  require(*std::max_element(leaf.r.begin(), leaf.r.end()) <= 1);
}

void require_blade(const GrassLeaf& leaf) {
  const Mesh mesh = make_grass_blade(leaf, {.twist = 1, .fold = 0.2, .waves = {.number = 3, .depth = 0.2}});
  for (const Vec3 position : mesh.positions) require(std::isfinite(position.x + position.y + position.z));
  for (const Vec3 normal : mesh.normals) require(std::isfinite(normal.x + normal.y + normal.z));
  for (const auto& triangle : mesh.triangles) {
    for (const auto vertex : triangle) require(vertex < mesh.vertex_count());
  }
}

void go_through_stages(const MeasuredCurve& midrib, const MeasuredCurve& widths) {
  for (const double smoothing : {0.0, FitOptions{}.smoothing}) {
    const FittedLeaf fitted = fit_leaf(midrib, widths, {.smoothing = smoothing, .pieces = 16});
    require(std::isfinite(fitted.distance) && fitted.midrib_length > 0);
    require_leaf(fitted.leaf);
    const MidribFamily family(fitted.leaf);
    for (const double age : {0.0, 0.3, 1.0}) require_leaf(aged(fitted.leaf, family, age));
    require_leaf(lived(fitted.leaf, family, 1, 0.2, [](double time, double visible) {
      return GrowthRates{.age = 1 + time, .length = 0.5 + visible, .width = 1.5 - time, .bend = 2};
    }));
    const GrassLeaf bent = turned(fitted.leaf, {{.from = 0.2, .to = 0.4, .angle = 1}});
    const ReductionOrder order = reduction_order(bent);
    require(order.points.size() + 2 == bent.point_count());
    const GrassLeaf less = reduced(bent, points_kept(order, 5));
    require_leaf(less);
    require_blade(less);
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer requires this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t between = std::min(text.find(kBetween), size);
  const SizeLimits limits;
  const std::vector<MeasuredCurve> midribs = midribs_of(text.substr(0, between), limits);
  const std::vector<MeasuredCurve> widths = widths_of(text.substr(std::min(between + kBetween.size(), size)), limits);
  if (widths.empty()) return 0;
  for (std::size_t k = 0; k < std::min(midribs.size(), kMaxLeaves); ++k) {
    go_through_stages(midribs[k], widths[k % widths.size()]);
  }
  return 0;
}
