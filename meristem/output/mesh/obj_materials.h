// SPDX-License-Identifier: Apache-2.0
// The files beside an OBJ: the MTL and the pictures that it names.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/write/colour_factors.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Writes the pictures of the materials in use, then the MTL of an OBJ. `names` are the names of the materials in the
/// OBJ. Throws MachineError, Cancelled.
void write_companions(const MeshScene& scene, const std::vector<ColourFactors>& factors,
                      const std::vector<std::string>& names, const std::string& obj_path, const ObjOptions& options,
                      Progress& progress);

}  // namespace meristem
