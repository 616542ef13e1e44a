// SPDX-License-Identifier: Apache-2.0
// Makes one plant of a plan at a time: reads its document with the plant's values, grows it, measures it and writes its
// files. Results that plants of one document share are cached. A fault of the values becomes the error in the plant's
// row.
#include "meristem/dataset/plant_maker.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/plant_output.h"
#include "meristem/dataset/plant_pictures.h"
#include "meristem/measure/foliage.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPlantsPerFolder = 1000;

/// Throws MachineError with the reason why a folder cannot be read or cleared.
[[noreturn]] void throw_of_folder(const std::string& folder, const std::error_code& problem) {
  throw MachineError(fmt::format("{}: {}", folder, problem.message()));
}

/// Returns the names of the files in a folder, sorted. Throws MachineError.
std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code problem;
  for (fs::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
    names.push_back(at->path().filename().string());
  if (problem) throw_of_folder(folder, problem);
  std::ranges::sort(names);
  return names;
}

/// Returns true if any of the named measures has the flag.
bool has_any(const std::vector<std::string>& measures, bool MeasureRow::*flag) {
  return std::ranges::any_of(measure_rows(), [&](const MeasureRow& row) {
    return row.*flag && std::ranges::find(measures, row.name) != measures.end();
  });
}

/// Returns the stage up to which a plant must grow before its files are written.
GrownPart part_for(const DatasetPlan& plan) {
  GrownPart part = has_any(plan.measures, &MeasureRow::needs_light) ? GrownPart::meshes : GrownPart::plant;
  for (const PlannedFile& file : plan.files) part = std::max(part, file.output->needs);
  if (plan.pictures) part = GrownPart::textures;
  return part;
}

TraceRequest request_for(const DatasetPlan& plan) {
  TraceRequest request;
  for (const PlannedFile& file : plan.files) request = request | file.output->request;
  return request;
}

std::vector<MeasureValue> measured(const DatasetPlan& plan, const Document& document, GrownDocument& grown,
                                   const GrowthOptions& options, Progress& progress) {
  if (plan.measures.empty()) return {};
  const bool has_meshes = grown.up_to >= GrownPart::meshes;
  // Holes of textures are no part of a leaf, and light passes through them.
  if (has_holes(grown.plant)) {
    if (has_meshes) complete_growth(document, grown, progress, options);
    if (!has_meshes) paint_plant(document, grown.plant, progress, options.cache);
  }
  const SizeLimits& limits = document.graph.limits;
  const MeasureOptions measures{.organ_light = has_any(plan.measures, &MeasureRow::needs_light)};
  StandMeasures stand = has_meshes
                            ? measure_plant(grown.plant, limits, grown.meshes, document.scene, measures, progress)
                            : measure_plant(grown.plant, limits, document.scene, measures, progress);
  if (!has_meshes && has_any(plan.measures, &MeasureRow::is_geometry)) {
    stand.whole.set_geometry(count_geometry(document, grown.plant, progress));
  }
  std::vector<MeasureValue> values;
  for (const std::string& name : plan.measures) {
    for (const MeasureRow& row : measure_rows()) {
      if (row.name == name) values.push_back(row.value(stand.whole));
    }
  }
  return values;
}

PlantFile file_in(const fs::path& path, const std::string& name) {
  const std::optional<std::string> bytes = whole_file(path.string());
  if (!bytes) throw MachineError(fmt::format("cannot read '{}' again", path.string()));
  return {name, bytes->size(), hash128_hex(std::as_bytes(std::span(bytes->data(), bytes->size())))};
}

/// Returns all faults in one line.
std::string line_of(const InputError& error) {
  std::string line;
  for (const Diagnostic& diagnostic : error.diagnostics()) {
    if (diagnostic.severity != Severity::error) continue;
    line += (line.empty() ? "" : "; ") + diagnostic.text();
  }
  return line;
}

}  // namespace

std::string unpacked_document(const PlannedDocument& document, const std::string& folder) {
  return (fs::path(folder) / document.name / document.bundle.document).string();
}

