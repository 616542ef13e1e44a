// SPDX-License-Identifier: Apache-2.0
// Makes packets of scene changes. All content has a hash as its key. The keys of the viewer's content are compared with
// the keys of the new scene, and only missing content is sent.
#include "meristem/export/packet/scene_packet.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/base/hash.h"
#include "meristem/document/json.h"
#include "meristem/export/packet/packet_arrays.h"
#include "meristem/export/packet/short_values.h"
#include "meristem/export/packet/skeleton_lines.h"
#include "meristem/output/write/finite.h"
#include "meristem/output/write/jpeg.h"
#include "meristem/output/write/png.h"
#include "meristem/shape/mesh/shading.h"

namespace meristem {

namespace {

Value key_value(std::uint64_t key) { return fmt::format("{:016x}", key); }

Value number_value(std::uint64_t number) { return static_cast<double>(number); }

Value key_list(const std::vector<std::uint64_t>& keys) {
  Value::List list;
  for (const std::uint64_t key : keys) list.push_back(key_value(key));
  return list;
}

std::uint64_t picture_key(const Image& image, PixelKind kind) {
  return Fingerprint().add(image.width).add(image.height).add(kind).add_array(image.rgba).hash();
}

std::uint64_t lines_key(const Skeleton& skeleton, float min_radius) {
  return Fingerprint()
      .add_array(skeleton.parent)
      .add_array(skeleton.position)
      .add_array(skeleton.radius)
      .add_array(skeleton.order)
      .add(min_radius)
      .hash();
}

/// Returns the keys of `before` that `after` lacks.
std::vector<std::uint64_t> missing_keys(const std::set<std::uint64_t>& before, const std::set<std::uint64_t>& after) {
  std::vector<std::uint64_t> missing;
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(missing));
  return missing;
}

/// Adds a list to the head if it is not empty.
void add_list(Value::Object& object, const char* name, Value::List list) {
  if (!list.empty()) object.emplace_back(name, std::move(list));
}

Value counts_value(const PacketCounts& counts) {
  return Value::Object{{"triangles", number_value(counts.triangles)},
                       {"instances", number_value(counts.instances)},
                       {"nodes", number_value(counts.nodes)}};
}

/// Returns the frames of all instances, place by place.
std::vector<Frame> all_frames(const MeshInstances& instances) {
  std::vector<Frame> frames(instances.count());
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = instances.frame(i);
  return frames;
}

std::vector<Vec3> all_tints(const MeshInstances& instances) {
  std::vector<Vec3> tints(instances.count());
  for (std::size_t i = 0; i < tints.size(); ++i) tints[i] = instances.tint(i);
  return tints;
}

}  // namespace

/// Builds one packet: the content of the viewer before and after it, and the lists of the head.
class PacketMaker::Builder {
 public:
  Builder(const Shown& before, const Progress& progress) : before_(before), progress_(progress) {
    now_.is_empty = false;
  }

