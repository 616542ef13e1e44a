// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/document/document.h"
#include "meristem/output/write/provenance.h"

namespace meristem {

/// What files say of the document that they were made of.
Provenance provenance_of(const Document& document);

}  // namespace meristem
