// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/document/document.h"
#include "meristem/graph/table/plant_source.h"

namespace meristem {

/// Returns the path of a file without links and dots, or the given path if that fails.
std::string real_file(const std::string& file);

/// Opens and grows the documents that a document names. A document's plants grow in its own scene.
class DocumentSources : public PlantSources {
 public:
  /// `registry` and `options` must outlive this object. When open() is called, `options.chain` must begin with the
  /// document that names the others.
  DocumentSources(const Registry& registry, const ReadOptions& options) : registry_(registry), options_(options) {}

  /// Sets limits for all documents that are opened later, and for the documents that they open. Their own limits apply
  /// as well.
  void set_limits(const SizeLimits& limits) { limits_ = limits; }
  Opened open(const std::string& name, const FileAccess& access) override;

 private:
  const Registry& registry_;
  const ReadOptions& options_;
  SizeLimits limits_;
};

}  // namespace meristem
