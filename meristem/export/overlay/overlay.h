// SPDX-License-Identifier: Apache-2.0
// Overlays: what is shown over a plant without being part of it, such as attraction points, light, the sun and a scale.
// An overlay is points, lines, arrows and labels in world space, part by part. Pictures and the studio draw the same
// overlays.
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

/// The parts of overlays. Their names are the names of the enumerators.
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
  axes,
};

struct OverlayLayer;
struct OverlaySubject;  // source of overlays, with recorded growth

/// A part of the overlays, as users choose it.
struct OverlayPartInfo {
  OverlayPart part;                                                  ///< the part
  const char* name;                                                  ///< name for options and plans: "points"
  const char* title;                                                 ///< title for a switch: "Attraction points"
  const char* doc;                                                   ///< one sentence
  TraceRequest request;                                              ///< parts of growth that must be recorded
  void (*show)(const OverlaySubject& subject, OverlayLayer& layer);  ///< fills a layer with the part
  bool reads_plant = false;  ///< true if the part shows data of each stem, also in placed plants
};

/// Returns all parts, in the order in which they are listed.
std::span<const OverlayPartInfo> overlay_parts();
/// Returns the description of a part.
const OverlayPartInfo& overlay_part(OverlayPart part);
/// Returns the part of that name. Throws InputError with the nearest name for an unknown name. `who` names the caller
/// in the message.
OverlayPart overlay_part_named(std::string_view name, const std::string& who);
/// Returns the parts in a list of names separated by commas. Throws InputError with the nearest name for an unknown
/// name.
std::vector<OverlayPart> overlay_parts_named(std::string_view names, const std::string& option);
/// Returns the parts of growth that must be recorded for all these overlays.
TraceRequest request_for_overlays(std::span<const OverlayPart> parts);

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
  std::string text;  ///< ASCII text
};

/// A line of the legend.
struct OverlayKey {
  Vec3 colour{0};    ///< sRGB
  std::string text;  ///< ASCII text: "410 points pull"
};

/// The content of one part.
struct OverlayLayer {
  OverlayPart part = OverlayPart::points;  ///< the part that the layer shows
  std::vector<OverlayPoint> points;        ///< points
  std::vector<OverlayLine> lines;          ///< lines
  std::vector<OverlayLine> arrows;         ///< lines with a tip at their end
  std::vector<OverlayLabel> labels;        ///< texts
  std::vector<OverlayKey> legend;          ///< meaning of the colours
};

/// The data from which overlays are made.
struct OverlaySource {
  const Plant& plant;          ///< the plant that is shown
  const GrowthTraces& traces;  ///< recorded with request_for_overlays() or more
  const Scene& scene;          ///< light and obstacles around the plant
  const SizeLimits& limits;    ///< limits of the document of the plant
  Box bounds;                  ///< box around all visible parts of the plant
  Vec3 right{1, 0, 0};         ///< unit vector on the ground along the scale bar
};

/// Returns the layers of the parts, in their order, at the present growth step of the plant. Overlays of placed plants
/// are repeated at each of their places. Equal on any number of threads. Throws InputError if limits are exceeded,
/// Cancelled.
std::vector<OverlayLayer> overlay_layers(const OverlaySource& source, std::span<const OverlayPart> parts,
                                         const Progress& progress);

/// Returns the box around the plant, its points and other layers of it, without sun, compass and scale.
Box overlay_bounds(std::span<const OverlayLayer> layers);

}  // namespace meristem
