// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Returns the operations of a self-organizing tree's training in the form of a document. Null for other components and
/// without a training.
Value expanded_training(const Prototype& component);

/// Returns the last iteration of a self-organizing tree, after which its last operations act. Returns nothing for other
/// components.
std::optional<int> last_iteration(const Prototype& component);

}  // namespace meristem