  void add_meshes(const MeshScene& scene, const SceneKeys& keys) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) add_material(scene.materials[m], m, keys, m);
    for (std::size_t k = 0; k < scene.meshes.size(); ++k) add_batch(scene.meshes[k], keys.batches[k], 0);
    if (const Box bounds = scene.bounds(); !bounds.is_empty())
      bounds_ = Value::List{vector_value(bounds.low), vector_value(bounds.high)};
    triangles_ = scene.triangle_count();
    instances_ = scene.instance_count();
  }

  /// The materials of obstacles follow the materials of plants.
  void add_obstacles(const MeshScene& scene, const SceneKeys& keys) {
    const std::size_t before = now_.materials.size();
    for (std::size_t m = 0; m < scene.materials.size(); ++m) add_material(scene.materials[m], before + m, keys, m);
    for (std::size_t k = 0; k < scene.meshes.size(); ++k)
      add_batch(scene.meshes[k], keys.batches[k], static_cast<std::uint32_t>(before));
    if (const Box bounds = scene.bounds(); bounds_.is_null() && !bounds.is_empty())
      bounds_ = Value::List{vector_value(bounds.low), vector_value(bounds.high)};
  }

  /// Adds the parts of a scene that are not meshes.
  void add_scene(const Scene& scene) {
    const Vec3 sun = unit_vector(scene.sun);
    Fingerprint hash;
    hash.add(sun.x).add(sun.y).add(sun.z);
    for (const Lamp& lamp : scene.light.lamps) {
      hash.add(lamp.position.x).add(lamp.position.y).add(lamp.position.z).add(lamp.strength);
    }
    for (const auto& [name, points] : scene.supports) hash.add_text(name).add_array(points);
    now_.scene = hash.hash();
    if (now_.scene == before_.scene) return;
    Value::List lamps;
    for (const Lamp& lamp : scene.light.lamps)
      lamps.push_back(Value::Object{{"position", vector_value(lamp.position)}, {"strength", lamp.strength}});
    Value::List supports;
    for (const auto& [name, points] : scene.supports)
      supports.push_back(Value::Object{{"name", name}, {"points", arrays_.add(packed_vectors(points))}});
    scene_ = Value::Object{{"sun", vector_value(sun)}, {"lamps", std::move(lamps)}, {"supports", std::move(supports)}};
  }

  void add_skeletons(const Plant& plant, std::size_t max_segments) {
    std::vector<const Skeleton*> skeletons;
    for (const Stem& stem : plant.stems) skeletons.push_back(&stem.skeleton);
    const float min = max_segments == 0 ? 0 : min_drawn_radius(skeletons, max_segments);
    for (const Skeleton* skeleton : skeletons) {
      const std::uint64_t key = lines_key(*skeleton, min);
      now_.lines.push_back(key);
      if (!now_.held.skeletons.insert(key).second || before_.held.skeletons.contains(key)) continue;
      progress_.check();
      const SkeletonLines lines = skeleton_lines(*skeleton, min);
      require_finite_values(std::span<const float>(lines.radii));
      lists_.skeletons.push_back(Value::Object{{"key", key_value(key)},
                                               {"positions", arrays_.add(packed_vectors(lines.positions))},
                                               {"segments", arrays_.add(lines.segments)},
                                               {"orders", arrays_.add(lines.orders)},
                                               {"radii", arrays_.add(lines.radii)}});
    }
    if (!bounds_.is_null()) return;
    Box box;
    for (const Skeleton* skeleton : skeletons) box.add(bounds(*skeleton));
    if (!box.is_empty()) bounds_ = Value::List{vector_value(box.low), vector_value(box.high)};
  }

  std::string packet(std::uint64_t number, const PacketFacts& facts) {
    return packet_bytes("MSP1", head(number, facts), arrays_);
  }

  /// Keeps content on the viewer that it will need again.
  void keep(const Held& rest) {
    const auto keep_keys = [](const Keys& keys, const Keys& before, Keys& now) {
      std::set_intersection(keys.begin(), keys.end(), before.begin(), before.end(), std::inserter(now, now.end()));
    };
    keep_keys(rest.meshes, before_.held.meshes, now_.held.meshes);
    keep_keys(rest.instances, before_.held.instances, now_.held.instances);
    keep_keys(rest.pictures, before_.held.pictures, now_.held.pictures);
    keep_keys(rest.skeletons, before_.held.skeletons, now_.held.skeletons);
  }

  Shown take_shown() { return std::move(now_); }

 private:
  struct Lists {
    Value::List pictures, materials, meshes, instances, batches, skeletons;
  };

  /// Returns the key of a texture's picture, and sends the picture if the viewer lacks it. Pictures without holes are
  /// sent as JPEG, which takes a third of the bytes and suffices on a screen.
  Value add_picture(const Image& image, PixelKind kind, bool has_holes) {
    const std::uint64_t key = picture_key(image, kind);
    if (now_.held.pictures.insert(key).second && !before_.held.pictures.contains(key)) {
      progress_.check();
      const std::string bytes = has_holes ? encode_png(image, kind, PngPacking::quick) : encode_jpeg(image);
      lists_.pictures.push_back(Value::Object{{"key", key_value(key)},
                                              {"type", has_holes ? "image/png" : "image/jpeg"},
                                              {"width", image.width},
                                              {"height", image.height},
                                              {"bytes", arrays_.add_bytes(bytes)}});
    }
    return key_value(key);
  }

  /// Adds a material. `index` is its index for the viewer, and `own` its index in the scene of `keys`.
  void add_material(const Material& material, std::size_t index, const SceneKeys& keys, std::size_t own) {
    now_.materials.push_back(keys.materials[own]);
    Value::Object object{{"index", number_value(index)},
                         {"name", material.name},
                         {"colour", vector_value(material.tint())},
                         {"roughness", short_number(material.roughness)},
                         {"translucency", short_number(material.translucency)},
                         {"opacity", short_number(material.opacity)},
                         {"two_sided", material.two_sided},
                         {"masked", material.texture != nullptr && material.texture->masked}};
    if (const Texture* texture = material.texture.get(); texture != nullptr && texture->is_painted()) {
      if (!texture->colour.is_empty())
        object.emplace_back("picture", add_picture(texture->colour, PixelKind::srgb, texture->masked));
      if (texture->has_normals())
        object.emplace_back("normals", add_picture(texture->normals, PixelKind::numbers, false));
    }
    if (index < before_.materials.size() && before_.materials[index] == keys.materials[own]) return;
    lists_.materials.push_back(std::move(object));
  }

  void add_mesh(const Mesh& given, std::uint64_t key) {
    if (!now_.held.meshes.insert(key).second || before_.held.meshes.contains(key)) return;
    progress_.check();
    const bool has_normals = !given.normals.empty();
    const Mesh shaded = has_normals ? Mesh{} : smooth_shaded(given);
    const Mesh& mesh = has_normals ? given : shaded;
    Value::Object object{{"key", key_value(key)},
                         {"vertices", number_value(mesh.vertex_count())},
                         {"triangles", number_value(mesh.triangle_count())},
                         {"positions", arrays_.add(packed_vectors(mesh.positions))},
                         {"normals", arrays_.add(packed_normals(mesh.normals))}};
    if (!mesh.tangents.empty()) object.emplace_back("tangents", arrays_.add(packed_tangents(mesh.tangents)));
    if (!mesh.uvs.empty()) {
      const bool is_small = fit_sixteen_bits(mesh.uvs);
      object.emplace_back("uvs", is_small ? arrays_.add(packed_uvs(mesh.uvs)) : arrays_.add(wide_uvs(mesh.uvs)));
      object.emplace_back("uv_type", is_small ? "u16" : "f32");
    }
    const bool is_small = mesh.vertex_count() <= std::numeric_limits<std::uint16_t>::max();
    object.emplace_back("indices", is_small ? arrays_.add(packed_indices<std::uint16_t>(mesh.triangles))
                                            : arrays_.add(packed_indices<std::uint32_t>(mesh.triangles)));
    object.emplace_back("index_type", is_small ? "u16" : "u32");
    lists_.meshes.push_back(std::move(object));
  }

  void add_instances(const MeshInstances& instances, std::uint64_t key) {
    if (!now_.held.instances.insert(key).second || before_.held.instances.contains(key)) return;
    progress_.check();
    Value::Object object{{"key", key_value(key)},
                         {"count", number_value(instances.count())},
                         {"frames", arrays_.add(packed_frames(all_frames(instances)))}};
    if (!instances.tints.empty()) {
      const Vec3 scale = tint_scale(instances.tints);
      object.emplace_back("tints", arrays_.add(packed_tints(all_tints(instances), scale)));
      object.emplace_back("tint_scale", vector_value(scale));
    }
    lists_.instances.push_back(std::move(object));
  }

  /// `first` is the viewer's index of the scene's first material.
  void add_batch(const MeshInstances& instances, const SceneKeys::Batch& keys, std::uint32_t first) {
    add_mesh(*instances.mesh, keys.mesh);
    add_instances(instances, keys.instances);
    const BatchName name(keys.component, keys.number);
    const Batch batch{.mesh = keys.mesh, .instances = keys.instances, .material = first + instances.material};
    now_.batches.emplace(name, batch);
    if (const auto was = before_.batches.find(name); was != before_.batches.end() && was->second == batch) return;
    lists_.batches.push_back(Value::Object{{"component", keys.component},
                                           {"number", number_value(keys.number)},
                                           {"mesh", key_value(keys.mesh)},
                                           {"material", number_value(batch.material)},
                                           {"instances_of", key_value(keys.instances)}});
  }

  Value gone() const {
    Value::Object gone;
    Value::List batches;
    for (const auto& [name, batch] : before_.batches) {
      if (!now_.batches.contains(name)) batches.push_back(Value::List{name.first, number_value(name.second)});
    }
    add_list(gone, "batches", std::move(batches));
    const auto add_keys = [&gone](const char* name, const Keys& before, const Keys& now) {
      const std::vector<std::uint64_t> missing = missing_keys(before, now);
      if (!missing.empty()) gone.emplace_back(name, key_list(missing));
    };
    add_keys("meshes", before_.held.meshes, now_.held.meshes);
    add_keys("instances_of", before_.held.instances, now_.held.instances);
    add_keys("pictures", before_.held.pictures, now_.held.pictures);
    add_keys("skeletons", before_.held.skeletons, now_.held.skeletons);
    if (now_.materials.size() < before_.materials.size())
      gone.emplace_back("materials", number_value(now_.materials.size()));
    return gone;
  }

  Value head(std::uint64_t number, const PacketFacts& facts) {
    Value::Object head{{"packet", number_value(number)},
                       {"whole", before_.is_empty},
                       {"fit", facts.fits},
                       {"hash", facts.hash},
                       {"draft", facts.is_draft},
                       {"share", facts.share},
                       {"triangles", number_value(triangles_)},
                       {"instances", number_value(instances_)},
                       {"of", counts_value(facts.all)}};
    if (!bounds_.is_null()) head.emplace_back("bounds", bounds_);
    add_list(head, "pictures", std::move(lists_.pictures));
    add_list(head, "materials", std::move(lists_.materials));
    add_list(head, "meshes", std::move(lists_.meshes));
    add_list(head, "instances_of", std::move(lists_.instances));
    add_list(head, "batches", std::move(lists_.batches));
    add_list(head, "skeletons", std::move(lists_.skeletons));
    if (now_.lines != before_.lines) head.emplace_back("lines", key_list(now_.lines));
    if (!scene_.is_null()) head.emplace_back("scene", std::move(scene_));
    if (Value gone = this->gone(); !gone.object()->empty()) head.emplace_back("gone", std::move(gone));
    return head;
  }

  const Shown& before_;
  const Progress& progress_;
  Shown now_;
  PacketArrays arrays_;
  Lists lists_;
  Value bounds_;
  Value scene_;
  std::uint64_t triangles_ = 0;
  std::uint64_t instances_ = 0;
};

std::string PacketMaker::next(const PacketScene& scene, const PacketFacts& facts, const Progress& progress) {
  Builder builder(shown_, progress);
  if (scene.meshes != nullptr) builder.add_meshes(*scene.meshes, key_maker_.keys_of(*scene.meshes));
  if (scene.skeletons != nullptr) builder.add_skeletons(*scene.skeletons, scene.max_segments);
  if (scene.obstacles != nullptr) builder.add_obstacles(*scene.obstacles, key_maker_.keys_of(*scene.obstacles));
  if (scene.scene != nullptr) builder.add_scene(*scene.scene);
  if (facts.is_draft) builder.keep(rest_);
  std::string packet = builder.packet(number_ + 1, facts);
  shown_ = builder.take_shown();
  if (!facts.is_draft) rest_ = shown_.held;
  ++number_;
  return packet;
}

}  // namespace meristem
