// SPDX-License-Identifier: Apache-2.0
// Writes the JSON chunk. Everything except the nodes is built as one JSON value. Nodes are written as text directly,
// since there may be millions.
#include "meristem/output/gltf/gltf_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <map>
#include <span>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "meristem/output/gltf/gltf_tracks.h"

namespace meristem {

namespace {

using Json = nlohmann::ordered_json;

// Numeric constants of OpenGL in glTF.
constexpr int kUnsignedByte = 5121;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497;

constexpr const char* kTransmission = "KHR_materials_diffuse_transmission";
constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// Returns the double with the fewest digits that rounds to `value`: 0.8 and not 0.800000011920929.
double shortest(float value) {
  const std::string digits = fmt::format("{}", value);
  double result = value;
  std::from_chars(digits.data(), digits.data() + digits.size(), result);
  return result;
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json asset(const Provenance& provenance, const Json& extras) {
  Json json{{"version", "2.0"}, {"generator", "Meristem " + provenance.version}};
  std::string copyright = provenance.author;
  if (!provenance.licence.empty()) copyright += (copyright.empty() ? "" : ", ") + provenance.licence;
  if (!copyright.empty()) json["copyright"] = copyright;
  json["extras"] = extras;
  return json;
}

Json extras(const Provenance& provenance) {
  Json json{{"name", provenance.name}, {"seed", provenance.seed}, {"version", provenance.version}};
  if (!provenance.author.empty()) json["author"] = provenance.author;
  if (!provenance.licence.empty()) json["licence"] = provenance.licence;
  if (!provenance.sets.empty()) json["set"] = provenance.sets;
  return json;
}

Json triple(Vec3 value) { return {shortest(value.x), shortest(value.y), shortest(value.z)}; }

bool transmits(const Material& material) { return material.two_sided && material.translucency > 0; }

Json material_json(const GltfLayout& layout, const GltfMaterial& made, const Material& material) {
  const auto texture = std::find_if(layout.textures.begin(), layout.textures.end(),
                                    [&](const GltfTexture& known) { return known.source == made.texture; });
  const bool has_texture = texture != layout.textures.end();
  const auto picture = [](std::size_t image) { return Json{{"index", image}}; };
  const bool has_colours = has_texture && texture->colour != GltfTexture::kNoImage;

  Json base = triple(made.base);
  base.push_back(material.opacity < 1 ? Json(shortest(material.opacity)) : Json(1));
  Json surface{{"baseColorFactor", std::move(base)}};
  if (has_colours) surface["baseColorTexture"] = picture(texture->colour);
  surface["metallicFactor"] = 0;
  surface["roughnessFactor"] = shortest(material.roughness);

  Json json{{"name", made.name}, {"pbrMetallicRoughness", std::move(surface)}};
  if (has_texture && texture->normals != GltfTexture::kNoImage) json["normalTexture"] = picture(texture->normals);
  if (material.opacity < 1) {
    json["alphaMode"] = "BLEND";
  } else if (has_colours && made.texture->masked) {
    json["alphaMode"] = "MASK";
    json["alphaCutoff"] = 0.5;
  }
  json["doubleSided"] = material.two_sided;
  if (transmits(material)) {
    Json transmission{{"diffuseTransmissionFactor", shortest(material.translucency)},
                      {"diffuseTransmissionColorFactor", triple(made.transmitted)}};
    if (has_colours) transmission["diffuseTransmissionColorTexture"] = picture(texture->colour);
    json["extensions"][kTransmission] = std::move(transmission);
  }
  return json;
}

/// Adds `textures` and their sources. Each image of the layout is one texture.
void add_textures(const GltfLayout& layout, Json& root) {
  if (layout.images.empty()) return;
  for (std::size_t k = 0; k < layout.images.size(); ++k) {
    const GltfImage& image = layout.images[k];
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", image.range.offset}, {"byteLength", image.range.bytes}});
    root["images"].push_back(
        {{"name", image.name}, {"mimeType", "image/png"}, {"bufferView", root["bufferViews"].size() - 1}});
    root["textures"].push_back({{"sampler", 0}, {"source", k}});
  }
  root["samplers"] = {
      {{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}, {"wrapS", kRepeat}, {"wrapT", kRepeat}}};
}

/// The `meshes`, `accessors` and `bufferViews` of a file, filled in parallel.
class ArrayTables {
 public:
  explicit ArrayTables(const GltfLayout& layout) {
    for (const GltfMesh& mesh : layout.meshes) {
      Json primitives = Json::array();
      for (const GltfPrimitive& primitive : mesh.primitives) primitives.push_back(add_primitive(primitive));
      meshes_.push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
      // Without an animation, moving parts are shown in their last state.
      if (mesh.moves) meshes_.back()["weights"] = std::vector<int>(mesh.primitives[0].targets.size(), 0);
    }
    add_animation(layout.animation);
    if (!layout.has_instance_rows) return;
    for (const GltfComponent& component : layout.components) {
      for (const GltfSharedMesh& shared : component.shared) add_rows(shared);
    }
  }

  /// Returns the `extensions` of the nodes of shared meshes as text, in the order of the layout.
  const std::vector<std::string>& rows() const { return rows_; }

  /// Returns the `animations` of a file. `nodes` are the numbers of the moving nodes. Empty if no node moves.
  Json animations(const GltfAnimation& animation, const std::vector<std::size_t>& nodes) const {
    static constexpr std::array<const char*, 4> kProperties{"translation", "rotation", "scale", "weights"};
    Json channels = Json::array();
    Json samplers = Json::array();
    std::size_t accessor = first_track_;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      for (const GltfTrack& track : animation.tracks[k]) {
        const char* const property = kProperties[static_cast<std::size_t>(track.property)];
        channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", nodes[k]}, {"path", property}}}});
        samplers.push_back({{"input", first_track_ - 1},
                            {"interpolation", track.is_stepped ? "STEP" : "LINEAR"},
                            {"output", accessor++}});
      }
    }
    if (channels.empty()) return Json::array();
    return Json::array({{{"name", "growth"}, {"channels", std::move(channels)}, {"samplers", std::move(samplers)}}});
  }

  void move_into(Json& root) {
    root["meshes"] = std::move(meshes_);
    root["accessors"] = std::move(accessors_);
    root["bufferViews"] = std::move(views_);
  }

 private:
  Json add_primitive(const GltfPrimitive& primitive) {
    const int index_type = primitive.has_wide_indices() ? kUnsignedInt : kUnsignedShort;
    const std::size_t indices =
        add_accessor(primitive.index_range, kElementArrayBuffer, index_type, primitive.triangles * 3, "SCALAR");
    Json attributes{{"POSITION", add_vertices(primitive.position_range, primitive, "VEC3")}};
    add_bounds(primitive.bounds);
    if (primitive.has.normals) attributes["NORMAL"] = add_vertices(primitive.normal_range, primitive, "VEC3");
    if (primitive.has.tangents) attributes["TANGENT"] = add_vertices(primitive.tangent_range, primitive, "VEC4");
    if (primitive.has.uvs) attributes["TEXCOORD_0"] = add_vertices(primitive.uv_range, primitive, "VEC2");
    if (primitive.has.colours) {
      attributes["COLOR_0"] = add_bytes(primitive.colour_range, kArrayBuffer, primitive.vertices);
    }
    Json json{{"attributes", std::move(attributes)}, {"indices", indices}, {"material", primitive.material}};
    for (const GltfTarget& target : primitive.targets) {
      Json made{{"POSITION", add_vertices(target.position_range, primitive, "VEC3")}};
      add_bounds(target.bounds);
      if (primitive.turns) made["NORMAL"] = add_vertices(target.normal_range, primitive, "VEC3");
      if (primitive.changes_colour) made["COLOR_0"] = add_vertices(target.colour_range, primitive, "VEC4");
      json["targets"].push_back(std::move(made));
    }
    return json;
  }

  /// Adds bounds to the last accessor, as doubles with all digits, so that they equal the floats.
  void add_bounds(const Box& bounds) {
    const auto [low, high] = bounds;
    accessors_.back()["min"] = {double{low.x}, double{low.y}, double{low.z}};
    accessors_.back()["max"] = {double{high.x}, double{high.y}, double{high.z}};
  }

  /// Adds an accessor for the times and one for each track, all in one view.
  void add_animation(const GltfAnimation& animation) {
    if (animation.tracks.empty()) return;
    add_accessor(animation.range, kNoTarget, kFloat, animation.keys, "SCALAR");
    accessors_.back()["min"] = {double{animation.data.front()}};
    accessors_.back()["max"] = {double{animation.data[animation.keys - 1]}};
    first_track_ = accessors_.size();
    for (const std::vector<GltfTrack>& of_node : animation.tracks) {
      for (const GltfTrack& track : of_node) {
        const bool is_turn = track.property == GltfTrack::Property::rotation;
        const bool is_weight = track.property == GltfTrack::Property::weights;
        accessors_.push_back({{"bufferView", views_.size() - 1},
                              {"byteOffset", track.first * sizeof(float)},
                              {"componentType", kFloat},
                              {"count", is_weight ? track.numbers : animation.keys},
                              {"type", is_weight ? "SCALAR"
                                       : is_turn ? "VEC4"
                                                 : "VEC3"}});
      }
    }
  }

  std::size_t add_vertices(GltfRange range, const GltfPrimitive& primitive, const char* type) {
    return add_accessor(range, kArrayBuffer, kFloat, primitive.vertices, type);
  }

  /// Adds an accessor with four normalized bytes per element.
  std::size_t add_bytes(GltfRange range, int target, std::uint64_t count) {
    const std::size_t accessor = add_accessor(range, target, kUnsignedByte, count, "VEC4");
    accessors_[accessor]["normalized"] = true;
    return accessor;
  }

  /// Adds a view and its accessor. `target` is 0 for data that no vertex uses.
  std::size_t add_accessor(GltfRange range, int target, int component_type, std::uint64_t count, const char* type) {
    views_.push_back({{"buffer", 0}, {"byteOffset", range.offset}, {"byteLength", range.bytes}});
    if (target != kNoTarget) views_.back()["target"] = target;
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component_type}, {"count", count}, {"type", type}});
    return accessors_.size() - 1;
  }

  /// Adds the arrays of one shared mesh whose instances are rows.
  void add_rows(const GltfSharedMesh& shared) {
    const std::uint64_t rows = shared.instances.size();
    Json attributes{{"TRANSLATION", add_accessor(shared.translation_range, kNoTarget, kFloat, rows, "VEC3")},
                    {"ROTATION", add_accessor(shared.rotation_range, kNoTarget, kFloat, rows, "VEC4")},
                    {"SCALE", add_accessor(shared.scale_range, kNoTarget, kFloat, rows, "VEC3")}};
    if (shared.colour_range.bytes > 0) attributes["_COLOR_0"] = add_bytes(shared.colour_range, kNoTarget, rows);
    rows_.push_back(text_of({{kInstancing, {{"attributes", std::move(attributes)}}}}));
  }

  static constexpr int kNoTarget = 0;

  Json meshes_ = Json::array();
  Json accessors_ = Json::array();
  Json views_ = Json::array();
  std::vector<std::string> rows_;
  std::size_t first_track_ = 0;  // index of an accessor
};

