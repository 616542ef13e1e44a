// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/document/document.h"
#include "meristem/graph/table/plant_source.h"

namespace meristem {

/// Where a file really lies, without links and dots; as it was named where that cannot be told.
std::string real_file(const std::string& file);

/// Reads the documents that a document names, and grows them. A document's own scene is what its plants grow in.
class DocumentSources : public PlantSources {
 public:
  /// `registry` and `options` outlive it; `options.chain` begins with the document that names them, by the time that
  /// open() is called.
  DocumentSources(const Registry& registry, const ReadOptions& options) : registry_(registry), options_(options) {}

  /// What is opened from now on, and all that it opens, is read and grown within these limits as well as its own.
  void set_limits(const Limits& limits) { limits_ = limits; }
  Opened open(const std::string& name, const FileAccess& access) override;

 private:
  const Registry& registry_;
  const ReadOptions& options_;
  Limits limits_;
};

}  // namespace meristem
