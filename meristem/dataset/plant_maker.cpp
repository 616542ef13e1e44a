// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_maker.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <span>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/dataset/plant_output.h"
#include "meristem/dataset/plant_pictures.h"
#include "meristem/measure/foliage.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPlantsPerFolder = 1000;

/// What a plan needs of each plant before its files are written.
GrownPart part_for(const DatasetPlan& plan) {
  GrownPart part = plan.measures.empty() ? GrownPart::plant : GrownPart::meshes;
  for (const PlannedFile& file : plan.files) part = std::max(part, file.output->needs);
  if (plan.pictures) part = GrownPart::textures;
  return part;
}

bool wants_light(const std::vector<std::string>& measures) {
  return std::any_of(measures.begin(), measures.end(),
                     [](const std::string& name) { return name == "leaf_exposure" || name == "leaf_irradiance"; });
}

std::vector<MeasureValue> measured(const DatasetPlan& plan, const Document& document, GrownDocument& grown,
                                   const GrowthOptions& options, Progress& progress) {
  if (plan.measures.empty()) return {};
  // Holes of textures are no leaf, and light falls through them.
  if (has_holes(grown.plant)) complete_growth(document, grown, progress, options);
  const StandMeasures stand =
      measure_plant(grown.plant, grown.meshes, document.scene, {.organ_light = wants_light(plan.measures)}, progress);
  std::vector<MeasureValue> values;
  for (const std::string& name : plan.measures) {
    for (const MeasureRow& row : measure_rows()) {
      if (row.name == name) values.push_back(row.value(stand.whole));
    }
  }
  return values;
}

PlantFile file_in(const fs::path& path, const std::string& name) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  const std::string bytes = std::move(content).str();
  if (!file || file.bad()) throw MachineError(fmt::format("cannot read '{}' again", path.string()));
  return {name, bytes.size(), hash128_hex(std::as_bytes(std::span(bytes.data(), bytes.size())))};
}

/// All faults in one line.
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

/// What makers keep from plant to plant. Growth caches are one per document: textures differ with the document.
struct PlantMaker::Kept {
  ReadStore files;
  std::map<std::size_t, GrowthCache> caches;
};

PlantMaker::PlantMaker(const DatasetPlan& plan, const Registry& registry, DocumentFolders folders)
    : plan_(plan), registry_(registry), folders_(std::move(folders)), kept_(std::make_unique<Kept>()) {}

PlantMaker::~PlantMaker() = default;

Document PlantMaker::document_of(const PlannedPlant& plant) const {
  const PlannedDocument& planned = plan_.documents[plant.document];
  ReadOptions options{.seed = plant.seed, .time = plan_.time, .store = &kept_->files, .models = folders_.models};
  for (const PathValues* values : std::initializer_list<const PathValues*>{&planned.set, &plan_.set, &plant.values}) {
    for (const auto& [path, value] : *values) {
      std::erase_if(options.overrides, [&name = path](const Override& earlier) { return earlier.path == name; });
      options.overrides.push_back({path, value, ""});
    }
  }
  const auto& files = planned.bundle.files;
  const auto text =
      std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.first == planned.bundle.document; });
  return read_document(text->second, unpacked_document(planned, folders_.documents), registry_, options);
}

/// Messages name documents as the data set does, wherever they were unpacked.
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
    const RandomKey random = plant.random.child("file").child(file.output->ending);
    file.output->write({document, grown, file.settings, random}, base + file.output->ending, progress);
  }
  if (plan_.pictures) write_plant_pictures(plan_, plant, document, grown, base, progress);
}

MadePlant PlantMaker::make(std::uint64_t number, const std::string& folder, Progress& progress) {
  MadePlant made{.plant = plan_.plant(number), .files = {}, .measures = {}, .error = {}};
  try {
    const Document document = document_of(made.plant);
    GrowthOptions options{.time = plan_.time, .up_to = part_for(plan_), .cache = &kept_->caches[made.plant.document]};
    GrownDocument grown = grow_document(document, progress, options);
    options.up_to = GrownPart::textures;
    made.measures = measured(plan_, document, grown, options, progress);
    write_files(made.plant, document, grown, folder, progress);
  } catch (const InputError& error) {
    made.measures.clear();
    made.error = relative(line_of(error));
    for (const fs::directory_entry& left : fs::directory_iterator(folder)) fs::remove(left.path());
    return made;
  } catch (const std::bad_alloc&) {
    throw MachineError(
        fmt::format("memory has run out at the plant {}; fewer threads or processes need less", made.plant.key));
  }
  const std::string below = plant_folder(made.plant) + "/";
  std::vector<std::string> names;
  for (const fs::directory_entry& file : fs::directory_iterator(folder))
    names.push_back(file.path().filename().string());
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) made.files.push_back(file_in(fs::path(folder) / name, below + name));
  return made;
}

}  // namespace meristem
