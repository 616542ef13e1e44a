// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/ray_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include <embree3/rtcore.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/embree_device.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/texture/alpha_mask.h"

namespace meristem {

namespace {

constexpr std::uint32_t kNoInstance = std::numeric_limits<std::uint32_t>::max();

/// What a geometry of the upper tree stands for.
struct GeometrySource {
  std::uint32_t part = 0;                ///< kNoInstance: a whole plant, whose parts its own tree knows
  std::uint32_t instance = kNoInstance;  ///< kNoInstance: all of the part's instances, one after another
  std::uint32_t place = 0;               ///< of a whole plant
  std::uint32_t plant = 0;
};

/// A plant that stands in several places: a tree of all of its parts.
struct PlacedTree {
  const std::vector<Frame>* places = nullptr;
  std::vector<std::uint32_t> parts;  ///< in the order of the tree's geometries
  RTCScene tree = nullptr;
};

std::vector<bool> choose_copied(const MeshScene& scene, std::uint64_t most_triangles) {
  std::vector<bool> copied(scene.meshes.size());
  std::uint64_t total = 0;
  for (std::size_t p = 0; p < scene.meshes.size(); ++p) {
    if (scene.meshes[p].places != nullptr) continue;
    const std::uint64_t triangles = scene.meshes[p].triangle_count();
    copied[p] = scene.meshes[p].frames.size() == 1 || total + triangles <= most_triangles;
    if (copied[p] && scene.meshes[p].frames.size() > 1) total += triangles;
  }
  return copied;
}

/// What turns local normals into outer ones of any length: the cofactors, with the sign of a mirror taken out. In
/// floats, as it runs at every hit.
Mat3 normal_matrix(const Mat3& axes) {
  const Mat3 cofactors(glm::cross(axes[1], axes[2]), glm::cross(axes[2], axes[0]), glm::cross(axes[0], axes[1]));
  return glm::dot(axes[0], cofactors[0]) < 0 ? -cofactors : cofactors;
}

/// Weights of a triangle's three vertices.
Vec3 vertex_weights(Vec2 barycentric) { return {1 - barycentric.x - barycentric.y, barycentric.x, barycentric.y}; }

Vec2 uv_at(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, Vec3 weights) {
  return weights.x * mesh.uvs[triangle[0]] + weights.y * mesh.uvs[triangle[1]] + weights.z * mesh.uvs[triangle[2]];
}

/// What a masked geometry needs to know when a ray meets it: where its triangles lie on the mask, side by side, as
/// following them through the mesh takes longer than all the rest.
struct MaskedMesh {
  MaskedMesh(const Mesh& mesh, const AlphaMask& holes) : mask(&holes) {
    uvs.reserve(mesh.triangle_count());
    for (const auto& [a, b, c] : mesh.triangles) uvs.push_back({mesh.uvs[a], mesh.uvs[b], mesh.uvs[c]});
  }
  const AlphaMask* mask;
  std::vector<std::array<Vec2, 3>> uvs;
};

/// Lets rays pass where the mask has a hole.
void pass_through_holes(const RTCFilterFunctionNArguments* arguments) {
  const auto& masked = *static_cast<const MaskedMesh*>(arguments->geometryUserPtr);
  const auto triangles = static_cast<std::uint32_t>(masked.uvs.size());
  for (unsigned k = 0; k < arguments->N; ++k) {
    if (arguments->valid[k] == 0) continue;
    // A copied mesh has the triangles of all its instances, one after another.
    const auto& uvs = masked.uvs[RTCHitN_primID(arguments->hit, arguments->N, k) % triangles];
    const Vec3 weights =
        vertex_weights({RTCHitN_u(arguments->hit, arguments->N, k), RTCHitN_v(arguments->hit, arguments->N, k)});
    if (masked.mask->is_hole(weights.x * uvs[0] + weights.y * uvs[1] + weights.z * uvs[2])) arguments->valid[k] = 0;
  }
}

struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using GeometryOwner = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

bool stop_if_cancelled(void* progress, double) { return !static_cast<Progress*>(progress)->is_cancelled(); }

}  // namespace

struct RayScene::Trees {
  RTCDevice device = nullptr;
  RTCScene top = nullptr;
  std::vector<RTCScene> parts;  ///< trees of shared meshes; null for parts that were copied
  std::vector<PlacedTree> plants;
  std::unordered_map<const std::vector<Frame>*, std::size_t> plant_of_places;
  std::vector<GeometrySource> sources;
  std::map<const Texture*, AlphaMask> masks;
  std::deque<MaskedMesh> masked_meshes;  ///< the geometries point to them
  std::string failure;

