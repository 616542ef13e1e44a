// SPDX-License-Identifier: Apache-2.0
// Documents that a document places as whole plants. The graph knows them only by this interface; the reader of
// documents implements it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/table/file_access.h"

namespace meristem {

struct GrowthTraces;
struct GrowthView;
struct PlantVariant;

/// The values with which a plant is grown.
struct PlantRequest {
  std::vector<std::pair<std::string, double>> values{};  ///< variables by name and parameters by path, in this order
  std::uint64_t seed = 0;                                ///< seed of the plant
  double time = 0;                                       ///< seconds

  bool operator==(const PlantRequest&) const = default;
};

/// A plant of another document as a view shows it, and the records of its growth.
struct ShownPlant {
  std::shared_ptr<const PlantVariant> plant;   ///< not null
  std::shared_ptr<const GrowthTraces> traces;  ///< null if nothing was recorded
};

/// One plant of another document.
class PlacedGrowth {
 public:
  virtual ~PlacedGrowth() = default;
  /// Returns the plant at the step of the view. The view's `of` does not apply: the step is for all components. A view
  /// with a step or a trace request keeps the growth, so that other steps need no new growth. Only one call at a time
  /// is allowed. Throws InputError, placed in the text of its own document, and Cancelled.
  virtual ShownPlant show(const GrowthView& view, const Progress& progress) = 0;
  virtual std::uint64_t bytes() const = 0;  ///< memory of the kept growth
};

/// A document that was read without faults.
class PlantSource {
 public:
  /// A variable or parameter that a plant's request may set.
  struct Handle {
    bool is_known = false;  ///< true if the document has such a handle
    std::string nearest{};  ///< nearest name of a handle, if this one is unknown
    double min = 0;         ///< lower end of the variable's own range; -infinity if the document gives none
    double max = 0;         ///< upper end of the variable's own range; infinity if the document gives none
  };

  virtual ~PlantSource() = default;
  virtual const std::string& file() const = 0;               ///< as messages name it
  virtual std::uint64_t fingerprint() const = 0;             ///< hash of everything that the source was read from
  virtual Handle handle(const std::string& name) const = 0;  ///< handle of a variable, or of a parameter by its path
  /// Reads the document with the requested values. May be called from many threads. Throws InputError, placed in its
  /// own text.
  virtual std::shared_ptr<PlacedGrowth> plant(const PlantRequest& request) const = 0;
};

/// Opens documents for one that names them.
class PlantSources {
 public:
  /// An opened document.
  struct Opened {
    std::shared_ptr<const PlantSource> source;  ///< not null
    std::vector<NamedFile> files;               ///< all files that were read, without their hashes
  };

  virtual ~PlantSources() = default;
  /// Opens a document. `name` is the name of a shipped model, or a path from the folder of `access`. Throws InputError
  /// (faults in the document, documents that use each other, a document outside of the root), and MachineError.
  virtual Opened open(const std::string& name, const FileAccess& access) = 0;
};

}  // namespace meristem
