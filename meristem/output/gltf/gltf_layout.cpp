// SPDX-License-Identifier: Apache-2.0
// Lays out a binary glTF. The instances of each mesh are divided among plants and components, then baked, shared or
// animated. Byte ranges are assigned in writing order.
#include "meristem/output/gltf/gltf_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "meristem/base/parallel.h"
#include "meristem/output/gltf/gltf_tracks.h"
#include "meristem/output/gltf/palette.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/encoded_pictures.h"

namespace meristem {

namespace {

const Frame kIdentity[1] = {Frame{}};
const Frame kMirror[1] = {Frame{Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3(0)}};

constexpr std::size_t kVerticesPerBlock = 1 << 15;

/// Number of materials that approximate the tints of instances if instances are nodes.
constexpr std::size_t kPaletteColours = 8;

class LayoutBuilder {
 public:
  LayoutBuilder(const MovingScene& moving, const Progress& progress)
      : scene_(moving.scene), progress_(progress), moving_(&moving) {
    bakes_all_ = true;
    layout_.factors = colour_factors(moving);
  }
  LayoutBuilder(const MeshScene& scene, const GltfOptions& options, const Progress& progress)
      : scene_(scene), progress_(progress) {
    const bool is_large = scene.triangle_count() > options.flatten_triangles;
    bakes_all_ = !is_large && options.instances != GltfInstances::rows;
    layout_.has_instance_rows = !bakes_all_ && options.instances != GltfInstances::nodes;
    layout_.factors = colour_factors(scene);
  }

  GltfLayout build() {
    if (moving_ != nullptr || (!bakes_all_ && !layout_.has_instance_rows)) make_palettes();
    add_plants();
    for (std::size_t k = 0; k < scene_.meshes.size(); ++k) {
      progress_.check();
      if (scene_.meshes[k].triangle_count() == 0 || scene_.meshes[k].places != nullptr) continue;
      if (layout_.plants.empty()) {
        add(GltfComponent::kNoPlant, k, {});
      } else {
        add_to_plants(k);
      }
    }
    std::ranges::stable_sort(layout_.components, {}, &GltfComponent::plant);
    add_placed_plants();
    add_textures();
    if (moving_ != nullptr) add_tracks(moving_->times, layout_, progress_);
    return std::move(layout_);
  }

 private:
  static constexpr std::size_t kNone = SIZE_MAX;

  /// Makes a node for each visible plant if there are several, but not too many.
  void add_plants() {
    plant_of_individual_.assign(scene_.individuals.size(), GltfComponent::kNoPlant);
    std::vector<std::uint8_t> is_seen(scene_.individuals.size(), 0);
    for (const MeshInstances& instances : scene_.meshes) {
      if (instances.triangle_count() == 0 || instances.places != nullptr) continue;
      for (std::size_t i = 0; i < instances.frames.size(); ++i) {
        if (instances.individual(i) < is_seen.size()) is_seen[instances.individual(i)] = 1;
      }
    }
    const auto count = static_cast<std::size_t>(std::ranges::count(is_seen, 1));
    if (count < 2 || count > (bakes_all_ ? kMaxGltfPlants : kMaxInstancedGltfPlants)) return;
    for (std::size_t k = 0; k < is_seen.size(); ++k) {
      if (is_seen[k] == 0) continue;
      const Individual& individual = scene_.individuals[k];
      plant_of_individual_[k] = layout_.plants.size();
      layout_.plants.push_back({fmt::format("{} {}", individual.component, individual.number), individual.foot});
    }
  }

  std::size_t plant_of(std::uint32_t individual) const {
    return individual < plant_of_individual_.size() ? plant_of_individual_[individual] : GltfComponent::kNoPlant;
  }

  /// Divides the instances of the scene's mesh number `k` among the plants.
  void add_to_plants(std::size_t k) {
    const MeshInstances& instances = scene_.meshes[k];
    if (instances.individuals.empty()) return add(plant_of(0), k, {});
    std::map<std::size_t, std::vector<std::uint32_t>> members;  // for each plant
    std::size_t last = SIZE_MAX;
    std::vector<std::uint32_t>* of_last = nullptr;
    for (std::uint32_t i = 0; i < instances.frames.size(); ++i) {
      const std::size_t plant = plant_of(instances.individuals[i]);
      if (of_last == nullptr || plant != last) of_last = &members[plant];
      last = plant;
      of_last->push_back(i);
    }
    for (auto& [plant, of_plant] : members) {
      layout_.members.push_back(std::move(of_plant));
      add(plant, k, layout_.members.back());
    }
  }

