// SPDX-License-Identifier: Apache-2.0
// Simplifies a small plant as a whole. All instances of all meshes become one soup of triangles that share points where
// they meet. After simplification, the soup is divided again into meshes by component, material and tint.
#include "meristem/shape/detail/small_detail.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "meristem/shape/mesh/tangents.h"
#include "meristem/shape/outline/outline_collapse.h"

namespace meristem {

namespace {

constexpr float kMeets = 5e-4F;        // share of the plant's size: nearer points are joined
constexpr float kFlatCosine = 0.999F;  // cosine between the normals of a face and its corners

/// The common properties of the faces of one mesh of a level.
struct Look {
  std::string component;
  std::uint32_t material = 0;
  Vec3 tint{1};
  std::uint32_t individual = 0;
  bool is_flat = true;
  bool has_uvs = false;

  bool operator==(const Look& other) const {
    return component == other.component && material == other.material && tint == other.tint &&
           individual == other.individual;
  }
};

class Flattened {
 public:
  explicit Flattened(const MeshScene& scene) {
    for (const MeshInstances& part : scene.meshes) {
      for (std::size_t k = 0; k < part.frames.size(); ++k) add(part, k);
    }
    const Box box = scene.bounds();
    join_points(kMeets * glm::length(box.size()));
  }

  FaceSoup take_soup() { return std::move(soup_); }

  /// Returns the meshes of the remaining soup.
  std::vector<MeshInstances> meshes(const FaceSoup& left, const std::vector<Material>& materials) const {
    std::vector<MeshInstances> made;
    for (std::uint32_t k = 0; k < looks_.size(); ++k) {
      Mesh mesh = mesh_of(left, k);
      if (mesh.triangles.empty()) continue;
      if (needs_tangents(materials[looks_[k].material])) add_tangents(mesh);
      MeshInstances& instances = made.emplace_back();
      instances.component = looks_[k].component;
      instances.mesh = std::make_shared<const Mesh>(std::move(mesh));
      instances.material = looks_[k].material;
      instances.frames = {Frame{}};
      if (looks_[k].tint != Vec3(1)) instances.tints = {looks_[k].tint};
      if (looks_[k].individual != 0) instances.individuals = {looks_[k].individual};
    }
    return made;
  }

 private:
  std::uint32_t number_of(const Look& look) {
    const auto found = std::find(looks_.begin(), looks_.end(), look);
    if (found != looks_.end()) return static_cast<std::uint32_t>(found - looks_.begin());
    looks_.push_back(look);
    return static_cast<std::uint32_t>(looks_.size() - 1);
  }

  std::uint32_t group_of(const Look& look) {
    const std::pair<std::string, std::uint32_t> key(look.component, look.material);
    return groups_.try_emplace(key, static_cast<std::uint32_t>(groups_.size())).first->second;
  }

  void add(const MeshInstances& part, std::size_t instance) {
    const Frame& frame = part.frames[instance];
    Look wanted;
    wanted.component = part.component;
    wanted.material = part.material;
    wanted.tint = part.tint(instance);
    wanted.individual = part.individual(instance);
    const std::uint32_t number = number_of(wanted);
    Look& look = looks_[number];
    const std::uint32_t group = group_of(look);
    const Mesh& mesh = *part.mesh;
    const auto first = static_cast<std::uint32_t>(soup_.points.size());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      soup_.points.push_back(frame.point(mesh.positions[v]));
      soup_.corner_normals.push_back(mesh.normals.empty() ? Vec3(0) : frame.normal(mesh.normals[v]));
      soup_.corner_uvs.push_back(mesh.uvs.empty() ? Vec2(0) : mesh.uvs[v]);
    }
    look.has_uvs = look.has_uvs || !mesh.uvs.empty();
    const bool is_mirrored = glm::determinant(frame.axes) < 0;
    for (auto [a, b, c] : mesh.triangles) {
      if (is_mirrored) std::swap(b, c);
      const std::array<std::uint32_t, 3> points{first + a, first + b, first + c};
      soup_.faces.push_back({points, points, group, number});
      const Vec3 normal = face_normal(soup_, points);
      look.is_flat =
          look.is_flat && std::all_of(points.begin(), points.end(), [&](std::uint32_t corner) {
            return mesh.normals.empty() || std::abs(glm::dot(normal, soup_.corner_normals[corner])) > kFlatCosine;
          });
    }
  }

