// SPDX-License-Identifier: Apache-2.0
// Writes the MTL of an OBJ and its pictures. Each picture is written once, named by the first material that has the
// texture.
//
// Based on: Wavefront Technologies, Advanced Visualizer manual, appendix B1 (1995), MTL; `Pr`, `Pm` and `norm` from its
// physically based extension (Exocortex, 2013), `Ns` from `Pr` as Blender does.
#include "meristem/output/mesh/obj_materials.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/output/write/names.h"

namespace meristem {

namespace {

std::vector<bool> materials_in_use(const MeshScene& scene) {
  std::vector<bool> is_used(scene.materials.size(), false);
  for (const MeshInstances& instances : scene.meshes) is_used[instances.material] = true;
  return is_used;
}

/// A texture and the paths of its pictures. A path is empty if the texture has no such picture.
struct Pictures {
  const Texture* texture = nullptr;
  bool owns = false;  // true if this material is the first with the texture, and therefore names the pictures
  std::string colour, normals, mask;
};

/// Returns the pictures of each material. The first material with a texture names the pictures of the texture.
std::vector<Pictures> pictures_of(const MeshScene& scene, const std::string& obj_path) {
  std::vector<std::string> words;
  for (const Material& material : scene.materials) words.push_back(file_word(material.name));
  words = distinct_words(words);
  const std::vector<bool> is_used = materials_in_use(scene);
  std::map<const Texture*, std::size_t> first;  // only for lookup, never iterated, since addresses have no stable order
  std::vector<Pictures> pictures(scene.materials.size());
  for (std::size_t m = 0; m < pictures.size(); ++m) {
    const Texture* texture = scene.materials[m].texture.get();
    if (texture == nullptr || !is_used[m]) continue;
    const std::size_t owner = first.try_emplace(texture, m).first->second;
    const auto [colour, normals, mask] = picture_paths(obj_path, words[owner]);
    pictures[m].texture = texture;
    pictures[m].owns = owner == m;
    if (!texture->colour.is_empty()) pictures[m].colour = colour;
    if (texture->has_normals()) pictures[m].normals = normals;
    if (!texture->colour.is_empty() && texture->masked) pictures[m].mask = mask;
  }
  return pictures;
}

/// Writes each picture once, in the order of the materials.
void write_pictures(const std::vector<Pictures>& of_materials, EncodedPictures& known, const Progress& progress) {
  std::vector<std::string> paths;
  std::vector<TexturePicture> pictures;
  const auto add = [&](const std::string& path, const Texture* texture, TexturePicture::Kind kind) {
    if (path.empty()) return;
    paths.push_back(path);
    pictures.push_back({texture, kind});
  };
  for (const Pictures& material : of_materials) {
    if (!material.owns) continue;
    add(material.colour, material.texture, TexturePicture::Kind::colour);
    add(material.normals, material.texture, TexturePicture::Kind::normals);
    add(material.mask, material.texture, TexturePicture::Kind::mask);
  }
  const auto bytes = known.encode(pictures, progress);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    AtomicFile file(paths[k]);
    file.write(*bytes[k]);
    file.commit();
  }
}

std::string name_in(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// Blender computes the roughness as 1 - sqrt(Ns / 1000) if it does not know `Pr`.
float shininess(float roughness) { return 1000 * (1 - roughness) * (1 - roughness); }

std::string material_lines(const Material& material, const ColourFactors& factors, const Pictures& pictures,
                           const std::string& name) {
  const Vec3 colour = factors.base;
  std::string text = fmt::format("\nnewmtl {}\nKd {} {} {}\nNs {:.4g}\nPr {}\nPm 0\nd {}\n", name, colour.r, colour.g,
                                 colour.b, shininess(material.roughness), material.roughness, material.opacity);
  if (!pictures.colour.empty()) text += fmt::format("map_Kd {}\n", name_in(pictures.colour));
  if (!pictures.mask.empty()) text += fmt::format("map_d {}\n", name_in(pictures.mask));
  // Blender reads the normal map from `map_Bump`, and three.js from `norm`.
  if (!pictures.normals.empty()) text += fmt::format("map_Bump {0}\nnorm {0}\n", name_in(pictures.normals));
  return text;
}

}  // namespace

void write_companions(const MeshScene& scene, const std::vector<ColourFactors>& factors,
                      const std::vector<std::string>& names, const std::string& obj_path, const ObjOptions& options,
                      Progress& progress) {
  const std::vector<Pictures> of_materials = pictures_of(scene, obj_path);
  EncodedPictures own;
  write_pictures(of_materials, options.pictures != nullptr ? *options.pictures : own, progress);
  AtomicFile materials(material_path(obj_path));
  for (const std::string& line : provenance_lines(options.provenance)) materials.write("# " + line + "\n");
  const std::vector<bool> is_used = materials_in_use(scene);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (is_used[m]) materials.write(material_lines(scene.materials[m], factors[m], of_materials[m], names[m]));
  }
  materials.commit();
}

}  // namespace meristem