/// Returns true if the plants and all parts without a plant stand below one node.
bool has_root(const GltfLayout& layout) { return !layout.plants.empty() || !layout.placed.empty(); }

/// Returns the number of nodes before the nodes of components: the root and the plants, or 0 without a root.
std::size_t nodes_before_components(const GltfLayout& layout) {
  return has_root(layout) ? 1 + layout.plants.size() : 0;
}

/// Returns the number of nodes of a component's shared meshes and moving meshes.
std::size_t shared_nodes(const GltfLayout& layout, const GltfComponent& component) {
  if (layout.has_instance_rows) return component.shared.size();
  std::size_t count = component.moving.size();
  for (const GltfSharedMesh& shared : component.shared) count += shared.instances.size();
  return count;
}

/// Writes the `nodes` array: the root and the plants if there are several, then the components, then their shared
/// instances in equal order. The sites of placed plants follow, each with its components and their instances. `rows`
/// are the extensions of shared meshes whose instances are not nodes.
class NodeWriter {
 public:
  NodeWriter(const GltfLayout& layout, const std::vector<std::string>& rows, FunctionRef<void(std::string_view)> sink,
             Progress& progress)
      : layout_(layout), rows_(rows), sink_(sink), progress_(progress) {}

  void write(const std::string& name) {
    text_ = ",\"nodes\":[";
    if (has_root(layout_)) write_plants(name);
    const auto own = std::span(layout_.components).first(layout_.own_components);
    std::size_t next = nodes_before_components(layout_) + own.size();
    next_instance_ = next;
    for (const GltfComponent& component : own) next = write_component(component, next);
    for (const GltfComponent& component : own) write_instances(component);
    for (const GltfPlacedPlant& plant : layout_.placed) next = write_places(plant, next);
    text_.back() = ']';  // replaces the last comma
    sink_(text_);
  }