  /// Adds instances of the scene's mesh number `k` to a plant: `members`, or all if `members` is empty.
  void add(std::size_t plant, std::size_t k, std::span<const std::uint32_t> members) {
    const MeshInstances& instances = scene_.meshes[k];
    const auto [entry, is_new] = component_indices_.try_emplace(
        std::tuple(plant, std::string_view(instances.component), instances.is_crown), layout_.components.size());
    if (is_new) layout_.components.push_back({object_name(instances), plant, GltfComponent::kNoMesh, {}});
    const MeshMotion* const motion = moving_ != nullptr ? &moving_->motions[k] : nullptr;
    if (motion != nullptr && motion->kind != MeshMotion::Kind::still) {
      move(entry->second, k, *motion, members);
    } else if (bakes_all_ || instances.frames.size() == 1) {
      bake(entry->second, instances, members);
    } else {
      share(entry->second, k, members);
    }
  }

  Vec3 origin_of(std::size_t component) const {
    const std::size_t plant = layout_.components[component].plant;
    return plant == GltfComponent::kNoPlant ? Vec3(0) : layout_.plants[plant].foot;
  }

  /// Lays out the parts of plants that stand in several places, in the order of their first occurrence. Each plant has
  /// its own frame.
  void add_placed_plants() {
    layout_.own_components = layout_.components.size();
    std::map<const std::vector<Frame>*, std::size_t> plant_of_places;
    std::vector<std::vector<std::size_t>> meshes;  // for each plant
    for (std::size_t k = 0; k < scene_.meshes.size(); ++k) {
      const MeshInstances& instances = scene_.meshes[k];
      if (instances.triangle_count() == 0 || instances.places == nullptr) continue;
      const auto [plant, is_new] = plant_of_places.try_emplace(instances.places.get(), layout_.placed.size());
      if (is_new) {
        // "oak.leaf" is the leaf of an oak.
        const std::string name = instances.component.substr(0, instances.component.rfind('.'));
        layout_.placed.push_back({.name = name, .places = instances.places.get()});
        meshes.emplace_back();
      }
      meshes[plant->second].push_back(k);
    }
    for (std::size_t p = 0; p < layout_.placed.size(); ++p) {
      layout_.placed[p].first_component = layout_.components.size();
      std::map<std::pair<std::string_view, bool>, std::size_t> component_indices;
      for (const std::size_t k : meshes[p]) {
        const MeshInstances& instances = scene_.meshes[k];
        const auto [entry, is_new] = component_indices.try_emplace(
            std::pair(std::string_view(instances.component), instances.is_crown), layout_.components.size());
        if (is_new) {
          layout_.components.push_back({object_name(instances), GltfComponent::kNoPlant, GltfComponent::kNoMesh, {}});
        }
        if (layout_.has_instance_rows && instances.frames.size() > 1) {
          share(entry->second, k, {});
        } else {
          bake(entry->second, instances, {});
        }
      }
      layout_.placed[p].end_component = layout_.components.size();
    }
  }

  /// Reduces the tints of each material's instances to a few colours.
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

  /// Returns the material of a mesh for its instances of one colour of the palette, or of all colours (kNone).
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

  /// Adds a piece to the mesh's primitive with equal material and attributes, or to a new primitive.
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
    if (piece.motion == nullptr) return;
    primitive->targets.resize(moving_->times.size() - 1);
    primitive->turns = primitive->turns || (piece.motion->turns && has.normals);
    primitive->changes_colour = primitive->changes_colour || (!piece.motion->tints.empty() && has_colours);
  }

  void bake(std::size_t component, const MeshInstances& instances, std::span<const std::uint32_t> members) {
    const GltfPiece piece{instances.mesh.get(), instances.frames, instances.tints, members, origin_of(component)};
    std::size_t& mesh = layout_.components[component].baked_mesh;
    if (mesh == GltfComponent::kNoMesh) {
      mesh = add_mesh(object_name(instances));
    }
    const std::size_t material = material_of(instances, kNone);
    add_piece(layout_.meshes[mesh], material, piece, layout_.factors[instances.material].varies);
  }

  std::size_t add_mesh(const std::string& name, bool moves = false) {
    layout_.meshes.push_back({.name = name, .moves = moves, .primitives = {}});
    return layout_.meshes.size() - 1;
  }

