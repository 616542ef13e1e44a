// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/output/write/encoded_pictures.h"
#include "meristem/output/write/provenance.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Options of an OBJ file.
struct ObjOptions {
  Provenance provenance;                ///< written as comments
  EncodedPictures* pictures = nullptr;  ///< shared with other files; may be null
};

/// Writes `scene` as Wavefront OBJ to `path`, in metres, y up, v upward. Each component is one object and group with
/// its id, its crown bodies are another one (object_name), and instances are flattened. Faces of flat shaded meshes
/// share positions and have one normal each. Numbers have enough digits to restore the exact float. The MTL file with
/// the materials in use is written to material_path(), and their pictures as PNG to picture_paths(). `Kd` is linear
/// light as in glTF, and `Pr` is the roughness. If instances of a component have tints, each vertex has an sRGB colour
/// behind its position, which readers multiply with `Kd` and the picture. Characters in names that would end a word
/// become
/// `_`, and equal names are numbered.
///
/// Streams: memory beyond the scene, the pictures' files and 8 bytes per vertex of flat shaded meshes stays below 64
/// MB. The files appear together (FileSet), the OBJ last. If `path` is standard output ("-"), a device or a pipe, there
/// are no other files, and material names remain as labels. Throws MachineError (path, disk), Cancelled.
void write_obj(const MeshScene& scene, const std::string& path, const ObjOptions& options, Progress& progress);

/// Returns the path of the MTL file of an OBJ: `dir/oak.mtl` for `dir/oak.obj`. Spaces become `_`, since readers
/// disagree on how an OBJ names a file with spaces.
std::string material_path(const std::string& obj_path);

/// Returns the paths of an OBJ's pictures for a material of that name, if its texture has all of them:
/// `dir/oak_leaf_colour.png`, `dir/oak_leaf_normals.png` and `dir/oak_leaf_mask.png`.
std::array<std::string, 3> picture_paths(const std::string& obj_path, const std::string& material);

}  // namespace meristem
