// SPDX-License-Identifier: Apache-2.0
// In:  a mesh scene. Out: bounding volume trees for Embree, and the hits that they find.
//
// Copying the triangles of all leaves of a tree takes about 100 bytes for each triangle. An instance takes about 85
// bytes for each leaf, whatever its mesh, and tracing it takes about as long. Embree's own instances are not used for
// leaves. A geometry object for each leaf takes 280 bytes more, and they trace 1.6 times slower than a list whose
// primitives are the frames themselves. They also have a single level (RTC_MAX_INSTANCE_LEVEL_COUNT), which the places
// of plants need.
#include "meristem/shape/rays/ray_trees.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/plant_bounds.h"
#include "meristem/shape/scene/scene_size.h"

namespace meristem {

namespace {

// In large scenes. With more frames, boxes take less memory, and rays test more frames for each box.
constexpr std::uint32_t kFramesInABox = 4;
constexpr std::uint32_t kTrianglesInABox = 12;
constexpr std::size_t kFewVertices = 64;  // maximum number of vertices of a mesh whose instances get the box of their
                                          // own vertices
constexpr float kBoxRounding = 1e-6F;     // extension of a box, as a share of its farthest coordinate

/// Chooses the parts that are copied as triangles.
std::vector<bool> choose_copied(const MeshScene& scene, std::uint64_t max_triangles) {
  std::vector<bool> copied(scene.meshes.size());
  std::uint64_t total = 0;
  for (const bool is_placed : {false, true}) {
    for (std::size_t p = 0; p < scene.meshes.size(); ++p) {
      const MeshInstances& part = scene.meshes[p];
      if ((part.places != nullptr) != is_placed) continue;
      const std::uint64_t triangles = part.mesh->triangle_count() * part.frames.size();
      // There can be many placed plants, and they are traced about as fast as instances.
      const std::uint64_t limit = is_placed ? max_triangles / 3 : max_triangles;
      copied[p] = part.frames.size() == 1 || total + triangles <= limit;
      if (copied[p] && part.frames.size() > 1) total += triangles;
    }
  }
  return copied;
}

bool stop_if_cancelled(void* progress, double) { return !static_cast<Progress*>(progress)->is_cancelled(); }

/// Converts a ray to a frame's own coordinates. Distances along the ray stay equal. Returns false if the frame is flat.
bool enter_frame(const Frame& frame, RTCRay& ray) {
  const Mat3& axes = frame.axes;
  const Vec3 cofactors[3] = {glm::cross(axes[1], axes[2]), glm::cross(axes[2], axes[0]), glm::cross(axes[0], axes[1])};
  const float determinant = glm::dot(axes[0], cofactors[0]);
  if (determinant == 0) return false;
  const float scale = 1 / determinant;
  const Vec3 origin = Vec3(ray.org_x, ray.org_y, ray.org_z) - frame.origin;
  const Vec3 direction(ray.dir_x, ray.dir_y, ray.dir_z);
  ray.org_x = scale * glm::dot(cofactors[0], origin);
  ray.org_y = scale * glm::dot(cofactors[1], origin);
  ray.org_z = scale * glm::dot(cofactors[2], origin);
  ray.dir_x = scale * glm::dot(cofactors[0], direction);
  ray.dir_y = scale * glm::dot(cofactors[1], direction);
  ray.dir_z = scale * glm::dot(cofactors[2], direction);
  return true;
}

/// Returns false if a ray, given in the box's own coordinates, misses the box by more than rounding errors.
bool may_meet(const Box& box, const RTCRay& ray) {
  const Vec3 origin(ray.org_x, ray.org_y, ray.org_z);
  const Vec3 direction(ray.dir_x, ray.dir_y, ray.dir_z);
  const Vec3 far = glm::abs(origin) + glm::abs(box.low) + glm::abs(box.high);
  const Vec3 rounding(kBoxRounding * (far.x + far.y + far.z));
  const Vec3 low = box.low - rounding - origin;
  const Vec3 high = box.high + rounding - origin;
  float enter = ray.tnear;
  float leave = ray.tfar;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (low[axis] > 0 || high[axis] < 0) return false;
      continue;
    }
    const float a = low[axis] / direction[axis];
    const float b = high[axis] / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave * (1 + kBoxRounding);
}

/// The hit of a ray on a triangle: its distance, and the weights of the second and third vertex.
struct TriangleHit {
  float distance = 0;
  float second = 0;
  float third = 0;
};

/// Returns no hit if the ray misses the triangle or hits it outside of the ray's range. Based on: T. Möller, B.
/// Trumbore, Fast, minimum storage ray/triangle intersection, 1997.
std::optional<TriangleHit> meet(const RTCRay& ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 direction(ray.dir_x, ray.dir_y, ray.dir_z);
  const Vec3 to_b = b - a;
  const Vec3 to_c = c - a;
  const Vec3 across = glm::cross(direction, to_c);
  const float determinant = glm::dot(to_b, across);
  if (determinant == 0) return std::nullopt;
  const float scale = 1 / determinant;
  const Vec3 offset = Vec3(ray.org_x, ray.org_y, ray.org_z) - a;
  const float second = scale * glm::dot(offset, across);
  if (!(second >= 0 && second <= 1)) return std::nullopt;
  const Vec3 along = glm::cross(offset, to_b);
  const float third = scale * glm::dot(direction, along);
  const float distance = scale * glm::dot(to_c, along);
  if (!(third >= 0 && second + third <= 1 && distance >= ray.tnear && distance < ray.tfar)) return std::nullopt;
  return TriangleHit{distance, second, third};
}

/// Returns the box with a margin for rounding errors.
RTCBounds widened(const Box& box) {
  const Vec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
  const float rounding = kBoxRounding * std::max({farthest.x, farthest.y, farthest.z});
  // Embree ignores primitives with an empty box.
  if (box.is_empty()) return {1, 1, 1, 0, -1, -1, -1, 0};
  return {box.low.x - rounding,  box.low.y - rounding,  box.low.z - rounding,  0,
          box.high.x + rounding, box.high.y + rounding, box.high.z + rounding, 0};
}

RTCRay ray_to(const Ray& ray, float within) {
  return {ray.origin.x,
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
}

}  // namespace

/// A ray's context, in which a list of instances stores the index of the hit instance.
struct RayTrees::HitContext : EmbreeRayContext {
  std::uint32_t frame = 0;
};

RayTrees::MaskedMesh::MaskedMesh(const Mesh& mesh, const AlphaMask& holes) : mask(&holes) {
  uvs.reserve(mesh.triangle_count());
  for (const auto& [a, b, c] : mesh.triangles) uvs.push_back({mesh.uvs[a], mesh.uvs[b], mesh.uvs[c]});
}

void RayTrees::pass_through_holes(const RTCFilterFunctionNArguments* arguments) {
  const auto& masked = *static_cast<const MaskedMesh*>(arguments->geometryUserPtr);
  const auto triangles = static_cast<std::uint32_t>(masked.uvs.size());
  for (unsigned k = 0; k < arguments->N; ++k) {
    if (arguments->valid[k] == 0) continue;
    // A copied mesh has the triangles of all its instances, one after another.
    const auto& uvs = masked.uvs[RTCHitN_primID(arguments->hit, arguments->N, k) % triangles];
    const float u = RTCHitN_u(arguments->hit, arguments->N, k);
    const float v = RTCHitN_v(arguments->hit, arguments->N, k);
    if (masked.mask->is_hole((1 - u - v) * uvs[0] + u * uvs[1] + v * uvs[2])) arguments->valid[k] = 0;
  }
}

Box RayTrees::ListedPart::bounds_of_frames(std::size_t begin) const {
  Box all;
  const std::size_t end = std::min<std::size_t>(begin + in_a_box, part->frames.size());
  for (std::size_t f = begin; f < end; ++f) {
    const Frame& frame = part->frames[f];
    if (glm::determinant(frame.axes) == 0) continue;  // rays do not hit a flat organ
    if (part->mesh->vertex_count() > kFewVertices) {
      all.add(box_in(box, frame));
    } else {
      for (const Vec3 position : part->mesh->positions) all.add(frame.point(position));
    }
  }
  return all;
}

Box RayTrees::ListedPart::bounds_of_triangles(std::size_t begin) const {
  Box all;
  const std::size_t end = std::min<std::size_t>(begin + in_a_box, part->mesh->triangle_count());
  for (std::size_t t = begin; t < end; ++t) {
    for (const std::uint32_t vertex : part->mesh->triangles[t]) {
      all.add(part->frames[0].point(part->mesh->positions[vertex]));
    }
  }
  return all;
}

void RayTrees::find_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& list = *static_cast<const ListedPart*>(arguments->geometryUserPtr);
  const std::size_t begin = std::size_t{arguments->primID} * list.in_a_box;
  *arguments->bounds_o = widened(list.tree != nullptr ? list.bounds_of_frames(begin) : list.bounds_of_triangles(begin));
}

