// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// The operations that the training of a self-organizing tree stands for, as a document writes them; null for other
/// components and without a training.
Value expanded_training(const Prototype& component);

}  // namespace meristem
