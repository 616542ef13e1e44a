// SPDX-License-Identifier: Apache-2.0
#include "curve_values.h"

#include <algorithm>

#include "meristem/components/grass_curves.h"

namespace meristem::studio {

namespace {

Value points_value(const std::vector<Vec2>& points) {
  Value::List list;
  for (const Vec2 point : points) list.push_back(Value::List{point.x, point.y});
  return list;
}

Value leaf_value(const GrassCurves::Name& name) {
  const auto number = [](std::optional<int> one) { return one ? Value(*one) : Value(); };
  return Value::Object{{"rank", number(name.rank)}, {"leaf", number(name.leaf)}};
}

}  // namespace

Value curves_value(const GrownPlant& grown, const CurvesRequest& request) {
  const auto& components = grown.document->graph.components;
  const auto component = std::ranges::find(components, request.component, &Prototype::id);
  if (component == components.end()) return {};
  const std::optional<GrassCurves> curves = grass_curves(*component, request.rank, request.leaf);
  if (!curves) return {};
  Value::List leaves;
  for (const GrassCurves::Name& name : curves->leaves) leaves.push_back(leaf_value(name));
  return Value::Object{{"leaves", std::move(leaves)},
                       {"leaf", leaf_value(curves->leaf)},
                       {"midrib_points", points_value(curves->midrib_points)},
                       {"midrib", points_value(curves->midrib)},
                       {"distance", curves->midrib_distance},
                       {"width_points", points_value(curves->width_points)},
                       {"widths", points_value(curves->widths)},
                       {"midrib_file", curves->has_midrib_file},
                       {"width_file", curves->has_width_file},
                       {"length", curves->length},
                       {"width", curves->width}};
}

}  // namespace meristem::studio