  /// Returns the numbers of the moving nodes, in their order.
  const std::vector<std::size_t>& moving() const { return moving_; }

 private:
  /// Writes the root and the plants. The children of the root are the plants and all parts without a plant.
  void write_plants(const std::string& name) {
    std::size_t next = nodes_before_components(layout_);
    std::vector<std::size_t> first(layout_.plants.size() + 1, next);
    for (const GltfComponent& component : std::span(layout_.components).first(layout_.own_components)) {
      if (component.plant != GltfComponent::kNoPlant) first[component.plant + 1] = next + 1;
      ++next;
    }
    append("{{\"name\":{},\"children\":[", text_of(name.empty() ? "plants" : name));
    for (std::size_t k = 1; k <= layout_.plants.size(); ++k) append("{},", k);
    for (std::size_t k = first.back(); k < next; ++k) append("{},", k);
    append_places();
    close_list();
    for (std::size_t k = 0; k < layout_.plants.size(); ++k) {
      const GltfPlant& plant = layout_.plants[k];
      append("{{\"name\":{}", text_of(plant.name));
      if (plant.foot != Vec3(0)) append(",\"translation\":[{},{},{}]", plant.foot.x, plant.foot.y, plant.foot.z);
      append(",\"children\":[");
      for (std::size_t child = first[k]; child < first[k + 1]; ++child) append("{},", child);
      close_list();
    }
  }

