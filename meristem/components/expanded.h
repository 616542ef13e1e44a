// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// The operations that the training of a self-organizing tree stands for, as a document writes them; null for other
/// components and without a training.
Value expanded_training(const Prototype& component);

/// The iteration after whose growth the last operations of a self-organizing tree act; nothing for other components.
std::optional<int> last_iteration(const Prototype& component);

}  // namespace meristem
