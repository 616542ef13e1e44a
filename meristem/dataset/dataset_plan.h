// SPDX-License-Identifier: Apache-2.0
// Plans of data sets: the plants to grow, their values, and the files to keep of each plant. A plan is JSON:
//
//   {"meristem_dataset": 1, "documents": ["oak"], "seeds": 1000,
//    "vary": {"age": {"uniform": [20, 60]}},
//    "files": [".glb", ".mtg"], "measures": ["height"], "pictures": {"size": [512, 512], "coco": true}}
//
// A plant's number determines its document, its seed and its values. They are functions of the plan and the number,
// equal on every machine.
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
inline constexpr std::uint64_t kMaxPlants = 1'000'000'000;

/// Pairs of a path as in `--set` and a value.
using PathValues = std::vector<std::pair<std::string, Value>>;

/// A document of a plan.
struct PlannedDocument {
  std::string name;                                          ///< unique within the plan, and usable in file names
  PathValues set;                                            ///< values for all plants of this document
  DocumentBundle bundle;                                     ///< its text and the files that it names, by content
  std::string file;                                          ///< path of the file that was read
  std::vector<std::pair<std::string, ValueVariation>> vary;  ///< distributions, limited to the ranges of the document's
                                                             ///< own variables
  std::string title;                                         ///< the document's own name
  std::string licence;                                       ///< the document's own licence
};

/// Pictures of each plant. The views and the angles determine the camera.
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
  /// Fixed views, azimuth and altitude in degrees. Empty if the views are random.
  std::vector<std::pair<double, double>> fixed_views{};
  int drawn_views = 0;  ///< number of random views; 0 without fixed views: the document's camera
  ValueVariation azimuth{.numbers = {0, 360}};  ///< degrees, drawn for each view
  ValueVariation altitude{.numbers = {0, 30}};  ///< degrees, drawn for each view

  int view_count() const;  ///< number of pictures of each plant
};

/// Files of one kind for each plant.
struct PlannedFile {
  const PlantOutput* output = nullptr;  ///< the kind of file; not null
  Value settings;                       ///< settings beside the ending in the plan; null: no settings
};

/// One plant of a plan.
struct PlannedPlant {
  std::uint64_t number = 0;        ///< from 0
  std::string key;                 ///< the number with leading zeros, equally long for all plants; part of its file
                                   ///< names
  std::size_t document = 0;        ///< index into DatasetPlan::documents
  std::uint64_t seed = 0;          ///< seed of the document
  PathValues values;               ///< values of grid, samples and distributions, in the order of DatasetPlan::columns
  RandomKey random = RandomKey();  ///< key for all other random numbers of the plant
};

/// A plan that was read without faults.
struct DatasetPlan {
  std::string name;                        ///< name of the data set
  std::string description;                 ///< free text for the data card
  std::string author;                      ///< who made the plan, for the data card
  std::string licence;                     ///< licence of the data set, for the data card
  std::uint64_t seed = 1;                  ///< seed of all random values
  int rows = 1000;                         ///< rows in one table of the manifest
  double time = 0;                         ///< seconds; keys of the documents are evaluated at this time
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
  Value tree;  ///< tree of the plan's text, documents by their names; two plans are compared by their trees
  /// Hash of everything that affects the plants and their files, except the documents, as 32 hexadecimal digits.
  std::string hash;
  std::vector<Diagnostic> warnings;  ///< oddities of the plan that are not faults

  /// Returns the number of plants in the plan.
  std::uint64_t count() const;
  /// Returns the plant with a number below count().
  PlannedPlant plant(std::uint64_t number) const;
  /// Returns the number of sets of values, from the grid or the samples.
  std::uint64_t setting_count() const;
};

/// A document that a program already holds. It replaces a document that the plan names.
struct GivenDocument {
  std::string name;  ///< name of the document in the plan; empty: the name of its file
  std::string text;  ///< text of the document
  std::string file;  ///< path whose folder contains the files that the document names
  PathValues set;    ///< values that replace values of the document
};

/// Options for reading a plan.
struct PlanOptions {
  std::string models{};                    ///< folder of shipped models, which plans may name
  std::string root{};                      ///< no file outside this folder is read, as in ReadOptions; empty: no limit
  std::vector<GivenDocument> documents{};  ///< documents that replace the plan's; empty: the plan's documents are read
};

/// Reads a plan with its documents. `file` names the plan in messages; paths of documents start at its folder. Throws
/// one InputError with all faults, each with file, line, column and path. It reports faults of the plan, of its
/// documents, and of values that do not suit the documents. For the last, it tries the first value of each list and the
/// ends of distributions.
DatasetPlan read_dataset_plan(const std::string& text, const std::string& file, const Registry& registry,
                              const PlanOptions& options = {});

/// Returns the rows of a plan, for reading and messages.
const ParameterTable& plan_table();
/// Returns the rows of PicturePlan.
const ParameterTable& picture_plan_table();

}  // namespace meristem