  /// Ends a node with its list of children.
  void close_list() {
    text_.back() = ']';
    append("}},");
  }

  /// Appends the numbers of the nodes of all places.
  void append_places() {
    const auto components = std::span(layout_.components);
    std::size_t next = nodes_before_components(layout_) + layout_.own_components;
    for (const GltfComponent& component : components.first(layout_.own_components)) {
      next += shared_nodes(layout_, component);
    }
    for (const GltfPlacedPlant& plant : layout_.placed) {
      std::size_t stride = 1;
      for (std::size_t c = plant.first_component; c < plant.end_component; ++c) {
        stride += 1 + shared_nodes(layout_, components[c]);
      }
      for (std::size_t place = 0; place < plant.places->size(); ++place, next += stride) append("{},", next);
    }
  }

  /// Writes one node per place, followed by the nodes of its components and the nodes of their instances. Returns the
  /// number of the next node.
  std::size_t write_places(const GltfPlacedPlant& plant, std::size_t next) {
    const auto components =
        std::span(layout_.components).subspan(plant.first_component, plant.end_component - plant.first_component);
    const std::size_t first_rows = next_rows_;
    for (std::size_t place = 0; place < plant.places->size(); ++place) {
      append("{{\"name\":{}", text_of(fmt::format("{} {}", plant.name, placed_of_name_[plant.name]++)));
      append_matrix((*plant.places)[place]);
      append(",\"children\":[");
      for (std::size_t k = 1; k <= components.size(); ++k) append("{},", next + k);
      close_list();
      next += 1 + components.size();
      for (const GltfComponent& component : components) next = write_component(component, next);
      next_rows_ = first_rows;  // all places share the arrays
      for (const GltfComponent& component : components) write_instances(component);
    }
    return next;
  }

  std::size_t write_component(const GltfComponent& component, std::size_t first_child) {
    append("{{\"name\":{}", text_of(component.name));
    if (component.baked_mesh != GltfComponent::kNoMesh) append(",\"mesh\":{}", component.baked_mesh);
    const std::size_t end = first_child + child_count(component);
    if (end > first_child) {
      append(",\"children\":[");
      for (std::size_t child = first_child; child < end; ++child) append("{},", child);
      text_.back() = ']';
    }
    append("}},");
    return end;
  }

  std::size_t child_count(const GltfComponent& component) const { return shared_nodes(layout_, component); }

  void write_instances(const GltfComponent& component) {
    for (const GltfSharedMesh& shared : component.shared) {
      if (layout_.has_instance_rows) {
        append("{{\"mesh\":{},\"extensions\":{}}},", shared.mesh, rows_[next_rows_++]);
        continue;
      }
      for (std::size_t row = 0; row < shared.instances.size(); ++row) {
        if (shared.motion != nullptr) {
          write_moving_instance(shared, row);
        } else {
          write_instance(shared.mesh, shared.frame(row));
        }
      }
    }
    for (const GltfMovingMesh& moving : component.moving) {
      const bool is_shown = moving.shown_at != GltfMovingMesh::kAlways;
      moving_.push_back(next_instance_++);
      append("{{\"mesh\":{}", moving.mesh);
      if (is_shown && moving.shown_at + 1 < layout_.animation.keys) append(",\"scale\":[0,0,0]");
      append("}},");
    }
  }