  explicit Trees(Progress& progress) {
    device = rtcNewDevice(kEmbreeDevice);
    if (device == nullptr) throw MachineError("tracing rays: Embree could not be started");
    const auto keep_failure = [](void* self, RTCError code, const char* reason) {
      if (code != RTC_ERROR_CANCELLED) static_cast<Trees*>(self)->failure = reason;
    };
    rtcSetDeviceErrorFunction(device, keep_failure, this);
    top = new_scene(progress);
  }

  ~Trees() {
    for (RTCScene part : parts) {
      if (part != nullptr) rtcReleaseScene(part);
    }
    for (const PlacedTree& plant : plants) {
      if (plant.tree != nullptr) rtcReleaseScene(plant.tree);
    }
    if (top != nullptr) rtcReleaseScene(top);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  RTCScene new_scene(Progress& progress) const {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneProgressMonitorFunction(scene, stop_if_cancelled, &progress);
    return scene;
  }

  void commit(RTCScene scene, Progress& progress) const {
    rtcCommitScene(scene);
    progress.check();
    if (!failure.empty()) throw MachineError("tracing rays: " + failure);
  }

  /// Gives a geometry the holes of its texture.
  void cut_holes(RTCGeometry geometry, const Mesh& mesh, const Texture& texture) {
    const auto [found, is_new] = masks.try_emplace(&texture, texture.colour);
    masked_meshes.emplace_back(mesh, found->second);
    rtcSetGeometryUserData(geometry, &masked_meshes.back());
    rtcSetGeometryIntersectFilterFunction(geometry, pass_through_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, pass_through_holes);
  }

  /// Adds all of the frames' triangles to a scene. `texture` is null where it has no holes.
  void add_triangles(RTCScene scene, const Mesh& mesh, const std::vector<Frame>& frames, const Texture* texture,
                     Progress& progress) {
    const GeometryOwner owner(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    RTCGeometry geometry = owner.get();
    const std::size_t vertices = mesh.vertex_count();
    const std::size_t triangles = mesh.triangle_count();
    auto* positions = static_cast<Vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 sizeof(Vec3), vertices * frames.size()));
    auto* indices = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(mesh.triangles[0]), triangles * frames.size()));
    if (positions != nullptr && indices != nullptr) {
      parallel_for(frames.size(), 256, [&](std::size_t begin, std::size_t end) {
        progress.check();
        for (std::size_t f = begin; f < end; ++f) {
          const auto base = static_cast<std::uint32_t>(f * vertices);
          for (std::size_t v = 0; v < vertices; ++v) positions[base + v] = frames[f].point(mesh.positions[v]);
          for (std::size_t t = 0; t < triangles; ++t) {
            const auto [a, b, c] = mesh.triangles[t];
            indices[f * triangles + t] = {base + a, base + b, base + c};
          }
        }
      });
      if (texture != nullptr) cut_holes(geometry, mesh, *texture);
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
    }
  }

  /// The tree of what stands in these places.
  PlacedTree& plant_at(const std::vector<Frame>* places, Progress& progress) {
    const auto [known, is_new] = plant_of_places.try_emplace(places, plants.size());
    if (is_new) plants.push_back({places, {}, new_scene(progress)});
    return plants[known->second];
  }

  void add_instance(RTCScene of, const Frame& frame) const {
    const GeometryOwner owner(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
    RTCGeometry geometry = owner.get();
    rtcSetGeometryInstancedScene(geometry, of);
    const Mat3& axes = frame.axes;
    const float columns[12] = {axes[0].x, axes[0].y, axes[0].z, axes[1].x,      axes[1].y,      axes[1].z,
                               axes[2].x, axes[2].y, axes[2].z, frame.origin.x, frame.origin.y, frame.origin.z};
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(top, geometry);
  }
};

