// SPDX-License-Identifier: Apache-2.0
// Based on: Wavefront Technologies, Advanced Visualizer manual, appendix B1 (1995), MTL; `Pr`, `Pm` and `norm` from its
// physically based extension (Exocortex, 2013), `Ns` from `Pr` as Blender does.
#include "meristem/output/mesh/obj_materials.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "meristem/base/parallel.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/write/names.h"
#include "meristem/output/write/png.h"

namespace meristem {

namespace {

std::vector<bool> materials_in_use(const MeshScene& scene) {
  std::vector<bool> is_used(scene.materials.size(), false);
  for (const MeshInstances& instances : scene.meshes) is_used[instances.material] = true;
  return is_used;
}

/// A texture and the paths of its pictures, empty where it has none of that kind.
struct Pictures {
  const Texture* texture = nullptr;
  bool owns = false;  // the pictures are named by this material, the first that has the texture
  std::string colour, normals, mask;
};

/// One picture of a texture as a file.
struct Picture {
  std::string path;
  const Texture* texture = nullptr;
  enum class Kind { colour, normals, mask } kind = Kind::colour;
  std::string png;
};

/// The alpha of a picture in all four channels: some readers look for a mask in the alpha of its picture, others in its
/// green.
Image mask_of(const Image& colour) {
  Image mask = colour;
  for (std::size_t i = 0; i < mask.rgba.size(); i += 4) {
    std::fill_n(mask.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, mask.rgba[i + 3]);
  }
  return mask;
}

std::string encoded(const Picture& picture) {
  switch (picture.kind) {
    case Picture::Kind::colour:
      return encode_png(picture.texture->colour, PixelKind::srgb);
    case Picture::Kind::normals:
      return encode_png(picture.texture->normals, PixelKind::numbers);
    case Picture::Kind::mask:
      return encode_png(mask_of(picture.texture->colour), PixelKind::numbers);
  }
  return {};
}

/// The pictures of each material, those of a shared texture named by the first material that has it.
std::vector<Pictures> pictures_of(const MeshScene& scene, const std::string& obj_path) {
  std::vector<std::string> words;
  for (const Material& material : scene.materials) words.push_back(file_word(material.name));
  words = distinct_words(words);
  const std::vector<bool> is_used = materials_in_use(scene);
  std::map<const Texture*, std::size_t> first;  // only looked up, never walked: addresses have no order to rely on
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

/// Each picture once, encoded.
std::vector<Picture> encode_pictures(const std::vector<Pictures>& of_materials, Progress& progress) {
  std::vector<Picture> pictures;
  const auto add = [&](const std::string& path, const Texture* texture, Picture::Kind kind) {
    if (!path.empty()) pictures.push_back({path, texture, kind, {}});
  };
  for (const Pictures& material : of_materials) {
    if (!material.owns) continue;
    add(material.colour, material.texture, Picture::Kind::colour);
    add(material.normals, material.texture, Picture::Kind::normals);
    add(material.mask, material.texture, Picture::Kind::mask);
  }
  parallel_for(pictures.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      progress.check();
      pictures[k].png = encoded(pictures[k]);
    }
  });
  return pictures;
}

std::string name_in(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// Blender reads a roughness of 1 - sqrt(Ns / 1000) where it does not know `Pr`.
float shininess(float roughness) { return 1000 * (1 - roughness) * (1 - roughness); }

std::string material_lines(const Material& material, const ColourFactors& factors, const Pictures& pictures,
                           const std::string& name) {
  const Vec3 colour = factors.base;
  std::string text = fmt::format("\nnewmtl {}\nKd {} {} {}\nNs {:.4g}\nPr {}\nPm 0\nd 1\n", name, colour.r, colour.g,
                                 colour.b, shininess(material.roughness), material.roughness);
  if (!pictures.colour.empty()) text += fmt::format("map_Kd {}\n", name_in(pictures.colour));
  if (!pictures.mask.empty()) text += fmt::format("map_d {}\n", name_in(pictures.mask));
  // Blender takes a normal map from the one, three.js from the other.
  if (!pictures.normals.empty()) text += fmt::format("map_Bump {0}\nnorm {0}\n", name_in(pictures.normals));
  return text;
}

}  // namespace

ObjCompanions::ObjCompanions(const MeshScene& scene, const std::vector<ColourFactors>& factors,
                             const std::vector<std::string>& names, const std::string& obj_path,
                             const Provenance& provenance, Progress& progress) {
  const std::vector<Pictures> of_materials = pictures_of(scene, obj_path);
  for (const Picture& picture : encode_pictures(of_materials, progress)) {
    files_.emplace_back(picture.path).write(picture.png);
  }
  AtomicFile& materials = files_.emplace_back(material_path(obj_path));
  for (const std::string& line : provenance_lines(provenance)) materials.write("# " + line + "\n");
  const std::vector<bool> is_used = materials_in_use(scene);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (is_used[m]) materials.write(material_lines(scene.materials[m], factors[m], of_materials[m], names[m]));
  }
}

void ObjCompanions::close() {
  for (AtomicFile& file : files_) file.close();
}

void ObjCompanions::commit() {
  for (AtomicFile& file : files_) file.commit();
}

}  // namespace meristem
