// SPDX-License-Identifier: Apache-2.0
// What is shown over a plant and is no part of it: what it grew by, the light about it, the sun, a scale. An overlay is
// points, lines, arrows and labels in world space, part by part; pictures and the studio draw the same ones.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// What can be shown; the names are those of the enumerators.
enum class OverlayPart {
  points,
  pulls,
  ways,
  markers,
  losses,
  skeleton,
  light,
  resource,
  hull,
  supports,
  box,
  sun,
  compass,
  scale,
};

struct OverlayLayer;
struct OverlaySubject;  // what overlays are made from, with what was recorded of growth

/// A part as people choose it.
struct OverlayPartInfo {
  OverlayPart part;                                                  ///< the part
  const char* name;                                                  ///< name for options and plans: "points"
  const char* title;                                                 ///< for a switch: "Attraction points"
  const char* doc;                                                   ///< one sentence
  TraceWish wish;                                                    ///< what must have been recorded of growth
  void (*show)(const OverlaySubject& subject, OverlayLayer& layer);  ///< fills a layer with it
  bool reads_plant = false;  ///< it shows something of each stem, also of plants that stand there as a whole
};

/// All parts, in the order in which they are listed.
std::span<const OverlayPartInfo> overlay_parts();
/// Returns the description of a part.
const OverlayPartInfo& overlay_part(OverlayPart part);
/// The part of that name. Throws InputError for another name, with the nearest one; `who` cannot show it.
OverlayPart overlay_part_named(std::string_view name, const std::string& who);
/// The parts that a list of names separated by commas means. Throws InputError for another name, with the nearest one.
std::vector<OverlayPart> overlay_parts_named(std::string_view names, const std::string& option);
/// What must be recorded of growth for all of these.
TraceWish wish_for_overlays(std::span<const OverlayPart> parts);

/// A point of an overlay.
struct OverlayPoint {
  Vec3 position{0};  ///< world space, metres
  Vec3 colour{0};    ///< sRGB
};

/// A line of an overlay, or an arrow from `from` to `to`.
struct OverlayLine {
  Vec3 from{0};    ///< world space, metres
  Vec3 to{0};      ///< world space, metres
  Vec3 colour{0};  ///< sRGB
};

/// A text beside a position.
struct OverlayLabel {
  Vec3 at{0};        ///< world space, metres
  std::string text;  ///< ASCII
};

/// A line of the legend.
struct OverlayKey {
  Vec3 colour{0};    ///< sRGB
  std::string text;  ///< ASCII: "410 points pull"
};

/// What one part shows.
struct OverlayLayer {
  OverlayPart part = OverlayPart::points;  ///< the part that the layer shows
  std::vector<OverlayPoint> points;        ///< points
  std::vector<OverlayLine> lines;          ///< lines
  std::vector<OverlayLine> arrows;         ///< lines with a tip at their end
  std::vector<OverlayLabel> labels;        ///< texts
  std::vector<OverlayKey> legend;          ///< what the colours mean
};

/// What overlays show something of.
struct OverlaySource {
  const Plant& plant;          ///< the plant that is shown
  const GrowthTraces& traces;  ///< recorded with wish_for_overlays() or more
  const Scene& scene;          ///< light and obstacles around the plant
  const Limits& limits;        ///< of the document that the plant has grown from
  Box bounds;                  ///< around all that is seen of the plant
  Vec3 right{1, 0, 0};         ///< unit vector on the ground along which the scale lies
};

/// The layers of the parts, in their order, at the step of growth that the plant stands at. Plants of other documents
/// have theirs at each of their places. Equal on any number of threads. Throws InputError past limits, Cancelled.
std::vector<OverlayLayer> overlay_layers(const OverlaySource& source, std::span<const OverlayPart> parts,
                                         const Progress& progress);

/// The box around the plant, its points and what else layers show of it; not around sun, compass and scale.
Box overlay_bounds(std::span<const OverlayLayer> layers);

}  // namespace meristem