RayScene::RayScene(const MeshScene& scene, Progress& progress, std::uint64_t copied_triangles)
    : scene_(scene), trees_(std::make_unique<Trees>(progress)) {
  const std::vector<bool> copied = choose_copied(scene, copied_triangles);
  trees_->parts.resize(scene.meshes.size(), nullptr);
  for (std::uint32_t p = 0; p < scene.meshes.size(); ++p) {
    const MeshInstances& part = scene.meshes[p];
    if (part.triangle_count() == 0) continue;
    const Texture* texture = texture_with_holes(scene.materials[part.material], *part.mesh);
    if (part.places != nullptr) {
      PlacedTree& plant = trees_->plant_at(part.places.get(), progress);
      plant.parts.push_back(p);
      trees_->add_triangles(plant.tree, *part.mesh, part.frames, texture, progress);
      continue;
    }
    if (copied[p]) {
      trees_->sources.push_back({p, kNoInstance});
      trees_->add_triangles(trees_->top, *part.mesh, part.frames, texture, progress);
      continue;
    }
    trees_->parts[p] = trees_->new_scene(progress);
    trees_->add_triangles(trees_->parts[p], *part.mesh, {Frame()}, texture, progress);
    trees_->commit(trees_->parts[p], progress);
    for (std::uint32_t i = 0; i < part.frames.size(); ++i) {
      if (glm::determinant(part.frames[i].axes) == 0) continue;  // a flat organ shows no surface to rays
      trees_->sources.push_back({p, i});
      trees_->add_instance(trees_->parts[p], part.frames[i]);
      if (i % 4096 == 0) progress.check();
    }
  }
  for (std::uint32_t k = 0; k < trees_->plants.size(); ++k) {
    const PlacedTree& plant = trees_->plants[k];
    trees_->commit(plant.tree, progress);
    for (std::uint32_t place = 0; place < plant.places->size(); ++place) {
      if (glm::determinant((*plant.places)[place].axes) == 0) continue;
      trees_->sources.push_back({kNoInstance, kNoInstance, place, k});
      trees_->add_instance(plant.tree, (*plant.places)[place]);
    }
  }
  trees_->commit(trees_->top, progress);
}

RayScene::~RayScene() = default;

float RayScene::clearance(Vec3 position) {
  // Floats know a position 10 m away to a micrometre.
  return 2e-5F * (0.1F + std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)}));
}