  /// Adds moving instances of the scene's mesh number `k`.
  void move(std::size_t component, std::size_t k, const MeshMotion& motion, std::span<const std::uint32_t> members) {
    if (motion.kind == MeshMotion::Kind::rigid) return move_nodes(component, k, motion, members);
    const MeshInstances& instances = scene_.meshes[k];
    const bool is_shown = motion.kind == MeshMotion::Kind::shown;
    const std::size_t shown_at = is_shown ? motion.shown_at : GltfMovingMesh::kAlways;
    std::vector<GltfMovingMesh>& moving = layout_.components[component].moving;
    const auto fits = [&](const GltfMovingMesh& known) { return known.shown_at == shown_at; };
    auto found = std::find_if(moving.begin(), moving.end(), fits);
    if (found == moving.end()) {
      found = moving.insert(moving.end(), {add_mesh(object_name(instances), !is_shown), shown_at});
    }
    GltfPiece piece{instances.mesh.get(), instances.frames, instances.tints, members, origin_of(component)};
    if (!is_shown) piece.motion = &motion;
    const std::size_t material = material_of(instances, kNone);
    add_piece(layout_.meshes[found->mesh], material, piece, layout_.factors[instances.material].varies);
  }

  /// Makes each instance a node, grouped by the colours of the palette.
  void move_nodes(std::size_t component, std::size_t k, const MeshMotion& motion,
                  std::span<const std::uint32_t> members) {
    std::vector<std::vector<std::uint32_t>> groups(kPaletteColours);
    const std::size_t count = members.empty() ? scene_.meshes[k].frames.size() : members.size();
    for (std::size_t m = 0; m < count; ++m) {
      const auto i = members.empty() ? static_cast<std::uint32_t>(m) : members[m];
      groups[group_of(k, i)].push_back(i);
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (groups[g].empty()) continue;
      add_shared(component, k, g, std::move(groups[g]));
      layout_.components[component].shared.back().motion = &motion;
    }
  }

  /// Adds instances of the scene's mesh number `k`. They share the mesh, except for instances that cannot.
  void share(std::size_t component, std::size_t k, std::span<const std::uint32_t> members) {
    const MeshInstances& instances = scene_.meshes[k];
    // Sort instances by colour, or into plain and mirrored ones.
    std::vector<std::vector<std::uint32_t>> groups(std::max<std::size_t>(2, kPaletteColours));
    std::vector<std::uint32_t> inexpressible;
    const std::size_t count = members.empty() ? instances.frames.size() : members.size();
    for (std::size_t m = 0; m < count; ++m) {
      const auto i = members.empty() ? static_cast<std::uint32_t>(m) : members[m];
      (is_expressible_as_node(instances.frames[i]) ? groups[group_of(k, i)] : inexpressible).push_back(i);
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (!groups[g].empty()) add_shared(component, k, g, std::move(groups[g]));
    }
    if (inexpressible.empty()) return;
    layout_.members.push_back(std::move(inexpressible));
    bake(component, instances, layout_.members.back());
  }

  std::size_t group_of(std::size_t k, std::size_t instance) const {
    const MeshInstances& instances = scene_.meshes[k];
    if (layout_.has_instance_rows) return is_mirrored(instances.frames[instance]) ? 1 : 0;
    const Palette& palette = palettes_[instances.material];
    return palette.colours.empty() ? 0 : palette.of[first_tint_[k] + instance];
  }

  void add_shared(std::size_t component, std::size_t k, std::size_t group, std::vector<std::uint32_t> members) {
    GltfSharedMesh shared;
    shared.mesh = shared_mesh(k, group);
    shared.source = &scene_.meshes[k];
    shared.instances = std::move(members);
    shared.is_mirrored = is_group_mirrored(group);
    shared.origin = origin_of(component);
    layout_.components[component].shared.push_back(std::move(shared));
  }

  /// Returns the number of the mesh that a group of instances of the scene's mesh number `k` shares, in all plants.
  std::size_t shared_mesh(std::size_t k, std::size_t group) {
    const auto [entry, is_new] = shared_meshes_.try_emplace(std::pair(k, group), layout_.meshes.size());
    if (!is_new) return entry->second;
    const MeshInstances& instances = scene_.meshes[k];
    const bool has_palette = !layout_.has_instance_rows && !palettes_[instances.material].colours.empty();
    const std::size_t material = material_of(instances, has_palette ? group : kNone);
    add_mesh(object_name(instances));
    const std::span<const Frame> frame = is_group_mirrored(group) ? kMirror : kIdentity;
    add_piece(layout_.meshes.back(), material, {instances.mesh.get(), frame, {}, {}, Vec3(0)}, false);
    return entry->second;
  }

