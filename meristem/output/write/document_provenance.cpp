// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/document_provenance.h"

#include <string>

#include "meristem/base/version.h"

namespace meristem {

Provenance provenance_of(const Document& document) {
  return {.name = document.name,
          .author = document.author,
          .licence = document.licence,
          .seed = document.graph.seed,
          .version = std::string(version()),
          .sets = document.source.sets};
}

}  // namespace meristem