void RayTrees::meet_instance(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& list = *static_cast<const ListedPart*>(arguments->geometryUserPtr);
  auto& query = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);  // a query with one ray, as all queries are
  const std::size_t begin = std::size_t{arguments->primID} * list.in_a_box;
  const std::size_t end = std::min(begin + list.in_a_box, list.part->frames.size());
  for (std::size_t f = begin; f < end; ++f) {
    RTCRayHit local = query;
    if (!enter_frame(list.part->frames[f], local.ray)) continue;
    if (list.in_a_box > 1 && !may_meet(list.box, local.ray)) continue;
    local.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    local.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    EmbreeRayContext context;
    find_first_hit(list.tree, context, local);
    if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    query.ray.tfar = local.ray.tfar;
    query.hit = local.hit;
    query.hit.geomID = arguments->geomID;
    query.hit.instID[0] = arguments->context->instID[0];
    static_cast<HitContext*>(arguments->context)->frame = static_cast<std::uint32_t>(f);
  }
}

void RayTrees::block_by_instance(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& list = *static_cast<const ListedPart*>(arguments->geometryUserPtr);
  auto& query = *reinterpret_cast<RTCRay*>(arguments->ray);
  const std::size_t begin = std::size_t{arguments->primID} * list.in_a_box;
  const std::size_t end = std::min(begin + list.in_a_box, list.part->frames.size());
  for (std::size_t f = begin; f < end; ++f) {
    RTCRay local = query;
    if (!enter_frame(list.part->frames[f], local)) continue;
    if (list.in_a_box > 1 && !may_meet(list.box, local)) continue;
    EmbreeRayContext context;
    find_any_hit(list.tree, context, local);
    if (!(local.tfar < 0)) continue;
    query.tfar = -std::numeric_limits<float>::infinity();
    return;
  }
}

