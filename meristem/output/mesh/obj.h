// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/output/write/encoded_pictures.h"
#include "meristem/output/write/provenance.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// What the head of the file says.
struct ObjOptions {
  Provenance provenance;                ///< written as comments
  EncodedPictures* pictures = nullptr;  ///< shared with other files; may be null
};

/// Writes `scene` as Wavefront OBJ to `path`: metres, y up, v upward; one object and group a component, by its id;
/// instances flattened; every number with the digits that give the same float when read. Beside it go an MTL file of
/// the name that material_path() tells, with the materials in use, and their pictures as PNG, as picture_paths() tells.
/// `Kd` is linear light as in glTF, `Pr` the roughness. Vertices of components whose instances have tints carry them
/// behind their position as sRGB colours, to be multiplied with `Kd` and the picture.
/// In names, what would end a word is `_`, and names that would be alike are numbered.
///
/// Streams: memory beyond the scene and the pictures' files stays below 64 MB. The files appear together (FileSet), the
/// OBJ last. Where `path` is
/// standard output ("-"), a device or a pipe, there are no other files, and material names remain as labels.
/// Throws MachineError (path, disk), Cancelled.
void write_obj(const MeshScene& scene, const std::string& path, const ObjOptions& options, Progress& progress);

/// The MTL file beside an OBJ: `dir/oak.mtl` for `dir/oak.obj`. Spaces become `_`, since no two readers agree on how an
/// OBJ names a file with spaces.
std::string material_path(const std::string& obj_path);

/// The pictures beside an OBJ for a material of that name, if it has a texture with all of them:
/// `dir/oak_leaf_colour.png`, `dir/oak_leaf_normals.png` and `dir/oak_leaf_mask.png`.
std::array<std::string, 3> picture_paths(const std::string& obj_path, const std::string& material);

}  // namespace meristem
