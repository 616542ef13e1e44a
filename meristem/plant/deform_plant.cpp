// SPDX-License-Identifier: Apache-2.0
// Deforms stems and organs of a grown plant. Organs are processed in batches of some thousand vertices, and each batch
// passes through the levels of the deformation in order. A level on geometry moves each vertex. A level on axes moves
// and rotates the whole organ with its base. The centre of each organ collects the Jacobian of all levels: the affine
// map that replaces the deformation if it is close enough.
#include "meristem/plant/deform_plant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/matrix.hpp>

#include "meristem/base/deform/polar.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/operation_record.h"

namespace meristem {

namespace {

constexpr std::size_t kNodesTogether = 512;
constexpr std::size_t kNodesPerBlock = 8192;
constexpr std::size_t kVerticesTogether = 2048;  // vertices in one task
constexpr std::size_t kTasksTogether = 512;      // tasks between two checks of the limit of bytes

using DeformationPointer = std::shared_ptr<const Deformation>;

DMat3 cofactors(const DMat3& m) { return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])}; }

/// A deformation of stem nodes, and the component that error messages name.
struct Bend {
  DeformationPointer deformation;
  const std::string* who = nullptr;
};

/// Returns the direction of the segment that ends in each node. A root has the direction of the segment above it.
std::vector<DVec3> directions_of(const Skeleton& skeleton) {
  std::vector<DVec3> directions(skeleton.node_count(), DVec3(kUp));
  for (auto node = static_cast<NodeIndex>(skeleton.node_count()); node-- > 0;) {
    // The first child, which has a higher index, has written the root's direction.
    if (skeleton.is_root(node)) continue;
    const NodeIndex parent = skeleton.parent[node];
    directions[node] = DVec3(normalized_or(skeleton.position[node] - skeleton.position[parent], kUp));
    if (skeleton.is_root(parent)) directions[parent] = directions[node];
  }
  return directions;
}

/// Returns the length factor of a cross-section at right angles to the unit vector `along`.
double stretch_across(const DMat3& jacobian, const DVec3& along) {
  return std::sqrt(glm::determinant(jacobian) / glm::length(jacobian * along));
}

/// Moves the nodes. If `directions` is not empty, also scales their radii.
void bend_nodes(Skeleton& skeleton, std::span<const NodeIndex> nodes, const Bend& bend,
                std::span<const DVec3> directions) {
  parallel_for(nodes.size(), kNodesPerBlock, [&](std::size_t begin, std::size_t end) {
    std::array<DVec3, kNodesTogether> points;
    std::array<DMat3, kNodesTogether> jacobians;
    for (std::size_t first = begin; first < end; first += kNodesTogether) {
      const std::size_t count = std::min(kNodesTogether, end - first);
      for (std::size_t k = 0; k < count; ++k) points[k] = DVec3(skeleton.position[nodes[first + k]]);
      bend.deformation->map(std::span(points).first(count), std::span(jacobians).first(count), *bend.who);
      for (std::size_t k = 0; k < count; ++k) {
        const NodeIndex node = nodes[first + k];
        skeleton.position[node] = Vec3(points[k]);
        if (directions.empty() || jacobians[k] == DMat3(1)) continue;
        skeleton.radius[node] *= static_cast<float>(stretch_across(jacobians[k], directions[node]));
      }
    }
  });
}

/// Moves and rotates the operation records of a stem with the place where each was done.
void bend_records(Skeleton& skeleton, const Stem& stem, std::span<const DeformationPointer> of_part) {
  for (OperationRecord& record : skeleton.operations) {
    if (of_part[record.part] == nullptr) continue;
    DVec3 point(record.position);
    DMat3 jacobian(1);
    of_part[record.part]->map(std::span(&point, 1), std::span(&jacobian, 1), stem.parts[record.part].component);
    const DVec3 to_bud = jacobian * DVec3(record.bud_position - record.position);
    record.position = Vec3(point);
    record.bud_position = Vec3(point + to_bud);
    record.bud = normalized_or(Vec3(jacobian * DVec3(record.bud)), Vec3(0));
  }
}

