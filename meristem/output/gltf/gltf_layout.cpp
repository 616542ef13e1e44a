// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/gltf/gltf_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "meristem/base/parallel.h"
#include "meristem/output/gltf/palette.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/encoded_pictures.h"

namespace meristem {

namespace {

const Frame kIdentity[1] = {Frame{}};
const Frame kMirror[1] = {Frame{Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3(0)}};

constexpr std::size_t kVerticesPerBlock = 1 << 15;

/// Materials that stand for the tints of instances where those are nodes.
constexpr std::size_t kPaletteColours = 8;

class LayoutBuilder {
 public:
  LayoutBuilder(const MeshScene& scene, const GltfOptions& options) : scene_(scene) {
    const bool is_large = scene.triangle_count() > options.flatten_triangles;
    bakes_all_ = !is_large && options.instances != GltfInstances::rows;
    layout_.has_instance_rows = !bakes_all_ && options.instances != GltfInstances::nodes;
    layout_.factors = colour_factors(scene);
  }

  GltfLayout build() {
    std::map<std::string_view, std::size_t> component_indices;
    if (!bakes_all_ && !layout_.has_instance_rows) make_palettes();
    for (std::size_t k = 0; k < scene_.meshes.size(); ++k) {
      const MeshInstances& instances = scene_.meshes[k];
      if (instances.triangle_count() == 0) continue;
      const auto [entry, is_new] = component_indices.try_emplace(instances.component, layout_.components.size());
      if (is_new) layout_.components.push_back({instances.component, GltfComponent::kNoMesh, {}});
      if (bakes_all_ || instances.frames.size() == 1) {
        bake(entry->second, instances, {instances.mesh.get(), instances.frames, instances.tints});
      } else {
        share(entry->second, k);
      }
    }
    add_textures();
    return std::move(layout_);
  }

 private:
  static constexpr std::size_t kNone = SIZE_MAX;

  /// Brings the tints of each material's instances down to a few.
  void make_palettes() {
    palettes_.resize(scene_.materials.size());
    std::vector<std::vector<Vec3>> tints(scene_.materials.size());
    for (const MeshInstances& instances : scene_.meshes) {
      std::vector<Vec3>& of_material = tints[instances.material];
      first_tint_.push_back(of_material.size());
      if (!layout_.factors[instances.material].varies) continue;
      for (std::size_t i = 0; i < instances.frames.size(); ++i) of_material.push_back(instances.tint(i));
    }
    for (std::size_t m = 0; m < tints.size(); ++m) palettes_[m] = make_palette(tints[m], kPaletteColours);
  }

  /// The material of a mesh for its instances of one colour of the palette, or of all colours (kNone).
  std::size_t material_of(const MeshInstances& instances, std::size_t colour) {
    const std::uint32_t source = instances.material;
    const Material& material = scene_.materials[source];
    const Texture* texture = instances.mesh->uvs.empty() ? nullptr : material.texture.get();
    const auto [entry, is_new] =
        material_indices_.try_emplace(std::tuple(source, colour, texture != nullptr), layout_.materials.size());
    if (!is_new) return entry->second;
    const ColourFactors& factors = layout_.factors[source];
    GltfMaterial made{material.name, source, texture, factors.base, factors.mean};
    if (colour != kNone) {
      made.name += fmt::format(" {}", colour + 1);
      made.base = glm::min(factors.material * palettes_[source].colours[colour], Vec3(1));
      made.transmitted = made.base;
    }
    if (material.texture.get() != texture) {
      made.base *= material.texture->mean;
      made.transmitted *= material.texture->mean;
    }
    layout_.materials.push_back(std::move(made));
    return entry->second;
  }

  GltfAttributes attributes_of(const Mesh& mesh, std::size_t material, bool has_colours) const {
    const Texture* texture = layout_.materials[material].texture;
    const bool wants_tangents = texture != nullptr && texture->has_normals();
    return {.normals = !mesh.normals.empty(),
            .uvs = !mesh.uvs.empty(),
            .tangents = wants_tangents && !mesh.tangents.empty() && !mesh.normals.empty(),
            .colours = has_colours};
  }

  /// Adds a piece to the mesh's primitive of the same material and attributes, or to a new one.
  void add_piece(GltfMesh& mesh, std::size_t material, const GltfPiece& piece, bool has_colours) {
    const GltfAttributes has = attributes_of(*piece.mesh, material, has_colours);
    const auto fits = [&](const GltfPrimitive& primitive) {
      return primitive.material == material && primitive.has == has;
    };
    auto primitive = std::find_if(mesh.primitives.begin(), mesh.primitives.end(), fits);
    if (primitive == mesh.primitives.end()) {
      GltfPrimitive fresh;
      fresh.material = material;
      fresh.has = has;
      primitive = mesh.primitives.insert(mesh.primitives.end(), std::move(fresh));
    }
    primitive->vertices += piece.vertex_count();
    primitive->triangles += piece.triangle_count();
    primitive->pieces.push_back(piece);
  }

