// SPDX-License-Identifier: Apache-2.0
// The table of overlay parts: names, titles, sentences, and the functions that fill their layers.
#include "meristem/export/overlay/overlay.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "meristem/base/diagnostic.h"
#include "meristem/export/overlay/overlay_makers.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

constexpr std::array<OverlayPartInfo, 15> kParts = {{
    {OverlayPart::points,
     "points",
     "Attraction points",
     "Attraction points of the plants that colonize space: those that pull, those that are used up, and those that "
     "were removed before growth.",
     {TracePart::points},
     &show_points},
    {OverlayPart::pulls,
     "pulls",
     "Pull of the points",
     "Lines from the nodes of colonizing plants to the attraction points that pull them in the next step.",
     {TracePart::pulls},
     &show_pulls},
    {OverlayPart::ways,
     "ways",
     "Ways to the light",
     "Arrows toward more light or room: of self-organizing plants from the buds that grew in this step, of other "
     "plants from some of their nodes past obstacles.",
     {TracePart::ways},
     &show_ways,
     true},
    {OverlayPart::markers,
     "markers",
     "Markers of room",
     "Markers that the buds of self-organizing plants could see, and those that shoots have taken.",
     {TracePart::steps, TracePart::markers},
     &show_markers},
    {OverlayPart::losses,
     "losses",
     "Shed and cut",
     "Branches that self-organizing plants lost in this step, shed for want of light or cut by an operation.",
     {TracePart::losses},
     &show_losses},
    {OverlayPart::skeleton, "skeleton", "Skeleton", "Axes and nodes of all plants.", {}, &show_skeleton, true},
    {OverlayPart::light,
     "light",
     "Light on buds",
     "Light of each open bud of self-organizing plants as a colour; of other plants the light that obstacles leave to "
     "each node.",
     {},
     &show_light,
     true},
    {OverlayPart::resource,
     "resource",
     "Resource",
     "Resource that comes to each metamer of self-organizing plants, as the colour of its internode.",
     {},
     &show_resource,
     true},
    {OverlayPart::hull,
     "hull",
     "Hull of the crown",
     "Convex hull of each tree's crown, whose lit share is measured.",
     {},
     &show_hull,
     true},
    {OverlayPart::supports,
     "supports",
     "Supports",
     "Lines of the scene that shoots may be tied to.",
     {},
     &show_supports},
    {OverlayPart::box,
     "box",
     "Box of the surface",
     "Box about each blended stem and each body of a crown, and one of the cells in which its surface is sought.",
     {},
     &show_box,
     true},
    {OverlayPart::sun,
     "sun",
     "Sun",
     "Arrows of the sun's light on the plant, and the sun's way over the day.",
     {},
     &show_sun},
    {OverlayPart::compass, "compass", "Compass", "A compass rose on the ground.", {}, &show_compass},
    {OverlayPart::scale, "scale", "Scale", "A bar on the ground with its length.", {}, &show_scale},
    {OverlayPart::axes,
     "axes",
     "Axes",
     "The axes x, y and z of the scene from its origin, with a mark at each round length.",
     {},
     &show_axes},
}};

}  // namespace

std::span<const OverlayPartInfo> overlay_parts() { return kParts; }

const OverlayPartInfo& overlay_part(OverlayPart part) { return kParts[static_cast<std::size_t>(part)]; }

OverlayPart overlay_part_named(std::string_view name, const std::string& who) {
  std::vector<std::string> known;
  for (const OverlayPartInfo& info : kParts) {
    if (name == info.name) return info.part;
    known.emplace_back(info.name);
  }
  throw InputError(Diagnostic{.message = fmt::format("{} cannot show '{}'", who, name),
                              .expected = fmt::format("a list of {}", fmt::join(known, ", ")),
                              .nearest = nearest_name(name, known)});
}

std::vector<OverlayPart> overlay_parts_named(std::string_view names, const std::string& option) {
  std::vector<OverlayPart> parts;
  while (true) {
    const std::size_t end = names.find(',');
    parts.push_back(overlay_part_named(names.substr(0, end), option));
    if (end == std::string_view::npos) break;
    names.remove_prefix(end + 1);
  }
  return parts;
}

TraceRequest request_for_overlays(std::span<const OverlayPart> parts) {
  TraceRequest request;
  for (const OverlayPart part : parts) request = request | overlay_part(part).request;
  return request;
}

std::vector<OverlayLayer> overlay_layers(const OverlaySource& source, std::span<const OverlayPart> parts,
                                         const Progress& progress) {
  const StepMarks marks = source.traces.marks(source.traces.shown_step(), request_for_overlays(parts), progress);
  Box bounds = source.bounds;
  for (const TracedPlace& point : marks.points) bounds.add(point.position);
  const auto reads_plant = [](OverlayPart part) { return overlay_part(part).reads_plant; };
  std::optional<ExpandedPlant> plant;
  if (std::ranges::any_of(parts, reads_plant)) plant.emplace(source.plant, source.limits, progress);
  const OverlaySubject subject{plant ? **plant : source.plant, source.scene, marks, bounds, source.right, progress};
  std::vector<OverlayLayer> layers;
  for (const OverlayPart part : parts) {
    progress.check();
    overlay_part(part).show(subject, layers.emplace_back(OverlayLayer{.part = part}));
  }
  return layers;
}

Box overlay_bounds(std::span<const OverlayLayer> layers) {
  Box box;
  for (const OverlayLayer& layer : layers) {
    if (layer.part == OverlayPart::sun || layer.part == OverlayPart::compass || layer.part == OverlayPart::scale)
      continue;
    for (const OverlayPoint& point : layer.points) box.add(point.position);
    for (const std::vector<OverlayLine>* lines : {&layer.lines, &layer.arrows}) {
      for (const OverlayLine& line : *lines) {
        box.add(line.from);
        box.add(line.to);
      }
    }
  }
  return box;
}

}  // namespace meristem