void unpack_documents(const DatasetPlan& plan, const std::string& folder) {
  for (const PlannedDocument& document : plan.documents) {
    unpack(document.bundle, (fs::path(folder) / document.name).string());
  }
}

std::string plant_folder(const PlannedPlant& plant) {
  return fmt::format("plants/{:04}", plant.number / kPlantsPerFolder);
}

/// Results that a maker keeps from plant to plant. They are of one document, because all of its plants are adjacent in
/// a plan.
struct PlantMaker::Kept {
  ReadStore files;
  GrowthCache cache;
  std::size_t document = 0;  // document whose plants are in the cache

  GrowthCache* cache_of(std::size_t of_document) {
    if (of_document != document) cache.clear();
    document = of_document;
    return &cache;
  }
};

PlantMaker::PlantMaker(const DatasetPlan& plan, const Registry& registry, DocumentFolders folders)
    : plan_(plan), registry_(registry), folders_(std::move(folders)), kept_(std::make_unique<Kept>()) {}

PlantMaker::~PlantMaker() = default;

Document PlantMaker::document_of(const PlannedPlant& plant) const {
  const PlannedDocument& planned = plan_.documents[plant.document];
  ReadOptions options{.seed = plant.seed, .time = plan_.time, .store = &kept_->files, .models = folders_.models};
  for (const PathValues* values : std::initializer_list<const PathValues*>{&planned.set, &plan_.set, &plant.values}) {
    for (const auto& [path, value] : *values) {
      std::erase_if(options.overrides, [&name = path](const ValueOverride& earlier) { return earlier.path == name; });
      options.overrides.push_back({path, value, ""});
    }
  }
  const auto& files = planned.bundle.files;
  const auto text =
      std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.first == planned.bundle.document; });
  return read_document(text->second, unpacked_document(planned, folders_.documents), registry_, options);
}

/// Replaces paths of unpacked documents in messages by their paths in the data set.
std::string PlantMaker::relative(std::string text) const {
  const std::string folder = (fs::path(folders_.documents) / "").string();
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at)) {
    text.erase(at, folder.size());
  }
  return text;
}

void PlantMaker::write_files(const PlannedPlant& plant, const Document& document, GrownDocument& grown,
                             const std::string& folder, Progress& progress) {
  const std::string base = (fs::path(folder) / plant.key).string();
  for (const PlannedFile& file : plan_.files) {
    file.output->write({document, grown, file.settings}, base + file.output->ending, progress);
  }
  if (plan_.pictures) write_plant_pictures(plan_, plant, document, grown, base, progress);
}

MadePlant PlantMaker::make(std::uint64_t number, const std::string& folder, Progress& progress) {
  MadePlant made{.plant = plan_.plant(number), .files = {}, .measures = {}, .error = {}};
  try {
    const Document document = document_of(made.plant);
    GrowthOptions options{.time = plan_.time,
                          .up_to = part_for(plan_),
                          .cache = kept_->cache_of(made.plant.document),
                          .view = {{}, request_for(plan_)}};
    GrownDocument grown = grow_document(document, progress, options);
    options.up_to = GrownPart::textures;
    made.measures = measured(plan_, document, grown, options, progress);
    write_files(made.plant, document, grown, folder, progress);
  } catch (const InputError& error) {
    made.measures.clear();
    made.error = relative(line_of(error));
    for (const std::string& name : names_in(folder)) {
      std::error_code problem;
      fs::remove(fs::path(folder) / name, problem);
      if (problem) throw_of_folder(folder, problem);
    }
    return made;
  } catch (const std::bad_alloc&) {
    throw MachineError(
        fmt::format("memory has run out at the plant {}; fewer threads or processes need less", made.plant.key));
  }
  const std::string below = plant_folder(made.plant) + "/";
  for (const std::string& name : names_in(folder)) made.files.push_back(file_in(fs::path(folder) / name, below + name));
  return made;
}

}  // namespace meristem
