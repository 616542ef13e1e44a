// SPDX-License-Identifier: Apache-2.0
// Plans of data sets: which plants grow, with which values, and what is kept of each. A plan is JSON:
//
//   {"meristem_dataset": 1, "documents": ["oak"], "seeds": 1000,
//    "vary": {"age": {"uniform": [20, 60]}},
//    "files": [".glb", ".mtg"], "measures": ["height"], "pictures": {"size": [512, 512], "coco": true}}
//
// The number of a plant alone says what it is: its document, its seed and its values are functions of the plan and the
// number, on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/dataset/variation.h"
#include "meristem/document/bundle.h"
#include "meristem/document/document.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"

namespace meristem {

struct PlantOutput;

/// The newest format of plans that this program reads.
inline constexpr int kDatasetPlanFormat = 1;
/// The most plants that one plan may ask for.
inline constexpr std::uint64_t kMostPlants = 1'000'000'000;

/// Paths as `--set` takes them, and values.
using PathValues = std::vector<std::pair<std::string, Value>>;

/// A document of a plan.
struct PlannedDocument {
  std::string name;                                     ///< unique within the plan, and fit for names of files
  PathValues set;                                       ///< for all plants of this document
  DocumentBundle bundle;                                ///< its text and the files that it names, by content
  std::string file;                                     ///< where it was read
  std::vector<std::pair<std::string, Variation>> vary;  ///< bounded to the ranges of the document's own variables
  std::string title;                                    ///< the name that the document says
  std::string licence;                                  ///< the licence that the document says
};

/// Pictures of each plant. `views` and the angles decide from where.
struct PicturePlan {
  /// The format of the pictures, or no pictures.
  enum class Colour { png, jpg, none };
  /// The format of a map, or no map.
  enum class Map { none, png, pfm };
  std::vector<int> size{512, 512};  ///< width and height, pixels
  int samples = 16;                 ///< light paths for each pixel; larger: less noise, slower
  bool transparent = false;         ///< true: neither sky nor ground, and alpha is 0 beside the plant
  Colour colour = Colour::png;      ///< format of the pictures
  Map depth = Map::none;            ///< format of the distances to the camera
  Map normals = Map::none;          ///< format of the surface normals
  bool organs = false;              ///< true: masks of organs
  bool shoots = false;              ///< true: masks of shoots
  bool plants = false;              ///< true: masks of plants
  bool coco = false;                ///< true: annotations in the format of COCO
  /// Fixed views, azimuth and altitude in degrees; empty where they are drawn.
  std::vector<std::pair<double, double>> fixed_views{};
  int drawn_views = 0;                     ///< views that are drawn; 0 without fixed ones: the document's camera
  Variation azimuth{.numbers = {0, 360}};  ///< degrees, drawn for each view
  Variation altitude{.numbers = {0, 30}};  ///< degrees, drawn for each view

  int view_count() const;  ///< number of pictures of each plant
};

/// Files of one kind for each plant.
struct PlannedFile {
  const PlantOutput* output = nullptr;  ///< the kind of file; not null
  Value settings;                       ///< what the plan says beside the ending; null: nothing
};

/// One plant of a plan.
struct PlannedPlant {
  std::uint64_t number = 0;        ///< from 0
  std::string key;                 ///< the number with leading zeros, all as long: what its files are called
  std::size_t document = 0;        ///< index into DatasetPlan::documents
  std::uint64_t seed = 0;          ///< seed of the document
  PathValues values;               ///< of grid, samples and distributions, in the order of DatasetPlan::columns
  RandomKey random = RandomKey();  ///< for whatever else is drawn for it
};

/// A plan that was read without faults.
struct DatasetPlan {
  std::string name;                        ///< name of the data set
  std::string description;                 ///< free text for the data card
  std::string author;                      ///< who made the plan, for the data card
  std::string licence;                     ///< licence of the data set, for the data card
  std::uint64_t seed = 1;                  ///< of what is drawn
  int rows = 1000;                         ///< of one table of the manifest
  double time = 0;                         ///< seconds: documents as they stand then
  std::vector<PlannedDocument> documents;  ///< documents that plants grow from, at least one
  PathValues set;                          ///< values of all plants
  std::vector<std::pair<std::string, std::vector<Value>>>
      grid;                             ///< paths and their values; plants take all combinations
  std::vector<PathValues> samples;      ///< sets of values, if there is no grid
  std::vector<std::string> columns;     ///< paths of all values that differ from plant to plant
  std::vector<std::uint64_t> seeds;     ///< empty: they count from first_seed
  std::uint64_t first_seed = 1;         ///< first seed, if `seeds` is empty
  std::uint64_t seed_count = 1;         ///< number of seeds, if `seeds` is empty
  std::vector<PlannedFile> files;       ///< files of each plant
  std::optional<PicturePlan> pictures;  ///< pictures of each plant; unset: no pictures
  std::vector<std::string> measures;    ///< names of the measures of each plant
  Value tree;  ///< what the plan's text says, documents by their names: what two plans are compared by
  /// Hash of what decides on the plants and what is kept of them, the documents aside, as 32 hexadecimal digits.
  std::string hash;
  std::vector<Diagnostic> warnings;  ///< oddities of the plan that are no faults

  /// How many plants it asks for.
  std::uint64_t count() const;
  /// The plant of a number below count().
  PlannedPlant plant(std::uint64_t number) const;
  /// Sets of values: of the grid or the samples.
  std::uint64_t setting_count() const;
};

/// A document that a program has at hand, for the plan to take in place of those that it names.
struct GivenDocument {
  std::string name;  ///< what the plan calls it; empty: as its file is called
  std::string text;  ///< text of the document
  std::string file;  ///< from whose folder the files that it names are sought
  PathValues set;    ///< values that replace values of the document
};

/// How a plan is read.
struct PlanOptions {
  std::string models{};                    ///< folder of shipped models, which plans may name
  std::string root{};                      ///< nothing outside this folder is read, as of ReadOptions; empty: no limit
  std::vector<GivenDocument> documents{};  ///< in place of the plan's; empty: those that it names
};

/// Reads a plan with its documents. `file` names it in messages; the documents are sought from its folder. Throws one
/// InputError with all faults, each with file, line, column and path: those of the plan and of its documents, and of
/// values that do not suit the documents, as far as the first of each list and the ends of distributions tell.
DatasetPlan read_dataset_plan(const std::string& text, const std::string& file, const Registry& registry,
                              const PlanOptions& options = {});

/// The rows of a plan and of its pictures, for reading and messages.
const ParameterTable& plan_table();
/// Returns the rows of PicturePlan.
const ParameterTable& picture_plan_table();

}  // namespace meristem
