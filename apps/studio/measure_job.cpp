// SPDX-License-Identifier: Apache-2.0
// Measures a document, or one plant for each value of a sweep. A grown plant is reused if there is one. The plants of a
// sweep share a store of files and a growth cache, so each makes only what its value changes.
#include "measure_job.h"

#include <utility>

#include "meristem/document/document.h"
#include "meristem/export/measure_report.h"
#include "meristem/measure/foliage.h"
#include "meristem/measure/measures.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

MeasureOptions options_of(const MeasuresRequest& request) {
  return {.organ_light = request.light, .layer_height = request.layer_height};
}

/// Measures a plant. If textures have holes, they must be painted, because the light and the area of leaves depend on
/// the holes. Meshes are made only for light.
Value measured_plant(const Document& document, const Plant& plant, const MeasuresRequest& request, Progress& progress) {
  const MeasureOptions options = options_of(request);
  const SizeLimits& limits = document.graph.limits;
  StandMeasures stand;
  if (options.organ_light) {
    const MeshScene meshes = mesh_for_rays(document, plant, progress);
    stand = measure_plant(plant, limits, meshes, document.scene, options, progress);
  } else {
    stand = measure_plant(plant, limits, document.scene, options, progress);
  }
  stand.whole.set_geometry(count_geometry(document, plant, progress));
  return measures_value(stand, {});
}

/// Grows a plant for a measurement.
Plant grown_plant(const Document& document, double time, GrowthCache* cache, Progress& progress) {
  GrownDocument grown = grow_document(document, progress, {.time = time, .up_to = GrownPart::plant, .cache = cache});
  if (has_holes(grown.plant)) paint_plant(document, grown.plant, progress, cache);
  return std::move(grown.plant);
}

}  // namespace

Value measure_rows_value() {
  Value::List rows;
  for (const MeasureRow& row : measure_rows()) {
    rows.push_back(
        Value::Object{{"name", std::string(row.name)}, {"unit", std::string(row.unit)}, {"doc", std::string(row.doc)}});
  }
  return rows;
}

Value measured(const MeasureSource& source, const MeasuresRequest& request, Progress& progress) {
  const Document& document = *source.document;
  if (source.grown != nullptr) return measured_plant(document, source.grown->plant, request, progress);
  return measured_plant(document, grown_plant(document, source.time, nullptr, progress), request, progress);
}

Value SweepMaker::one(const SweepSource& source, const SweepRequest& request, double value, const Registry& registry,
                      Progress& progress) {
  Value::Object told{{"value", value}};
  try {
    const std::vector<ValueOverride> values{
        {.path = request.path, .value = value, .name = "the value of " + request.path}};
    const Document document = read_document(
        source.text, source.file, registry,
        {.overrides = values, .time = source.time, .root = source.root, .store = &store_, .models = source.models});
    const Plant plant = grown_plant(document, source.time, &cache_, progress);
    told.emplace_back("measures", measured_plant(document, plant, {.light = request.light}, progress));
  } catch (const InputError& error) {
    told.emplace_back("faults", errors_value(error.diagnostics(), {}, ""));
  }
  return told;
}

Value SweepMaker::make(const SweepSource& source, const SweepRequest& request, const Registry& registry,
                       JobMessages& messages) {
  Value::List list;
  for (std::size_t k = 0; k < request.values.size(); ++k) {
    messages.begin_part("plant", k, request.values.size());
    list.push_back(one(source, request, request.values[k], registry, messages.progress()));
  }
  return list;
}

}  // namespace meristem::studio
