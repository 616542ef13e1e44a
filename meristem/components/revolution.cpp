// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/revolution.h"

#include <algorithm>
#include <vector>

#include "meristem/shape/mesh/shading.h"

namespace meristem {

namespace {

/// The shape never varies between instances, so one key suffices.
void expand(const Revolution& component, const Site&, const InstanceContext& instance, OrganSink& organs,
            SiteSink& sites) {
  const std::vector<Vec2>& silhouette = component.body.silhouette;
  organs.add(Frame{}, 0, [&] {
    Mesh body = make_revolution(component.body);
    return component.shading == Revolution::Shading::flat ? flat_shaded(body, instance.progress()) : body;
  });
  float widest = 0;
  for (const Vec2 point : silhouette) widest = std::max(widest, point.x);
  const float tip = silhouette.back().y;
  sites.add(Frame{.origin = {0, tip, 0}}, tip - silhouette.front().y, widest);
}

void check_silhouette(const Revolution& component, const DocumentPath& path, ParameterReader& reader) {
  const auto error = find_error(component.body);
  if (!error) return;
  const DocumentPath silhouette(path, "silhouette");
  if (error->point) {
    reader.add_error(DocumentPath(silhouette, *error->point), error->message, error->expected);
  } else {
    reader.add_error(silhouette, error->message, error->expected);
  }
}

const ParameterTable& body_table() {
  static const ParameterTable table =
      Table<SolidOfRevolution>("a revolution", "A body of revolution.")
          .points("silhouette", &SolidOfRevolution::silhouette,
                  {.unit = Unit::metre, .min = 0, .max = 1e4, .usual = {0, 0.2}},
                  "Points [radius, height] of the silhouette from base to tip; heights may fall, as inside a cup.")
          .second(-1e4, 1e4, {0, 0.2})
          .together(PointsForm::silhouette)
          .choice("kind", &SolidOfRevolution::kind, {"spline", "linear"},
                  "How the points of the silhouette are joined: by a smooth 'spline' or by 'linear' pieces.")
          .integer("segments", &SolidOfRevolution::segments, {.min = 3, .max = 512, .usual = {3, 64}, .fixed = true},
                   "Number of corners around a whole turn; raised, rounder, with more triangles.")
          .integer("rings", &SolidOfRevolution::rings, {.min = 1, .max = 512, .usual = {1, 64}, .fixed = true},
                   "Number of quads along a spline silhouette, at least one between two points; raised, smoother, with "
                   "more triangles.")
          .number("sweep", &SolidOfRevolution::sweep, {.unit = Unit::degree, .min = 1, .max = 360, .fixed = true},
                  "Angle through which the silhouette is turned about the axis; below 360, the body is a wedge between "
                  "two flat sides.")
          .only_where({{"kind", {"spline"}}}, {"rings"});
  return table;
}

}  // namespace

ComponentType revolution_component() {
  return define_component<Revolution>({
      .traits = {.name = "revolution",
                 .doc = "A body of revolution about y: a cone, nut, fruit or pot; children stand at its tip.",
                 .material = {.colour = {0.48F, 0.33F, 0.2F}, .roughness = 0.6F},
                 .variety = 0.05},
      .parameters = Table<Revolution>("a revolution", "A body of revolution.")
                        .members(&Revolution::body, body_table())
                        .choice("shading", &Revolution::shading, {"smooth", "flat"},
                                "Shading: 'smooth' hides the edges between triangles, 'flat' shows each triangle as a "
                                "plane, the low-poly look.")
                        .check(check_silhouette),
      .expand = expand,
      .minimum_triangles =
          [](const Revolution& component, const KnownMembers&) {
            return static_cast<double>(revolution_triangles(component.body));
          },
  });
}

}  // namespace meristem
