// SPDX-License-Identifier: Apache-2.0
// What is measured on a document: as it stands, and over the values of one of its handles or parameters.
#pragma once

#include <memory>
#include <string>

#include "grower.h"
#include "host.h"
#include "job_news.h"
#include "meristem/document/grow.h"
#include "meristem/graph/table/read_store.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// A list of {"name", "unit", "doc"}: all measures, in their order.
Value measure_rows_value();

/// What is measured: a document, and what has grown of it already.
struct MeasureSource {
  std::shared_ptr<const Document> document;  ///< as it stands at the time
  std::shared_ptr<const GrownWish> grown;    ///< of the same document and time; null: it grows anew
  double time = 0;                           ///< seconds, of the document
};

/// The measures as `meristem measure --json` writes them. Throws InputError, Cancelled.
Value measured(const MeasureSource& source, const MeasuresRequest& request, Progress& progress);

/// A document's text, to be read with other values.
struct SweepSource {
  std::string text;
  std::string file;  ///< absolute
  std::string root;
  std::string models;
  double time = 0;  ///< seconds, of the document
};

/// Keeps what the values of a sweep share. One thread at a time calls it.
class SweepMaker {
 public:
  /// A list with an object per value: {"value", "measures"}, or {"value", "faults"} where the document has some with
  /// it. Throws Cancelled.
  Value make(const SweepSource& source, const SweepRequest& request, const Registry& registry, JobNews& news);

 private:
  Value one(const SweepSource& source, const SweepRequest& request, double value, const Registry& registry,
            Progress& progress);

  ReadStore store_;
  GrowthCache cache_;
};

}  // namespace meristem::studio
