// SPDX-License-Identifier: Apache-2.0
// The files beside an OBJ: its MTL and the pictures that this one names.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "meristem/base/atomic_file.h"
#include "meristem/base/progress.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/write/colour_factors.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Files that are written now and put in place together, later.
class ObjCompanions {
 public:
  /// Writes the MTL and the pictures of the materials in use; `names` are the materials' in the OBJ.
  ObjCompanions(const MeshScene& scene, const std::vector<ColourFactors>& factors,
                const std::vector<std::string>& names, const std::string& obj_path, const ObjOptions& options,
                Progress& progress);

  /// Ends the writing; only renaming is left for commit().
  void close();
  /// Puts the pictures in place, then the MTL.
  void commit();

 private:
  std::deque<AtomicFile> files_;
};

}  // namespace meristem