/// Moves the nodes of each part by the deformation of the part. Parts with equal deformation and component are moved
/// together.
void bend(Skeleton& skeleton, const Stem& stem, std::span<const DeformationPointer> of_part, bool thickens) {
  std::vector<Bend> bends;
  std::map<std::pair<const Deformation*, std::string_view>, std::size_t> number;
  std::vector<std::size_t> bend_of_part(of_part.size(), ~std::size_t{0});
  for (std::size_t part = 0; part < of_part.size(); ++part) {
    if (of_part[part] == nullptr) continue;
    const std::string& component = stem.parts[part].component;
    const auto [known, is_new] = number.try_emplace({of_part[part].get(), component}, bends.size());
    if (is_new) bends.push_back({of_part[part], &component});
    bend_of_part[part] = known->second;
  }
  std::vector<std::vector<NodeIndex>> nodes(bends.size());
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const std::size_t own = bend_of_part[stem.part_index(skeleton.axis[node])];
    if (own < bends.size()) nodes[own].push_back(node);
  }
  const std::vector<DVec3> directions = thickens ? directions_of(skeleton) : std::vector<DVec3>();
  for (std::size_t k = 0; k < bends.size(); ++k) bend_nodes(skeleton, nodes[k], bends[k], directions);
  bend_records(skeleton, stem, of_part);
}

bool is_any(std::span<const DeformationPointer> of_part) {
  return std::any_of(of_part.begin(), of_part.end(), [](const DeformationPointer& one) { return one != nullptr; });
}

}  // namespace

void deform(Stem& stem, std::span<const DeformationPointer> of_part) {
  if (!is_any(of_part)) return;
  // A deformation of axes applies to the surface, too, unless the surface is already deformed.
  std::unordered_map<const Deformation*, std::array<DeformationPointer, 2>> halves;
  std::vector<DeformationPointer> of_axes(of_part.size()), of_surface(of_part.size());
  for (std::size_t part = 0; part < of_part.size(); ++part) {
    if (of_part[part] == nullptr) continue;
    if (stem.parts[part].deformation != nullptr) {
      of_surface[part] = of_part[part];
      continue;
    }
    const auto [known, is_new] = halves.try_emplace(of_part[part].get());
    if (is_new) known->second = {of_part[part]->of_axes(), of_part[part]->of_surface()};
    of_axes[part] = known->second[0];
    of_surface[part] = known->second[1];
  }
  if (is_any(of_axes)) {
    bend(stem.skeleton, stem, of_axes, false);
    if (stem.undeformed != nullptr) {
      Skeleton undeformed = *stem.undeformed;
      bend(undeformed, stem, of_axes, false);
      stem.undeformed = std::make_shared<const Skeleton>(std::move(undeformed));
    }
  }
  if (!is_any(of_surface)) return;
  if (stem.undeformed == nullptr) stem.undeformed = std::make_shared<const Skeleton>(stem.skeleton);
  bend(stem.skeleton, stem, of_surface, true);
  for (std::size_t part = 0; part < of_part.size(); ++part) {
    stem.parts[part].deformation = Deformation::nested(stem.parts[part].deformation, of_surface[part]);
  }
}

void deform(std::span<Frame> frames, const Deformation& of_axes, std::string_view who) {
  std::vector<DVec3> points(frames.size());
  std::vector<DMat3> jacobians(frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) points[k] = DVec3(frames[k].origin);
  for (const Deformation::Level& level : of_axes.levels()) {
    Deformation::map(level, points, jacobians, who);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      if (jacobians[k] == DMat3(1)) continue;
      frames[k].axes = Mat3(nearest_rotation(jacobians[k]) * DMat3(frames[k].axes));
    }
  }
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k].origin = Vec3(points[k]);
}

