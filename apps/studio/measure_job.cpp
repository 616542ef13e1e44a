// SPDX-License-Identifier: Apache-2.0
#include "measure_job.h"

#include <utility>

#include "meristem/document/document.h"
#include "meristem/measure/measures.h"
#include "meristem/output/measure_report.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

MeasureOptions options_of(const MeasuresRequest& request) {
  return {.organ_light = request.light, .layer_height = request.layer_height};
}

/// Textures are painted where the light or the area of leaves depends on their holes.
Value measured_plant(const Document& document, const GrownDocument& grown, const MeasuresRequest& request,
                     Progress& progress) {
  return measures_value(
      measure_plant(grown.plant, document.graph.limits, grown.meshes, document.scene, options_of(request), progress),
      {});
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
  if (source.grown == nullptr) {
    return measured_plant(document, grow_document(document, progress, {.time = source.time}), request, progress);
  }
  GrownDocument grown{.plant = source.grown->plant};
  grown.meshes = mesh_detail(document, grown.plant, {}, progress);
  return measured_plant(document, grown, request, progress);
}

Value SweepMaker::one(const SweepSource& source, const SweepRequest& request, double value, const Registry& registry,
                      Progress& progress) {
  Value::Object told{{"value", value}};
  try {
    const std::vector<Override> values{{.path = request.path, .value = value, .name = "the value of " + request.path}};
    const Document document = read_document(
        source.text, source.file, registry,
        {.overrides = values, .time = source.time, .root = source.root, .store = &store_, .models = source.models});
    const GrownDocument grown = grow_document(document, progress, {.time = source.time, .cache = &cache_});
    told.emplace_back("measures", measured_plant(document, grown, {.light = request.light}, progress));
  } catch (const InputError& error) {
    told.emplace_back("faults", faults_value(error.diagnostics(), {}, ""));
  }
  return told;
}

Value SweepMaker::make(const SweepSource& source, const SweepRequest& request, const Registry& registry,
                       JobNews& news) {
  Value::List list;
  for (std::size_t k = 0; k < request.values.size(); ++k) {
    news.begin_part("plant", k, request.values.size());
    list.push_back(one(source, request, request.values[k], registry, news.progress()));
  }
  return list;
}

}  // namespace meristem::studio