std::optional<RayHit> RayScene::first_hit(const Ray& ray) const {
  RTCRayHit query;
  query.ray = {ray.origin.x,
               ray.origin.y,
               ray.origin.z,
               0,
               ray.direction.x,
               ray.direction.y,
               ray.direction.z,
               0,
               std::numeric_limits<float>::infinity(),
               ~0U,
               0,
               0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(trees_->top, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const bool is_instance = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  const GeometrySource source = trees_->sources[is_instance ? query.hit.instID[0] : query.hit.geomID];
  if (source.part == kNoInstance) {
    const std::uint32_t part = trees_->plants[source.plant].parts[query.hit.geomID];
    const MeshInstances& placed = scene_.meshes[part];
    const auto triangles = static_cast<std::uint32_t>(placed.mesh->triangle_count());
    const std::uint32_t frame = query.hit.primID / triangles;
    return RayHit{query.ray.tfar, part, source.place * static_cast<std::uint32_t>(placed.frames.size()) + frame,
                  query.hit.primID % triangles, Vec2(query.hit.u, query.hit.v)};
  }
  const auto per_instance = static_cast<std::uint32_t>(scene_.meshes[source.part].mesh->triangle_count());
  const Vec2 barycentric(query.hit.u, query.hit.v);
  if (is_instance) return RayHit{query.ray.tfar, source.part, source.instance, query.hit.primID, barycentric};
  return RayHit{query.ray.tfar, source.part, query.hit.primID / per_instance, query.hit.primID % per_instance,
                barycentric};
}

bool RayScene::is_blocked(const Ray& ray, float within) const {
  RTCRay query{ray.origin.x,
               ray.origin.y,
               ray.origin.z,
               0,
               ray.direction.x,
               ray.direction.y,
               ray.direction.z,
               0,
               within,
               ~0U,
               0,
               0};
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(trees_->top, &context, &query);
  return query.tfar < 0;
}

SurfacePoint RayScene::surface_point(const RayHit& hit) const {
  const MeshInstances& part = scene_.meshes[hit.part];
  const Mesh& mesh = *part.mesh;
  const Frame frame = part.frame(hit.instance);
  const auto& triangle = mesh.triangles[hit.triangle];
  const Vec3 weights = vertex_weights(hit.barycentric);
  const Vec3 a = mesh.positions[triangle[0]];
  const Vec3 b = mesh.positions[triangle[1]];
  const Vec3 c = mesh.positions[triangle[2]];
  const Vec3 local = weights.x * a + weights.y * b + weights.z * c;
  const Vec3 local_face = glm::cross(b - a, c - a);
  const Mat3 to_outer_normal = normal_matrix(frame.axes);

  SurfacePoint point;
  point.position = frame.point(local);
  point.face_normal = normalized_or(to_outer_normal * local_face, kUp);
  point.normal = point.face_normal;
  point.smooth_offset = Vec3(0);
  if (mesh.normals.empty()) return point;
  Vec3 blended(0);
  Vec3 offset(0);
  for (int k = 0; k < 3; ++k) {
    const Vec3 normal = mesh.normals[triangle[k]];
    blended += weights[k] * normal;
    // Each vertex's tangent plane lifts the point; on convex surfaces that undoes the flatness of the triangle.
    const float below = std::min(0.0F, glm::dot(local - mesh.positions[triangle[k]], normal));
    offset -= weights[k] * below * normal;
  }
  point.normal = normalized_or(to_outer_normal * blended, point.face_normal);
  point.smooth_offset = frame.vector(offset);
  return point;
}

Vec3 RayScene::face_normal(const RayHit& hit) const {
  const MeshInstances& part = scene_.meshes[hit.part];
  const auto& triangle = part.mesh->triangles[hit.triangle];
  const Vec3 a = part.mesh->positions[triangle[0]];
  const Vec3 face = glm::cross(part.mesh->positions[triangle[1]] - a, part.mesh->positions[triangle[2]] - a);
  return normalized_or(normal_matrix(part.frame(hit.instance).axes) * face, kUp);
}

TextureMapping RayScene::texture_mapping(const RayHit& hit) const {
  TextureMapping position;
  const MeshInstances& part = scene_.meshes[hit.part];
  const Mesh& mesh = *part.mesh;
  if (mesh.uvs.empty()) return position;
  const Frame frame = part.frame(hit.instance);
  const auto& triangle = mesh.triangles[hit.triangle];
  const Vec3 weights = vertex_weights(hit.barycentric);
  position.uv = uv_at(mesh, triangle, weights);

  // How wide the texture is drawn: the triangle's area on it, over that in the world.
  const Vec3 to_b = frame.vector(mesh.positions[triangle[1]] - mesh.positions[triangle[0]]);
  const Vec3 to_c = frame.vector(mesh.positions[triangle[2]] - mesh.positions[triangle[0]]);
  const Vec2 uv_to_b = mesh.uvs[triangle[1]] - mesh.uvs[triangle[0]];
  const Vec2 uv_to_c = mesh.uvs[triangle[2]] - mesh.uvs[triangle[0]];
  const float area = glm::length(glm::cross(to_b, to_c));
  const float uv_area = uv_to_b.x * uv_to_c.y - uv_to_b.y * uv_to_c.x;
  if (area > 0) position.uvs_per_metre = std::sqrt(std::abs(uv_area) / area);

  // Where u and v rise: by the mesh's tangents, else by the triangle's own uvs.
  if (!mesh.tangents.empty() && !mesh.normals.empty()) {
    Vec4 tangent(0);
    Vec3 normal(0);
    for (int k = 0; k < 3; ++k) {
      tangent += weights[k] * mesh.tangents[triangle[k]];
      normal += weights[k] * mesh.normals[triangle[k]];
    }
    const float handedness = tangent.w < 0 ? -1.0F : 1.0F;
    position.along_u = normalized_or(frame.vector(Vec3(tangent)), Vec3(0));
    position.along_v = normalized_or(frame.vector(handedness * glm::cross(normal, Vec3(tangent))), Vec3(0));
  } else if (uv_area != 0) {
    const float sign = uv_area < 0 ? -1.0F : 1.0F;
    position.along_u = normalized_or(sign * (uv_to_c.y * to_b - uv_to_b.y * to_c), Vec3(0));
    position.along_v = normalized_or(sign * (uv_to_b.x * to_c - uv_to_c.x * to_b), Vec3(0));
  }
  return position;
}

}  // namespace meristem