void RayTrees::meet_triangle(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& list = *static_cast<const ListedPart*>(arguments->geometryUserPtr);
  auto& query = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  RTCRay local = query.ray;
  if (!enter_frame(list.part->frames[0], local)) return;
  const Mesh& mesh = *list.part->mesh;
  const std::size_t begin = std::size_t{arguments->primID} * list.in_a_box;
  const std::size_t end = std::min(begin + list.in_a_box, mesh.triangle_count());
  for (std::size_t t = begin; t < end; ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const auto hit = meet(local, mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    if (!hit) continue;
    query.ray.tfar = local.tfar = hit->distance;
    query.hit.u = hit->second;
    query.hit.v = hit->third;
    query.hit.primID = static_cast<unsigned>(t);
    query.hit.geomID = arguments->geomID;
    query.hit.instID[0] = arguments->context->instID[0];
  }
}

void RayTrees::block_by_triangle(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& list = *static_cast<const ListedPart*>(arguments->geometryUserPtr);
  auto& query = *reinterpret_cast<RTCRay*>(arguments->ray);
  RTCRay local = query;
  if (!enter_frame(list.part->frames[0], local)) return;
  const Mesh& mesh = *list.part->mesh;
  const std::size_t begin = std::size_t{arguments->primID} * list.in_a_box;
  const std::size_t end = std::min(begin + list.in_a_box, mesh.triangle_count());
  for (std::size_t t = begin; t < end; ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    if (!meet(local, mesh.positions[a], mesh.positions[b], mesh.positions[c])) continue;
    query.tfar = -std::numeric_limits<float>::infinity();
    return;
  }
}

RayTrees::RayTrees(const MeshScene& scene, std::uint64_t copied_triangles, std::uint64_t large_from, Progress& progress)
    : scene_(scene), device_(rtcNewDevice(kEmbreeDevice)) {
  if (device_ == nullptr) throw MachineError("tracing rays: Embree could not be started");
  const auto keep_failure = [](void* self, RTCError code, const char* reason) {
    if (code != RTC_ERROR_CANCELLED) static_cast<RayTrees*>(self)->failure_ = reason;
  };
  rtcSetDeviceErrorFunction(device_.get(), keep_failure, this);
  const auto count_bytes = [](void* self, ssize_t bytes, bool) {
    static_cast<RayTrees*>(self)->bytes_ += bytes;
    return true;
  };
  rtcSetDeviceMemoryMonitorFunction(device_.get(), count_bytes, this);

  is_large_ = distinct_size(scene) > large_from;
  const std::vector<bool> copied = choose_copied(scene, is_large_ ? 0 : copied_triangles);
  top_ = new_scene(progress);
  for (std::uint32_t p = 0; p < scene.meshes.size(); ++p) {
    const MeshInstances& part = scene.meshes[p];
    if (part.triangle_count() == 0) continue;
    if (part.places == nullptr) {
      geometries_.push_back({.of_part = add_part(top_.get(), p, copied[p], progress)});
    } else {
      PlacedPlant& plant = plant_at(part.places.get(), progress);
      plant.geometries.push_back(add_part(plant.tree.get(), p, copied[p], progress));
    }
  }
  add_places(progress);
  commit(top_, progress);
}

RayTrees::SceneOwner RayTrees::new_scene(Progress& progress) const {
  SceneOwner scene(rtcNewScene(device_.get()));
  rtcSetSceneProgressMonitorFunction(scene.get(), stop_if_cancelled, &progress);
  if (is_large_) rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_COMPACT);
  return scene;
}