  /// Nodes that an animation moves must not have a matrix.
  void write_moving_instance(const GltfSharedMesh& shared, std::size_t row) {
    moving_.push_back(next_instance_++);
    const auto [t, r, s] = poses_of(shared, row).back();
    append("{{\"mesh\":{},\"translation\":[{},{},{}],\"rotation\":[{},{},{},{}],\"scale\":[{},{},{}]}},", shared.mesh,
           t.x, t.y, t.z, r.x, r.y, r.z, r.w, s.x, s.y, s.z);
  }

  void write_instance(std::size_t mesh, const Frame& frame) {
    ++next_instance_;
    append("{{\"mesh\":{}", mesh);
    append_matrix(frame);
    append("}},");
  }

  void append_matrix(const Frame& frame) {
    if (frame.axes != Mat3(1) || frame.origin != Vec3(0)) {
      const Vec3 x = frame.axes[0];
      const Vec3 y = frame.axes[1];
      const Vec3 z = frame.axes[2];
      const Vec3 o = frame.origin;
      append(",\"matrix\":[{},{},{},0,{},{},{},0,{},{},{},0,{},{},{},1]", x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z,
             o.x, o.y, o.z);
    }
  }

  template <class... Values>
  void append(fmt::format_string<const Values&...> format, const Values&... values) {
    fmt::format_to(std::back_inserter(text_), format, values...);
    constexpr std::size_t kPiece = 1 << 16;
    if (text_.size() < kPiece) return;
    progress_.check();
    // The last byte stays, since it can be a comma that must be removed later.
    const char last = text_.back();
    text_.pop_back();
    sink_(text_);
    text_.assign(1, last);
  }

  const GltfLayout& layout_;
  const std::vector<std::string>& rows_;
  FunctionRef<void(std::string_view)> sink_;
  Progress& progress_;
  std::string text_;
  std::size_t next_rows_ = 0;
  std::size_t next_instance_ = 0;  // number of the next instance node
  std::vector<std::size_t> moving_;
  std::map<std::string, std::size_t> placed_of_name_;
};

/// Returns the used extensions. Some readers do not support them.
Json extensions_used(const GltfLayout& layout, const std::vector<Material>& materials) {
  Json used = Json::array();
  const auto is_transmitting = [&](const GltfMaterial& made) { return transmits(materials[made.source]); };
  if (std::any_of(layout.materials.begin(), layout.materials.end(), is_transmitting)) used.push_back(kTransmission);
  const auto shares = [](const GltfComponent& component) { return !component.shared.empty(); };
  if (layout.has_instance_rows && std::any_of(layout.components.begin(), layout.components.end(), shares)) {
    used.push_back(kInstancing);
  }
  return used;
}

Json scene_json(const GltfLayout& layout, const Provenance& provenance, const Json& extras) {
  Json json = Json::object();
  if (!provenance.name.empty()) json["name"] = provenance.name;
  if (!layout.components.empty()) {
    Json roots = Json::array();
    const std::size_t count = has_root(layout) ? 1 : layout.components.size();
    for (std::size_t node = 0; node < count; ++node) roots.push_back(node);
    json["nodes"] = std::move(roots);
  }
  json["extras"] = extras;
  return json;
}

}  // namespace

void emit_gltf_json(const GltfLayout& layout, const std::vector<Material>& materials, const Provenance& provenance,
                    FunctionRef<void(std::string_view)> sink, Progress& progress) {
  const Json extras_json = extras(provenance);
  Json root{{"asset", asset(provenance, extras_json)},
            {"scene", 0},
            {"scenes", {scene_json(layout, provenance, extras_json)}}};
  // glTF forbids empty arrays, so a scene without triangles has no other members.
  if (layout.meshes.empty()) return sink(text_of(root));
  if (Json used = extensions_used(layout, materials); !used.empty()) root["extensionsUsed"] = std::move(used);
  for (const GltfMaterial& made : layout.materials) {
    root["materials"].push_back(material_json(layout, made, materials[made.source]));
  }
  ArrayTables tables(layout);
  tables.move_into(root);
  add_textures(layout, root);
  root["buffers"] = {{{"byteLength", layout.binary_bytes}}};
  std::string text = text_of(root);
  text.pop_back();  // removes the closing brace, so that the nodes can follow
  sink(text);
  NodeWriter nodes(layout, tables.rows(), sink, progress);
  nodes.write(provenance.name);
  if (const Json moved = tables.animations(layout.animation, nodes.moving()); !moved.empty()) {
    sink(",\"animations\":" + text_of(moved));
  }
  sink("}");
}

}  // namespace meristem