namespace {

/// A batch of organs that are deformed together.
struct Task {
  const DeformedOrgans* row = nullptr;
  std::size_t first = 0;
  std::size_t count = 0;
  bool is_rigid = false;
  std::vector<std::pair<std::size_t, std::shared_ptr<const Mesh>>> made;  // organs that get their own mesh
};

bool is_rigid(const Deformation& deformation) {
  return std::ranges::all_of(deformation.levels(),
                             [](const Deformation::Level& level) { return level.part == DeformedPart::axes; });
}

void move_rigidly(Plant& plant, const Task& task) {
  std::vector<Frame> frames(task.count);
  for (std::size_t k = 0; k < task.count; ++k) frames[k] = plant.organs[task.first + k].frame;
  deform(frames, *task.row->deformation, plant.prototypes[plant.organs[task.first].prototype].component);
  for (std::size_t k = 0; k < task.count; ++k) plant.organs[task.first + k].frame = frames[k];
}

/// The vertices of a batch of organs while they pass through the levels. Each organ's vertices are followed by its
/// centre and its base.
class MovedOrgans {
 public:
  MovedOrgans(Plant& plant, Task& task) : plant_(plant), task_(task) {
    for (std::size_t k = 0; k < task.count; ++k) {
      begin_.push_back(points_.size());
      const Frame& frame = organ(k).frame;
      Box box;
      for (const Vec3 position : mesh(k).positions) {
        points_.push_back(DVec3(frame.origin) + DMat3(frame.axes) * DVec3(position));
        box.add(position);
      }
      points_.push_back(DVec3(frame.point(box.is_empty() ? Vec3(0) : box.centre())));
      points_.push_back(DVec3(frame.origin));
    }
    begin_.push_back(points_.size());
    before_ = points_;
    jacobians_.assign(points_.size(), DMat3(1));
  }

  void run() {
    const std::string& who = plant_.prototypes[organ(0).prototype].component;
    for (const Deformation::Level& level : task_.row->deformation->levels()) {
      level.part == DeformedPart::geometry ? move_vertices(level, who) : move_organs(level, who);
    }
    for (std::size_t k = 0; k < task_.count; ++k) place(k);
  }

 private:
  Organ& organ(std::size_t k) const { return plant_.organs[task_.first + k]; }
  const Mesh& mesh(std::size_t k) const { return *plant_.prototypes[organ(k).prototype].mesh; }
  std::size_t centre(std::size_t k) const { return begin_[k + 1] - 2; }
  std::size_t base(std::size_t k) const { return begin_[k + 1] - 1; }

  void move_vertices(const Deformation::Level& level, const std::string& who) {
    std::vector<DMat3> own(points_.size());
    Deformation::map(level, points_, own, who);
    for (std::size_t i = 0; i < points_.size(); ++i) jacobians_[i] = own[i] * jacobians_[i];
  }

  void move_organs(const Deformation::Level& level, const std::string& who) {
    std::vector<DVec3> bases;
    for (std::size_t k = 0; k < task_.count; ++k) bases.push_back(points_[base(k)]);
    std::vector<DMat3> own(bases.size());
    std::vector<DVec3> moved = bases;
    Deformation::map(level, moved, own, who);
    for (std::size_t k = 0; k < task_.count; ++k) {
      const DMat3 rotation = nearest_rotation(own[k]);
      for (std::size_t i = begin_[k]; i < begin_[k + 1]; ++i) {
        points_[i] = moved[k] + rotation * (points_[i] - bases[k]);
        jacobians_[i] = rotation * jacobians_[i];
      }
    }
  }

  /// Sets the frame of an organ from the affine map at its centre. If the map is not close enough, makes a mesh for the
  /// organ.
  void place(std::size_t k) {
    const DMat3& affine = jacobians_[centre(k)];
    const DVec3 from = before_[centre(k)], to = points_[centre(k)];
    double error2 = 0, size2 = 0;
    for (std::size_t i = begin_[k]; i < centre(k); ++i) {
      error2 = std::max(error2, squared_length(points_[i] - (to + affine * (before_[i] - from))));
      size2 = std::max(size2, squared_length(points_[i] - to));
    }
    Frame& frame = organ(k).frame;
    if (!(error2 > kAffineTolerance * kAffineTolerance * size2)) {
      if (affine == DMat3(1) && from == to) return;
      frame = {Mat3(affine * DMat3(frame.axes)), Vec3(to + affine * (DVec3(frame.origin) - from))};
      return;
    }
    const Frame moved{Mat3(nearest_rotation(affine) * DMat3(frame.axes)), Vec3(points_[base(k)])};
    task_.made.emplace_back(task_.first + k, std::make_shared<const Mesh>(mesh_in(moved, k)));
    frame = moved;
  }