void RayTrees::commit(const SceneOwner& scene, Progress& progress) const {
  rtcCommitScene(scene.get());
  progress.check();
  if (!failure_.empty()) throw MachineError("tracing rays: " + failure_);
}

RayTrees::PlacedPlant& RayTrees::plant_at(const std::vector<Frame>* places, Progress& progress) {
  const auto [known, is_new] = plant_of_places_.try_emplace(places, plants_.size());
  if (is_new) plants_.push_back({places, {}, new_scene(progress)});
  return plants_[known->second];
}

RayTrees::Geometry RayTrees::add_part(RTCScene scene, std::uint32_t number, bool is_copied, Progress& progress) {
  const MeshInstances& part = scene_.meshes[number];
  const Texture* texture = texture_with_holes(scene_.materials[part.material], *part.mesh);
  if (is_copied && is_large_ && texture == nullptr) {
    add_packed_triangles(scene, part);
  } else if (is_copied) {
    add_triangles(scene, *part.mesh, part.frames, texture, progress);
  } else {
    add_instances(scene, part, texture, progress);
  }
  return {number, !is_copied};
}

void RayTrees::add_triangles(RTCScene scene, const Mesh& mesh, const std::vector<Frame>& frames, const Texture* texture,
                             Progress& progress) {
  const GeometryOwner owner(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  RTCGeometry geometry = owner.get();
  const std::size_t vertices = mesh.vertex_count();
  const std::size_t triangles = mesh.triangle_count();
  std::span<Vec3> positions;
  std::span<std::array<std::uint32_t, 3>> indices;
  const bool has_one = frames.size() == 1;
  const bool is_in_place = has_one && frames[0].axes == Mat3(1) && frames[0].origin == Vec3(0);
  // Embree reads four bytes past the last position.
  if (is_in_place && mesh.positions.capacity() > vertices) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0,
                               sizeof(Vec3), vertices);
  } else {
    positions = {static_cast<Vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                            sizeof(Vec3), vertices * frames.size())),
                 vertices * frames.size()};
    if (positions.data() == nullptr) return;  // commit() throws
  }
  if (has_one) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(mesh.triangles[0]), triangles);
  } else {
    indices = {static_cast<std::array<std::uint32_t, 3>*>(
                   rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                           sizeof(mesh.triangles[0]), triangles * frames.size())),
               triangles * frames.size()};
    if (indices.data() == nullptr) return;
  }
  parallel_for(frames.size(), 256, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t f = begin; f < end; ++f) {
      const auto base = static_cast<std::uint32_t>(f * vertices);
      if (!positions.empty()) {
        for (std::size_t v = 0; v < vertices; ++v) positions[base + v] = frames[f].point(mesh.positions[v]);
      }
      if (indices.empty()) continue;
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

RayTrees::GeometryOwner RayTrees::list_geometry(ListedPart& list, std::size_t count) const {
  GeometryOwner geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
  const std::size_t boxes = (count + list.in_a_box - 1) / list.in_a_box;
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes));
  rtcSetGeometryUserData(geometry.get(), &list);
  rtcSetGeometryBoundsFunction(geometry.get(), find_bounds, nullptr);
  return geometry;
}

