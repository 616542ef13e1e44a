// SPDX-License-Identifier: Apache-2.0
// Documents that a document places as whole plants. The graph knows them by this interface alone; who reads documents
// gives them.
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

/// With what a plant is grown.
struct PlantRequest {
  std::vector<std::pair<std::string, double>> values{};  ///< variables by name and parameters by path, in this order
  std::uint64_t seed = 0;                                ///< seed of the plant
  double time = 0;                                       ///< seconds

  bool operator==(const PlantRequest&) const = default;
};

/// A plant of another document as a view shows it, and what was recorded of its growth.
struct ShownPlant {
  std::shared_ptr<const PlantVariant> plant;   ///< not null
  std::shared_ptr<const GrowthTraces> traces;  ///< null if nothing was recorded
};

/// One plant of another document.
class PlacedGrowth {
 public:
  virtual ~PlacedGrowth() = default;
  /// The plant at the step of the view, all of whose components are looked at. A view with a step, or with wishes, has
  /// the growth kept: then other steps do not grow anew. One call at a time. Throws InputError, placed in the text of
  /// its own document, and Cancelled.
  virtual ShownPlant show(const GrowthView& view, const Progress& progress) = 0;
  virtual std::uint64_t bytes() const = 0;  ///< of memory that is kept
};

/// A document that was read and found good.
class PlantSource {
 public:
  /// What may be set in it.
  struct Handle {
    bool is_known = false;  ///< true if the document has such a handle
    std::string nearest{};  ///< the nearest name of one, where it is not known
    double min = 0;         ///< lower end of the variable's own range; -infinity if the document gives none
    double max = 0;         ///< upper end of the variable's own range; infinity if the document gives none
  };

  virtual ~PlantSource() = default;
  virtual const std::string& file() const = 0;               ///< as messages name it
  virtual std::uint64_t fingerprint() const = 0;             ///< hash of everything that the source was read from
  virtual Handle handle(const std::string& name) const = 0;  ///< handle of a variable, or of a parameter by its path
  /// Reads it with what is requested. May be called from many threads. Throws InputError, placed in its own text.
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
  /// `name` is that of a shipped model, or a path from the folder of `access`. Throws InputError (what is wrong in the
  /// document, documents that use each other, one outside of the root), and MachineError.
  virtual Opened open(const std::string& name, const FileAccess& access) = 0;
};

}  // namespace meristem
