// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/graph/component.h"

namespace meristem::cli {

/// Returns the manual's page of all parameters of documents and components, in Markdown, made from their tables.
std::string reference_page(const Registry& registry);

}  // namespace meristem::cli