  bool is_group_mirrored(std::size_t group) const { return layout_.has_instance_rows && group == 1; }

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
  const Progress& progress_;
  const MovingScene* moving_ = nullptr;
  bool bakes_all_ = false;
  GltfLayout layout_;
  std::vector<std::size_t> plant_of_individual_;
  // Indexed by plant, component, and whether it is a crown body.
  std::map<std::tuple<std::size_t, std::string_view, bool>, std::size_t> component_indices_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> shared_meshes_;  // indexed by mesh of the scene and group
  std::vector<Palette> palettes_;                                             // for each material of the scene
  std::vector<std::size_t> first_tint_;  // for each mesh of the scene, its first tint in the palette
  std::map<std::tuple<std::uint32_t, std::size_t, bool>, std::size_t> material_indices_;
};

/// Encodes all pictures, except pictures that were encoded before.
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

/// Reserves the next `bytes` of the binary chunk. Every array begins at a multiple of 4.
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
      for (GltfTarget& target : primitive.targets) {
        target.position_range = vertices(true, sizeof(Vec3));
        target.normal_range = vertices(primitive.turns, sizeof(Vec3));
        target.colour_range = vertices(primitive.changes_colour, sizeof(Vec4));
      }
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
  layout.animation.range = take(layout, layout.animation.data.size() * sizeof(float));
  for (GltfImage& image : layout.images) image.range = take(layout, image.png->size());
}

Box bounds_of(const GltfPiece& piece, Progress& progress) {
  const std::size_t vertices = piece.mesh->vertex_count();
  const std::size_t elements = piece.count() * vertices;
  std::vector<Box> boxes((elements + kVerticesPerBlock - 1) / kVerticesPerBlock);
  parallel_for(elements, kVerticesPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Box& box = boxes[begin / kVerticesPerBlock];
    for_each_run(begin, end, vertices, [&](std::size_t frame, std::size_t first, std::size_t last) {
      const Frame place = piece.frame(frame);
      for (std::size_t v = first; v < last; ++v) box.add(place.point(piece.mesh->positions[v]));
    });
  });
  Box all;
  for (const Box& box : boxes) all.add(box);
  return all;
}

/// Returns the bounds of the differences between a piece's vertices at a key and their present positions.
Box bounds_of_differences(const GltfPiece& piece, std::size_t key, Progress& progress) {
  const GltfPiece then = piece.at(key);
  Box all;
  for (std::size_t frame = 0; frame < piece.count(); ++frame) {
    if (frame % 256 == 0) progress.check();
    const Frame now = piece.frame(frame), other = then.frame(frame);
    for (std::size_t v = 0; v < piece.mesh->vertex_count(); ++v) {
      all.add(other.point(then.mesh->positions[v]) - now.point(piece.mesh->positions[v]));
    }
  }
  return all;
}

}  // namespace

GltfPiece GltfPiece::at(std::size_t key) const {
  GltfPiece then = *this;
  if (!motion->meshes.empty()) then.mesh = motion->meshes[key].get();
  if (!motion->frames.empty()) then.frames = motion->frames[key];
  if (!motion->tints.empty()) then.tints = motion->tints[key];
  return then;
}

Frame GltfSharedMesh::frame(std::size_t row) const {
  Frame place = source->frames[instances[row]];
  place.origin -= origin;
  return is_mirrored ? place * kMirror[0] : place;
}

bool is_expressible_as_node(const Frame& frame) {
  const Mat3& axes = frame.axes;
  const float x = glm::length(axes[0]);
  const float y = glm::length(axes[1]);
  const float z = glm::length(axes[2]);
  constexpr float kFlat = 1e-12F;
  if (!(x > kFlat && y > kFlat && z > kFlat)) return false;
  // Products of float rotations drift by about 1e-6. An intended shear is larger.
  constexpr float kShear = 4e-6F;
  return std::abs(glm::dot(axes[0], axes[1])) <= kShear * x * y &&
         std::abs(glm::dot(axes[1], axes[2])) <= kShear * y * z &&
         std::abs(glm::dot(axes[2], axes[0])) <= kShear * z * x;
}

GltfLayout lay_out_gltf(const MeshScene& scene, const GltfOptions& options, Progress& progress) {
  GltfLayout layout = LayoutBuilder(scene, options, progress).build();
  encode_images(layout, options.pictures, progress);
  place_arrays(layout);
  return layout;
}

GltfLayout lay_out_gltf(const MovingScene& moving, const GltfOptions& options, Progress& progress) {
  GltfLayout layout = LayoutBuilder(moving, progress).build();
  encode_images(layout, options.pictures, progress);
  place_arrays(layout);
  return layout;
}

void measure_bounds(GltfLayout& layout, Progress& progress) {
  for (GltfMesh& mesh : layout.meshes) {
    for (GltfPrimitive& primitive : mesh.primitives) {
      for (const GltfPiece& piece : primitive.pieces) primitive.bounds.add(bounds_of(piece, progress));
      parallel_for(primitive.targets.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t key = begin; key < end; ++key) {
          for (const GltfPiece& piece : primitive.pieces) {
            primitive.targets[key].bounds.add(bounds_of_differences(piece, key, progress));
          }
        }
      });
    }
  }
}

}  // namespace meristem
