// SPDX-License-Identifier: Apache-2.0
// Measurements of a document: at its present state, and over the values of one of its handles or parameters.
#pragma once

#include <memory>
#include <string>

#include "grower.h"
#include "host.h"
#include "job_messages.h"
#include "meristem/document/grow.h"
#include "meristem/graph/table/read_store.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Returns a list of {"name", "unit", "doc"} with all measures in their order.
Value measure_rows_value();

/// The source of a measurement: a document, and its grown plant if there is one.
struct MeasureSource {
  std::shared_ptr<const Document> document;  ///< document at the time
  std::shared_ptr<const GrownPlant> grown;   ///< grown plant of the same document and time; null: the document is grown
                                             ///< again
  double time = 0;                           ///< seconds, of the document
};

/// Returns the measures as `meristem measure --json` writes them. Throws InputError, Cancelled.
Value measured(const MeasureSource& source, const MeasuresRequest& request, Progress& progress);

/// A document's text, which is read with each of several values.
struct SweepSource {
  std::string text;
  std::string file;  ///< absolute path
  std::string root;
  std::string models;
  double time = 0;  ///< seconds, of the document
};

/// Keeps results that the values of a sweep share. Only one thread at a time may call it.
class SweepMaker {
 public:
  /// Returns a list with an object per value: {"value", "measures"}, or {"value", "faults"} if the document has faults
  /// with the value. Throws Cancelled.
  Value make(const SweepSource& source, const SweepRequest& request, const Registry& registry, JobMessages& messages);

 private:
  Value one(const SweepSource& source, const SweepRequest& request, double value, const Registry& registry,
            Progress& progress);

  ReadStore store_;
  GrowthCache cache_;
};

}  // namespace meristem::studio