  void bake(std::size_t component, const MeshInstances& instances, const GltfPiece& piece) {
    std::size_t& mesh = layout_.components[component].baked_mesh;
    if (mesh == GltfComponent::kNoMesh) {
      mesh = layout_.meshes.size();
      layout_.meshes.push_back({instances.component, {}});
    }
    const std::size_t material = material_of(instances, kNone);
    add_piece(layout_.meshes[mesh], material, piece, layout_.factors[instances.material].varies);
  }

  /// Adds the scene's mesh number `k`, all of whose instances share it but for those that cannot.
  void share(std::size_t component, std::size_t k) {
    const MeshInstances& instances = scene_.meshes[k];
    // Sort instances into those of each colour, or the plain and the mirrored ones.
    std::vector<std::vector<std::uint32_t>> groups(std::max<std::size_t>(2, kPaletteColours));
    std::vector<Frame> inexpressible;
    std::vector<Vec3> inexpressible_tints;
    for (std::size_t i = 0; i < instances.frames.size(); ++i) {
      if (is_expressible_as_node(instances.frames[i])) {
        groups[group_of(k, i)].push_back(static_cast<std::uint32_t>(i));
      } else {
        inexpressible.push_back(instances.frames[i]);
        inexpressible_tints.push_back(instances.tint(i));
      }
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (!groups[g].empty()) add_shared(component, instances, g, std::move(groups[g]));
    }
    if (inexpressible.empty()) return;
    layout_.inexpressible_frames.push_back(std::move(inexpressible));
    layout_.inexpressible_tints.push_back(std::move(inexpressible_tints));
    bake(component, instances,
         {instances.mesh.get(), layout_.inexpressible_frames.back(), layout_.inexpressible_tints.back()});
  }

  std::size_t group_of(std::size_t k, std::size_t instance) const {
    const MeshInstances& instances = scene_.meshes[k];
    if (layout_.has_instance_rows) return is_mirrored(instances.frames[instance]) ? 1 : 0;
    const Palette& palette = palettes_[instances.material];
    return palette.colours.empty() ? 0 : palette.of[first_tint_[k] + instance];
  }

  void add_shared(std::size_t component, const MeshInstances& instances, std::size_t group,
                  std::vector<std::uint32_t> members) {
    const bool is_mirrored = layout_.has_instance_rows && group == 1;
    const bool has_palette = !layout_.has_instance_rows && !palettes_[instances.material].colours.empty();
    const std::size_t material = material_of(instances, has_palette ? group : kNone);
    layout_.meshes.push_back({instances.component, {}});
    add_piece(layout_.meshes.back(), material, {instances.mesh.get(), is_mirrored ? kMirror : kIdentity, {}}, false);
    GltfSharedMesh shared;
    shared.mesh = layout_.meshes.size() - 1;
    shared.source = &instances;
    shared.instances = std::move(members);
    shared.is_mirrored = is_mirrored;
    layout_.components[component].shared.push_back(std::move(shared));
  }

  /// Adds the textures of the materials in use, each once.
  void add_textures() {
    for (const GltfMaterial& material : layout_.materials) {
      const Texture* source = material.texture;
      const auto is_it = [&](const GltfTexture& texture) { return texture.source == source; };
      if (source == nullptr || std::any_of(layout_.textures.begin(), layout_.textures.end(), is_it)) continue;
      GltfTexture texture;
      texture.source = source;
      if (!source->colour.is_empty()) texture.colour = add_image(material.name + " colour");
      if (source->has_normals()) texture.normals = add_image(material.name + " normals");
      layout_.textures.push_back(texture);
    }
  }

  std::size_t add_image(std::string name) {
    layout_.images.push_back({std::move(name), nullptr, {}});
    return layout_.images.size() - 1;
  }