  /// Returns the deformed mesh of organ `k` in the frame `moved`.
  Mesh mesh_in(const Frame& moved, std::size_t k) const {
    Mesh made = mesh(k);
    const Frame& frame = organ(k).frame;
    const DMat3 axes(moved.axes), inverse = glm::inverse(axes), turned = glm::transpose(axes);
    for (std::size_t i = 0; i < made.vertex_count(); ++i) {
      const DMat3& jacobian = jacobians_[begin_[k] + i];
      made.positions[i] = Vec3(inverse * (points_[begin_[k] + i] - DVec3(moved.origin)));
      Vec3 normal(0);
      if (!made.normals.empty()) {
        const DVec3 world = cofactors(jacobian) * DVec3(frame.normal(made.normals[i]));
        made.normals[i] = normal = normalized_or(Vec3(turned * world), made.normals[i]);
      }
      if (!made.tangents.empty()) {
        const Vec4 old = made.tangents[i];
        const Vec3 along(inverse * (jacobian * DVec3(frame.vector(Vec3(old)))));
        made.tangents[i] = Vec4(normalized_or(along - glm::dot(along, normal) * normal, Vec3(old)), old.w);
      }
    }
    return made;
  }

  Plant& plant_;
  Task& task_;
  std::vector<std::size_t> begin_;  // index of each organ's first point
  std::vector<DVec3> points_, before_;
  std::vector<DMat3> jacobians_;
};

/// Divides rows into tasks of organs of one component, with some thousand vertices each.
std::vector<Task> tasks_of(const Plant& plant, std::span<const DeformedOrgans> rows) {
  std::vector<Task> tasks;
  for (const DeformedOrgans& row : rows) {
    const bool rigid = is_rigid(*row.deformation);
    std::size_t vertices = kVerticesTogether;  // full, so that each row begins a new task
    const std::string* component = nullptr;
    for (std::size_t organ = row.first; organ < row.first + row.count; ++organ) {
      const OrganPrototype& prototype = plant.prototypes[plant.organs[organ].prototype];
      const bool is_other = component == nullptr || prototype.component != *component;
      if (vertices >= kVerticesTogether || is_other) {
        tasks.push_back({.row = &row, .first = organ, .is_rigid = rigid, .made = {}});
        vertices = 0;
      }
      component = &prototype.component;
      ++tasks.back().count;
      vertices += rigid ? 1 : prototype.mesh->vertex_count() + 2;
    }
  }
  return tasks;
}

}  // namespace

void deform_organs(Plant& plant, std::span<const DeformedOrgans> rows, std::uint64_t mesh_bytes,
                   const SizeLimits& limits, const Progress& progress) {
  std::vector<Task> tasks = tasks_of(plant, rows);
  for (std::size_t begin = 0; begin < tasks.size(); begin += kTasksTogether) {
    const std::size_t count = std::min(kTasksTogether, tasks.size() - begin);
    parallel_for(count, 1, [&](std::size_t first, std::size_t end) {
      for (std::size_t k = first; k < end; ++k) {
        progress.check();
        Task& task = tasks[begin + k];
        task.is_rigid ? move_rigidly(plant, task) : MovedOrgans(plant, task).run();
      }
    });
    for (std::size_t k = begin; k < begin + count; ++k) {
      for (auto& [organ, mesh] : tasks[k].made) {
        OrganPrototype made = plant.prototypes[plant.organs[organ].prototype];
        mesh_bytes += mesh->bytes();
        if (mesh_bytes > limits.mesh_bytes) {
          throw_limit("bytes of deformed shapes", static_cast<double>(mesh_bytes), limits.mesh_bytes, "mesh_bytes",
                      "components." + made.component);
        }
        made.mesh = std::move(mesh);
        plant.organs[organ].prototype = static_cast<std::uint32_t>(plant.prototypes.size());
        plant.prototypes.push_back(std::move(made));
      }
      tasks[k].made = {};
    }
  }
}

}  // namespace meristem
