// SPDX-License-Identifier: Apache-2.0
// The files beside an OBJ: its MTL and the pictures that this one names.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/write/colour_factors.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Writes the MTL beside an OBJ and the pictures of the materials in use, the pictures first; `names` are the
/// materials' in the OBJ. Throws MachineError, Cancelled.
void write_companions(const MeshScene& scene, const std::vector<ColourFactors>& factors,
                      const std::vector<std::string>& names, const std::string& obj_path, const ObjOptions& options,
                      Progress& progress);

}  // namespace meristem
