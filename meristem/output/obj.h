// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/output/provenance.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

struct ObjOptions {
  Provenance provenance;
};

/// Writes `scene` as Wavefront OBJ to `path`: metres, y up, v upward; one object and group a component, by its id;
/// instances flattened; every number with the digits that give the same float when read. Beside it goes an MTL file of
/// the name that material_path() tells, with the materials in use: `Kd` is linear light as in glTF, `Pr` the roughness.
/// In names, what would end a word is `_`, and names that would be alike are numbered.
///
/// Streams: memory beyond the scene stays below 64 MB. Both files are on the disk before the first is put in place, the
/// MTL file before the OBJ; only if the last step, the renaming of the OBJ, is refused, a new MTL file stays behind.
/// Where `path` is standard output ("-"), a device or a pipe, there is no MTL file, and material names remain as
/// labels. Throws MachineError (path, disk), Cancelled.
void write_obj(const MeshScene& scene, const std::string& path, const ObjOptions& options, Progress& progress);

/// The MTL file beside an OBJ: `dir/oak.mtl` for `dir/oak.obj`. Spaces become `_`, since no two readers agree on how an
/// OBJ names a file with spaces.
std::string material_path(const std::string& obj_path);

}  // namespace meristem