  static Vec3 face_normal(const FaceSoup& soup, const std::array<std::uint32_t, 3>& points) {
    const Vec3 a = soup.points[points[0]];
    return normalized_or(glm::cross(soup.points[points[1]] - a, soup.points[points[2]] - a), kUp);
  }

  /// Joins points of one group that are near each other. The first point is kept.
  void join_points(float reach) {
    std::vector<std::uint32_t> group(soup_.points.size(), std::numeric_limits<std::uint32_t>::max());
    for (const FaceSoup::Face& face : soup_.faces) {
      for (const std::uint32_t point : face.points) group[point] = face.group;
    }
    std::vector<std::uint32_t> order(soup_.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return soup_.points[a].x < soup_.points[b].x; });
    std::vector<std::uint32_t> joined(soup_.points.size());
    std::iota(joined.begin(), joined.end(), 0);
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::uint32_t point = order[k];
      for (std::size_t back = k; back-- > 0;) {
        const std::uint32_t other = order[back];
        if (soup_.points[point].x - soup_.points[other].x > reach) break;
        if (joined[other] != other || group[other] != group[point]) continue;
        if (glm::distance(soup_.points[point], soup_.points[other]) > reach) continue;
        joined[point] = other;
        break;
      }
    }
    for (FaceSoup::Face& face : soup_.faces) {
      for (std::uint32_t& point : face.points) point = joined[point];
    }
    std::erase_if(soup_.faces, [](const FaceSoup::Face& face) {
      const auto& [a, b, c] = face.points;
      return a == b || b == c || c == a;
    });
  }

  Mesh mesh_of(const FaceSoup& left, std::uint32_t number) const {
    const Look& look = looks_[number];
    Mesh mesh;
    std::map<std::tuple<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    for (const FaceSoup::Face& face : left.faces) {
      if (face.look != number) continue;
      std::array<std::uint32_t, 3> triangle{};
      const Vec3 normal = face_normal(left, face.points);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto next = static_cast<std::uint32_t>(mesh.vertex_count());
        triangle[k] = next;
        if (!look.is_flat) {
          const auto [vertex, is_new] = known.try_emplace({face.points[k], face.corners[k]}, next);
          triangle[k] = vertex->second;
          if (!is_new) continue;
        }
        mesh.positions.push_back(left.points[face.points[k]]);
        mesh.normals.push_back(look.is_flat ? normal : left.corner_normals[face.corners[k]]);
        if (look.has_uvs) mesh.uvs.push_back(left.corner_uvs[face.corners[k]]);
      }
      mesh.triangles.push_back(triangle);
    }
    return mesh;
  }

  FaceSoup soup_;
  std::vector<Look> looks_;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> groups_;
};

}  // namespace

MeshScene small_detail(const MeshScene& whole, const MeshDetail& detail, Progress& progress) {
  Flattened plant(whole);
  const auto all = static_cast<double>(whole.triangle_count());
  progress.begin("simplifying", static_cast<std::uint64_t>(detail.level));
  OutlineCollapse collapse(plant.take_soup(), progress);
  for (int level = 1; level <= detail.level; ++level) {
    collapse.run(static_cast<std::size_t>(detail.kept(level) * all), progress);
    progress.advance();
  }
  return {whole.materials, plant.meshes(collapse.soup(), whole.materials), whole.individuals};
}

}  // namespace meristem
