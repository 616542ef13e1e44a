// SPDX-License-Identifier: Apache-2.0
#include "overlays_value.h"

#include <algorithm>
#include <string>
#include <vector>

#include "meristem/base/colour.h"
#include "meristem/export/overlay/overlay.h"
#include "meristem/export/packet/short_values.h"
#include "meristem/plant/plant_bounds.h"

namespace meristem::studio {

namespace {

/// Positions as floats, and colours as bytes: red, green, blue and opacity.
class PackedPlaces {
 public:
  void add(Vec3 position, Vec3 colour) {
    for (int k = 0; k < 3; ++k) positions_.push_back(position[k]);
    for (int k = 0; k < 3; ++k) {
      colours_.push_back(byte_from_srgb(colour[k]));
    }
    colours_.push_back(255);
  }
  void add(const std::vector<OverlayLine>& lines) {
    for (const OverlayLine& line : lines) {
      add(line.from, line.colour);
      add(line.to, line.colour);
    }
  }
  Value value(PacketArrays& arrays) const {
    return Value::Object{{"positions", arrays.add(positions_)}, {"colours", arrays.add(colours_)}};
  }

 private:
  std::vector<float> positions_;
  std::vector<unsigned char> colours_;
};

Value layer_value(const OverlayLayer& layer, PacketArrays& arrays) {
  PackedPlaces points, lines, arrows;
  for (const OverlayPoint& point : layer.points) points.add(point.position, point.colour);
  lines.add(layer.lines);
  arrows.add(layer.arrows);
  Value::List labels, legend;
  for (const OverlayLabel& label : layer.labels) {
    labels.push_back(Value::Object{{"at", vector_value(label.at)}, {"text", label.text}});
  }
  for (const OverlayKey& key : layer.legend) {
    legend.push_back(Value::Object{{"colour", vector_value(key.colour)}, {"text", key.text}});
  }
  return Value::Object{{"part", std::string(overlay_part(layer.part).name)},
                       {"points", points.value(arrays)},
                       {"lines", lines.value(arrays)},
                       {"arrows", arrows.value(arrays)},
                       {"labels", std::move(labels)},
                       {"legend", std::move(legend)}};
}

}  // namespace

Value overlays_value(const LastGrown& last, const OverlaysRequest& request, const Progress& progress,
                     PacketArrays& arrays) {
  std::vector<OverlayPart> parts;
  for (const std::string& name : request.parts) parts.push_back(overlay_part_named(name, "the studio"));
  const GrownPlant& grown = last.grown;
  const Box box = last.meshes != nullptr ? last.meshes->bounds() : bounds(grown.plant);
  const OverlaySource source{grown.plant, grown.traces, grown.document->scene, grown.document->graph.limits, box};
  Value::List layers;
  for (const OverlayLayer& layer : overlay_layers(source, parts, progress)) {
    layers.push_back(layer_value(layer, arrays));
  }
  return Value::Object{{"step", grown.traces.shown_step()}, {"layers", std::move(layers)}};
}

Value overlay_parts_value() {
  Value::List list;
  for (const OverlayPartInfo& part : overlay_parts()) {
    if (part.part == OverlayPart::compass || part.part == OverlayPart::scale) continue;  // the page draws these itself
    list.push_back(Value::Object{{"name", std::string(part.name)},
                                 {"title", std::string(part.title)},
                                 {"doc", std::string(part.doc)},
                                 {"recorded", part.request.any()}});
  }
  return list;
}

}  // namespace meristem::studio