void RayTrees::add_instances(RTCScene scene, const MeshInstances& part, const Texture* texture, Progress& progress) {
  ListedPart& list = listed_parts_.emplace_back();
  list.part = &part;
  list.tree = tree_of(*part.mesh, texture, progress);
  list.in_a_box = is_large_ ? kFramesInABox : 1;
  for (const Vec3 position : part.mesh->positions) list.box.add(position);
  const GeometryOwner geometry = list_geometry(list, part.frames.size());
  rtcSetGeometryIntersectFunction(geometry.get(), meet_instance);
  rtcSetGeometryOccludedFunction(geometry.get(), block_by_instance);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene, geometry.get());
}

void RayTrees::add_packed_triangles(RTCScene scene, const MeshInstances& part) {
  ListedPart& list = listed_parts_.emplace_back();
  list.part = &part;
  list.in_a_box = kTrianglesInABox;
  const GeometryOwner geometry = list_geometry(list, part.mesh->triangle_count());
  rtcSetGeometryIntersectFunction(geometry.get(), meet_triangle);
  rtcSetGeometryOccludedFunction(geometry.get(), block_by_triangle);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene, geometry.get());
}

RTCScene RayTrees::tree_of(const Mesh& mesh, const Texture* texture, Progress& progress) {
  SceneOwner& tree = mesh_trees_[{&mesh, texture}];
  if (tree == nullptr) {
    tree = new_scene(progress);
    add_triangles(tree.get(), mesh, {Frame()}, texture, progress);
    commit(tree, progress);
  }
  return tree.get();
}

void RayTrees::cut_holes(RTCGeometry geometry, const Mesh& mesh, const Texture& texture) {
  const AlphaMask& mask = masks_.try_emplace(&texture, texture.colour).first->second;
  MaskedMesh& masked = masked_meshes_.try_emplace({&mesh, &texture}, mesh, mask).first->second;
  rtcSetGeometryUserData(geometry, &masked);
  rtcSetGeometryIntersectFilterFunction(geometry, pass_through_holes);
  rtcSetGeometryOccludedFilterFunction(geometry, pass_through_holes);
}

void RayTrees::add_places(Progress& progress) {
  for (std::uint32_t k = 0; k < plants_.size(); ++k) {
    const PlacedPlant& plant = plants_[k];
    commit(plant.tree, progress);
    for (std::uint32_t place = 0; place < plant.places->size(); ++place) {
      const auto& [axes, origin] = (*plant.places)[place];
      if (glm::determinant(axes) == 0) continue;
      const GeometryOwner owner(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
      rtcSetGeometryInstancedScene(owner.get(), plant.tree.get());
      const float columns[12] = {axes[0].x, axes[0].y, axes[0].z, axes[1].x, axes[1].y, axes[1].z,
                                 axes[2].x, axes[2].y, axes[2].z, origin.x,  origin.y,  origin.z};
      rtcSetGeometryTransform(owner.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
      rtcCommitGeometry(owner.get());
      rtcAttachGeometry(top_.get(), owner.get());
      geometries_.push_back({.plant = k, .place = place});
      if (place % 4096 == 0) progress.check();
    }
  }
}

std::optional<RayHit> RayTrees::first_hit(const Ray& ray) const {
  RTCRayHit query;
  query.ray = ray_to(ray, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  HitContext context;
  find_first_hit(top_.get(), context, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const bool is_placed = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  const TopGeometry& top = geometries_[is_placed ? query.hit.instID[0] : query.hit.geomID];
  const Geometry geometry = is_placed ? plants_[top.plant].geometries[query.hit.geomID] : *top.of_part;
  const MeshInstances& part = scene_.meshes[geometry.part];
  const auto triangles = static_cast<std::uint32_t>(part.mesh->triangle_count());
  const std::uint32_t frame = geometry.is_instanced ? context.frame : query.hit.primID / triangles;
  return RayHit{.distance = query.ray.tfar,
                .part = geometry.part,
                .instance = top.place * static_cast<std::uint32_t>(part.frames.size()) + frame,
                .triangle = geometry.is_instanced ? query.hit.primID : query.hit.primID % triangles,
                .barycentric = Vec2(query.hit.u, query.hit.v)};
}

bool RayTrees::is_blocked(const Ray& ray, float within) const {
  RTCRay query = ray_to(ray, within);
  HitContext context;
  find_any_hit(top_.get(), context, query);
  return query.tfar < 0;
}

std::uint64_t RayTrees::bytes() const { return static_cast<std::uint64_t>(std::max<std::int64_t>(0, bytes_)); }

}  // namespace meristem
