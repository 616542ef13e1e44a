// SPDX-License-Identifier: Apache-2.0
// All but the nodes is built as one JSON value; nodes, of which there may be millions, are written as text directly.
#include "meristem/output/gltf_json.h"

#include <charconv>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

using Json = nlohmann::ordered_json;

// Numbers that glTF gives to OpenGL's names.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

/// The double with the fewest digits that rounds to `value`: 0.8 and not 0.800000011920929.
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
  return json;
}

Json material_json(const Material& material) {
  const Vec3 colour = linear_from_srgb(material.colour);
  return {{"name", material.name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {shortest(colour.r), shortest(colour.g), shortest(colour.b), 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", shortest(material.roughness)}}},
          {"doubleSided", material.two_sided}};
}

/// The `meshes`, `accessors` and `bufferViews` of a file, filled side by side.
class ArrayTables {
 public:
  explicit ArrayTables(const GltfLayout& layout) : layout_(layout) {
    for (const GltfMesh& mesh : layout.meshes) {
      Json primitives = Json::array();
      for (const GltfPrimitive& primitive : mesh.primitives) primitives.push_back(add_primitive(primitive));
      meshes_.push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
    }
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
    // Bounds as doubles with all digits, so that they equal the floats they bound.
    const auto [low, high] = primitive.bounds;
    accessors_.back()["min"] = {double{low.x}, double{low.y}, double{low.z}};
    accessors_.back()["max"] = {double{high.x}, double{high.y}, double{high.z}};
    if (primitive.has_normals) attributes["NORMAL"] = add_vertices(primitive.normal_range, primitive, "VEC3");
    if (primitive.has_uvs) attributes["TEXCOORD_0"] = add_vertices(primitive.uv_range, primitive, "VEC2");
    const auto used = std::lower_bound(layout_.materials.begin(), layout_.materials.end(), primitive.material);
    return {{"attributes", std::move(attributes)},
            {"indices", indices},
            {"material", std::distance(layout_.materials.begin(), used)}};
  }

  std::size_t add_vertices(GltfRange range, const GltfPrimitive& primitive, const char* type) {
    return add_accessor(range, kArrayBuffer, kFloat, primitive.vertices, type);
  }

  std::size_t add_accessor(GltfRange range, int target, int component_type, std::uint64_t count, const char* type) {
    views_.push_back({{"buffer", 0}, {"byteOffset", range.offset}, {"byteLength", range.bytes}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component_type}, {"count", count}, {"type", type}});
    return accessors_.size() - 1;
  }

  const GltfLayout& layout_;
  Json meshes_ = Json::array();
  Json accessors_ = Json::array();
  Json views_ = Json::array();
};

/// Writes the `nodes` array: the components first, then their shared instances in the same order.
class NodeWriter {
 public:
  NodeWriter(const GltfLayout& layout, FunctionRef<void(std::string_view)> sink, Progress& progress)
      : layout_(layout), sink_(sink), progress_(progress) {}

  void write() {
    text_ = ",\"nodes\":[";
    std::size_t next_child = layout_.components.size();
    for (const GltfComponent& component : layout_.components) next_child = write_component(component, next_child);
    for (const GltfComponent& component : layout_.components) write_instances(component);
    text_.back() = ']';  // in place of the last comma
    sink_(text_);
  }

 private:
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

  static std::size_t child_count(const GltfComponent& component) {
    std::size_t count = 0;
    for (const GltfSharedMesh& shared : component.shared) {
      count += std::count_if(shared.frames.begin(), shared.frames.end(), is_expressible_as_node);
    }
    return count;
  }

  void write_instances(const GltfComponent& component) {
    for (const GltfSharedMesh& shared : component.shared) {
      for (const Frame& frame : shared.frames) {
        if (is_expressible_as_node(frame)) write_instance(shared.mesh, frame);
      }
    }
  }

  void write_instance(std::size_t mesh, const Frame& frame) {
    append("{{\"mesh\":{}", mesh);
    if (frame.axes != Mat3(1) || frame.origin != Vec3(0)) {
      const Vec3 x = frame.axes[0];
      const Vec3 y = frame.axes[1];
      const Vec3 z = frame.axes[2];
      const Vec3 o = frame.origin;
      append(",\"matrix\":[{},{},{},0,{},{},{},0,{},{},{},0,{},{},{},1]", x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z,
             o.x, o.y, o.z);
    }
    append("}},");
  }

  template <class... Values>
  void append(fmt::format_string<const Values&...> format, const Values&... values) {
    fmt::format_to(std::back_inserter(text_), format, values...);
    constexpr std::size_t kPiece = 1 << 16;
    if (text_.size() < kPiece) return;
    progress_.check();
    // The last byte stays, as it may be a comma that has to go.
    const char last = text_.back();
    text_.pop_back();
    sink_(text_);
    text_.assign(1, last);
  }

  const GltfLayout& layout_;
  FunctionRef<void(std::string_view)> sink_;
  Progress& progress_;
  std::string text_;
};

Json scene_json(const GltfLayout& layout, const Provenance& provenance, const Json& extras) {
  Json json = Json::object();
  if (!provenance.name.empty()) json["name"] = provenance.name;
  if (!layout.components.empty()) {
    Json roots = Json::array();
    for (std::size_t node = 0; node < layout.components.size(); ++node) roots.push_back(node);
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
  // glTF forbids empty arrays, so a scene without triangles has none of the rest.
  if (layout.meshes.empty()) return sink(text_of(root));
  for (const std::uint32_t material : layout.materials) root["materials"].push_back(material_json(materials[material]));
  ArrayTables(layout).move_into(root);
  root["buffers"] = {{{"byteLength", layout.binary_bytes}}};
  std::string text = text_of(root);
  text.pop_back();  // the closing brace, for the nodes
  sink(text);
  NodeWriter(layout, sink, progress).write();
  sink("}");
}

}  // namespace meristem