  const MeshScene& scene_;
  bool bakes_all_ = false;
  GltfLayout layout_;
  std::vector<Palette> palettes_;        // of each of the scene's materials
  std::vector<std::size_t> first_tint_;  // of each of the scene's meshes in its palette
  std::map<std::tuple<std::uint32_t, std::size_t, bool>, std::size_t> material_indices_;
};

/// Makes the files of all pictures, but those that have been made before.
void encode_images(GltfLayout& layout, EncodedPictures* known, const Progress& progress) {
  std::vector<TexturePicture> pictures(layout.images.size());
  for (const GltfTexture& texture : layout.textures) {
    using Kind = TexturePicture::Kind;
    if (texture.colour != GltfTexture::kNoImage) pictures[texture.colour] = {texture.source, Kind::colour};
    if (texture.normals != GltfTexture::kNoImage) pictures[texture.normals] = {texture.source, Kind::normals};
  }
  EncodedPictures own;
  const auto files = (known != nullptr ? *known : own).encode(pictures, progress);
  for (std::size_t k = 0; k < files.size(); ++k) layout.images[k].png = files[k];
}

/// Takes the next `bytes` of the binary chunk; every array begins at a multiple of 4.
GltfRange take(GltfLayout& layout, std::uint64_t bytes) {
  const GltfRange range{layout.binary_bytes, bytes};
  layout.binary_bytes += (bytes + 3) / 4 * 4;
  return range;
}

void place_arrays(GltfLayout& layout) {
  for (GltfMesh& mesh : layout.meshes) {
    for (GltfPrimitive& primitive : mesh.primitives) {
      const auto vertices = [&](bool has, std::size_t bytes) {
        return has ? take(layout, primitive.vertices * bytes) : GltfRange{};
      };
      primitive.index_range = take(layout, primitive.triangles * (primitive.has_wide_indices() ? 12 : 6));
      primitive.position_range = vertices(true, sizeof(Vec3));
      primitive.normal_range = vertices(primitive.has.normals, sizeof(Vec3));
      primitive.tangent_range = vertices(primitive.has.tangents, sizeof(Vec4));
      primitive.uv_range = vertices(primitive.has.uvs, sizeof(Vec2));
      primitive.colour_range = vertices(primitive.has.colours, 4);
    }
  }
  if (layout.has_instance_rows) {
    for (GltfComponent& component : layout.components) {
      for (GltfSharedMesh& shared : component.shared) {
        const std::uint64_t rows = shared.instances.size();
        shared.translation_range = take(layout, rows * sizeof(Vec3));
        shared.rotation_range = take(layout, rows * sizeof(Vec4));
        shared.scale_range = take(layout, rows * sizeof(Vec3));
        if (layout.factors[shared.source->material].varies) shared.colour_range = take(layout, rows * 4);
      }
    }
  }
  for (GltfImage& image : layout.images) image.range = take(layout, image.png->size());
}

Box bounds_of(const GltfPiece& piece, Progress& progress) {
  const std::size_t vertices = piece.mesh->vertex_count();
  const std::size_t elements = piece.frames.size() * vertices;
  std::vector<Box> boxes((elements + kVerticesPerBlock - 1) / kVerticesPerBlock);
  parallel_for(elements, kVerticesPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Box& box = boxes[begin / kVerticesPerBlock];
    for_each_run(begin, end, vertices, [&](std::size_t frame, std::size_t first, std::size_t last) {
      const Frame& place = piece.frames[frame];
      for (std::size_t v = first; v < last; ++v) box.add(place.point(piece.mesh->positions[v]));
    });
  });
  Box all;
  for (const Box& box : boxes) all.add(box);
  return all;
}

}  // namespace

Frame GltfSharedMesh::frame(std::size_t row) const {
  const Frame& place = source->frames[instances[row]];
  return is_mirrored ? place * kMirror[0] : place;
}

bool is_expressible_as_node(const Frame& frame) {
  const Mat3& axes = frame.axes;
  const float x = glm::length(axes[0]);
  const float y = glm::length(axes[1]);
  const float z = glm::length(axes[2]);
  constexpr float kFlat = 1e-12F;
  if (!(x > kFlat && y > kFlat && z > kFlat)) return false;
  // Products of float rotations drift by about 1e-6; a shear that anybody meant is larger.
  constexpr float kShear = 4e-6F;
  return std::abs(glm::dot(axes[0], axes[1])) <= kShear * x * y &&
         std::abs(glm::dot(axes[1], axes[2])) <= kShear * y * z &&
         std::abs(glm::dot(axes[2], axes[0])) <= kShear * z * x;
}

GltfLayout lay_out_gltf(const MeshScene& scene, const GltfOptions& options, Progress& progress) {
  GltfLayout layout = LayoutBuilder(scene, options).build();
  encode_images(layout, options.pictures, progress);
  place_arrays(layout);
  return layout;
}

void measure_bounds(GltfLayout& layout, Progress& progress) {
  for (GltfMesh& mesh : layout.meshes) {
    for (GltfPrimitive& primitive : mesh.primitives) {
      for (const GltfPiece& piece : primitive.pieces) primitive.bounds.add(bounds_of(piece, progress));
    }
  }
}

}  // namespace meristem
