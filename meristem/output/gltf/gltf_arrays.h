// SPDX-License-Identifier: Apache-2.0
// Writes the arrays of a binary glTF.
#pragma once

#include "meristem/base/atomic_file.h"
#include "meristem/base/progress.h"
#include "meristem/output/gltf/gltf_layout.h"

namespace meristem {

/// Returns the number of elements that write_gltf_arrays() counts as progress.
std::uint64_t gltf_element_count(const GltfLayout& layout);

/// Appends all arrays and pictures of `layout` to `file`, in their order. Throws MachineError, Cancelled.
void write_gltf_arrays(const GltfLayout& layout, AtomicFile& file, Progress& progress);

/// Appends copies of `with` until `bytes` becomes a multiple of 4.
void pad_gltf(AtomicFile& file, std::uint64_t bytes, char with);

}  // namespace meristem
