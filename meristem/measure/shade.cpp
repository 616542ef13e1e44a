// SPDX-License-Identifier: Apache-2.0
// In:  points on a surface, the sun's positions, plants and obstacles. Out: the share in shade, by position and by
// point.
//
// A ray from each point is tested against the obstacles first, and against the plants only if the obstacles let the
// light pass. The share without plants therefore costs nothing more. Points and positions are cut into blocks whose
// sizes depend only on the numbers of points and positions. The blocks' sums are added in order.
#include "meristem/measure/shade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "meristem/base/math.h"
#include "meristem/base/mesh.h"
#include "meristem/base/parallel.h"
#include "meristem/measure/surface_points.h"
#include "meristem/shape/rays/ray_scene.h"

namespace meristem {
namespace {

constexpr std::size_t kPointsPerBlock = 1024;
constexpr std::size_t kMomentsPerBlock = 64;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns twice the area vector of a triangle, along its front.
DVec3 double_area(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const DVec3 corner = mesh.positions[triangle[0]];
  return glm::cross(mesh.positions[triangle[1]] - corner, mesh.positions[triangle[2]] - corner);
}

/// Returns true if the triangles of a closed mesh face inward. Such a mesh encloses the same space.
bool faces_inward(const TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& triangle : mesh.triangles)
    volume += glm::dot(mesh.positions[triangle[0]], double_area(mesh, triangle));
  return volume < 0;
}

bool belongs(DVec3 normal, FacadeSide side, std::optional<double> azimuth) {
  constexpr double kHalf = 0.70710678118654752;  // cosine of 45°
  const double level = std::sqrt(normal.x * normal.x + normal.z * normal.z);
  const bool is_wall = level > std::abs(normal.y);
  const auto looks = [&](double east, double north) {
    return is_wall && normal.x * east - normal.z * north >= kHalf * level;
  };
  if (azimuth) return looks(math::sin(*azimuth), math::cos(*azimuth));
  switch (side) {
    case FacadeSide::walls:
      return is_wall;
    case FacadeSide::north:
      return looks(0, 1);
    case FacadeSide::east:
      return looks(1, 0);
    case FacadeSide::south:
      return looks(0, -1);
    case FacadeSide::west:
      return looks(-1, 0);
    case FacadeSide::roof:
      return !is_wall && normal.y > 0;
    case FacadeSide::all:
      return true;
  }
  return false;
}

/// Returns the faces of a body that belong to a side, turned outward.
Mesh facade_faces(const TriangleMesh& body, FacadeSide side, std::optional<double> azimuth) {
  const bool is_turned = faces_inward(body);
  Mesh faces;
  for (const DVec3 position : body.positions) faces.positions.emplace_back(position);
  for (auto triangle : body.triangles) {
    if (is_turned) std::swap(triangle[1], triangle[2]);
    if (belongs(double_area(body, triangle), side, azimuth)) faces.triangles.push_back(triangle);
  }
  return faces;
}

int cells(double length, double spacing) { return std::max(1, static_cast<int>(std::lround(length / spacing))); }

/// The sums of blocks of positions and points.
struct BlockSums {
  std::vector<std::uint32_t> shaded;          // for each position in the block: number of points in shade
  std::vector<std::uint32_t> shaded_without;  // like `shaded`, without plants
  std::vector<double> cosine;
  std::vector<double> direct;
  std::vector<std::uint32_t> point_shaded;  // for each point in the block: number of positions with shade
  std::vector<std::uint32_t> point_shaded_without;
};

class ShadeRays {
 public:
  ShadeRays(const ShadeSurface& surface, const MeshScene& plants, const Obstacles& obstacles, Progress& progress)
      : surface_(surface), obstacles_(obstacles), has_plants_(!plants.meshes.empty()), plants_(plants, progress) {}

  void ask(std::size_t point, std::size_t k, Vec3 toward, std::size_t m, BlockSums& sums) const {
    const Vec3 position = surface_.positions[point];
    const Vec3 normal = surface_.normals[point];
    const double cosine = glm::dot(DVec3(normal), DVec3(toward));
    const auto add_shade = [&](bool by_plants) {
      ++sums.shaded[m];
      ++sums.point_shaded[k];
      if (by_plants) return;
      ++sums.shaded_without[m];
      ++sums.point_shaded_without[k];
    };
    if (!(cosine > 0)) return add_shade(false);
    sums.cosine[m] += cosine;
    const Vec3 start = position + RayScene::clearance(position) * normal;
    if (obstacles_.block(start, toward, kInfinity)) return add_shade(false);
    if (has_plants_ && plants_.is_blocked({start, toward})) return add_shade(true);
    sums.direct[m] += cosine;
  }

 private:
  const ShadeSurface& surface_;
  const Obstacles& obstacles_;
  bool has_plants_;
  RayScene plants_;
};

}  // namespace

double facade_area(const Obstacles& obstacles, std::size_t obstacle, FacadeSide side, std::optional<double> azimuth) {
  const Mesh faces = facade_faces(obstacles.bodies().at(obstacle).mesh, side, azimuth);
  return SurfacePoints(faces).area();
}

ShadeSurface facade_surface(const Obstacles& obstacles, std::size_t obstacle, FacadeSide side,
                            std::optional<double> azimuth, double spacing) {
  const Mesh faces = facade_faces(obstacles.bodies().at(obstacle).mesh, side, azimuth);
  ShadeSurface surface;
  const SurfacePoints points(faces);
  const auto count = static_cast<std::size_t>(std::ceil(points.area() / (spacing * spacing)));
  for (std::size_t k = 0; k < count; ++k) {
    const auto point = points.at((static_cast<double>(k) + 0.5) / static_cast<double>(count),
                                 fraction(0.5 + static_cast<double>(k) * kGoldenStep));
    const Vec3 position = points.position(point);
    const auto [a, b, c] = faces.triangles[point.triangle];
    const Vec3 normal = normalized_or(
        glm::cross(faces.positions[b] - faces.positions[a], faces.positions[c] - faces.positions[a]), kUp);
    if (position.y < 0 || obstacles.contain(position + RayScene::clearance(position) * normal)) continue;
    surface.positions.push_back(position);
    surface.normals.push_back(normal);
  }
  if (count > 0) {
    surface.area = points.area() * static_cast<double>(surface.positions.size()) / static_cast<double>(count);
  }
  return surface;
}

ShadeSurface joined(const std::vector<ShadeSurface>& surfaces) {
  ShadeSurface all;
  for (const ShadeSurface& surface : surfaces) {
    all.positions.insert(all.positions.end(), surface.positions.begin(), surface.positions.end());
    all.normals.insert(all.normals.end(), surface.normals.begin(), surface.normals.end());
    all.area += surface.area;
  }
  return all;
}

ShadeSurface panel_surface(const PanelField& panels, double spacing) {
  const DVec3 front(unit_vector({panels.azimuth, 0}));
  const DVec3 right = glm::cross(DVec3(kUp), front);  // as seen from the front
  const DVec3 normal = math::cos(panels.tilt) * DVec3(kUp) + math::sin(panels.tilt) * front;
  const DVec3 up = glm::cross(normal, right);
  ShadeSurface surface{.area = panels.width * panels.length,
                       .columns = cells(panels.width, spacing),
                       .rows = cells(panels.length, spacing)};
  for (int row = 0; row < surface.rows; ++row) {
    for (int column = 0; column < surface.columns; ++column) {
      const double along = panels.width * ((column + 0.5) / surface.columns - 0.5);
      const double above = panels.length * ((row + 0.5) / surface.rows - 0.5);
      surface.positions.emplace_back(DVec3(panels.position) + along * right + above * up);
      surface.normals.emplace_back(normal);
    }
  }
  surface.has_point.assign(surface.positions.size(), 1);
  return surface;
}

ShadeSurface ground_surface(Vec2 from, Vec2 to, double height, const Obstacles& obstacles, double spacing) {
  const glm::dvec2 low(glm::min(from, to));
  const glm::dvec2 high(glm::max(from, to));
  ShadeSurface surface{.columns = cells(high.x - low.x, spacing), .rows = cells(high.y - low.y, spacing)};
  const double cell = (high.x - low.x) / surface.columns * ((high.y - low.y) / surface.rows);
  for (int row = 0; row < surface.rows; ++row) {
    for (int column = 0; column < surface.columns; ++column) {
      // z grows to the south, but rows count to the north.
      const Vec3 position(low.x + (high.x - low.x) * (column + 0.5) / surface.columns, height,
                          high.y - (high.y - low.y) * (row + 0.5) / surface.rows);
      const bool is_free = !obstacles.contain(position + RayScene::clearance(position) * kUp);
      surface.has_point.push_back(is_free ? 1 : 0);
      if (!is_free) continue;
      surface.positions.push_back(position);
      surface.normals.push_back(kUp);
    }
  }
  surface.area = cell * static_cast<double>(surface.positions.size());
  return surface;
}

ShadeOfSurface measure_shade(const ShadeSurface& surface, const std::vector<SkyDirection>& sun, const MeshScene& plants,
                             const Obstacles& obstacles, Progress& progress) {
  // The directions of the sun above the horizon.
  std::vector<Vec3> toward;
  std::vector<std::size_t> moment_of;
  for (std::size_t k = 0; k < sun.size(); ++k) {
    if (!(sun[k].altitude > 0)) continue;
    toward.push_back(unit_vector(sun[k]));
    moment_of.push_back(k);
  }
  const std::size_t points = surface.positions.size();
  const std::size_t moments = toward.size();
  ShadeOfSurface result{.moments = std::vector<ShadeMoment>(sun.size()),
                        .of_point = std::vector<double>(points, 1),
                        .of_point_without_plants = std::vector<double>(points, 1)};
  if (points == 0 || moments == 0) return result;
  if (points > kMaxShadeRays / moments) throw std::invalid_argument("too many rays for the shade of a surface");

  // Trace rays in blocks of points by positions.
  const std::size_t point_blocks = (points + kPointsPerBlock - 1) / kPointsPerBlock;
  const std::size_t moment_blocks = (moments + kMomentsPerBlock - 1) / kMomentsPerBlock;
  const ShadeRays rays(surface, plants, obstacles, progress);
  progress.begin("measuring shade", points * moments);
  std::vector<BlockSums> blocks(point_blocks * moment_blocks);
  parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t first_point = block / moment_blocks * kPointsPerBlock;
      const std::size_t first_moment = block % moment_blocks * kMomentsPerBlock;
      const std::size_t point_count = std::min(kPointsPerBlock, points - first_point);
      const std::size_t moment_count = std::min(kMomentsPerBlock, moments - first_moment);
      BlockSums& sums = blocks[block];
      sums.shaded.resize(moment_count);
      sums.shaded_without.resize(moment_count);
      sums.cosine.resize(moment_count);
      sums.direct.resize(moment_count);
      sums.point_shaded.resize(point_count);
      sums.point_shaded_without.resize(point_count);
      for (std::size_t k = 0; k < point_count; ++k) {
        for (std::size_t m = 0; m < moment_count; ++m) {
          rays.ask(first_point + k, k, toward[first_moment + m], m, sums);
        }
        progress.advance(moment_count);
      }
    }
  });

  // Add the blocks in their order.
  std::vector<std::uint64_t> of_point(points, 0);
  std::vector<std::uint64_t> of_point_without(points, 0);
  for (ShadeMoment& moment : result.moments) moment = {0, 0, 0, 0};
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const BlockSums& sums = blocks[block];
    for (std::size_t m = 0; m < sums.shaded.size(); ++m) {
      ShadeMoment& moment = result.moments[moment_of[block % moment_blocks * kMomentsPerBlock + m]];
      moment.shade += sums.shaded[m];
      moment.shade_without_plants += sums.shaded_without[m];
      moment.cosine += sums.cosine[m];
      moment.direct += sums.direct[m];
    }
    for (std::size_t k = 0; k < sums.point_shaded.size(); ++k) {
      of_point[block / moment_blocks * kPointsPerBlock + k] += sums.point_shaded[k];
      of_point_without[block / moment_blocks * kPointsPerBlock + k] += sums.point_shaded_without[k];
    }
  }
  const auto count = static_cast<double>(points);
  for (std::size_t k = 0; k < sun.size(); ++k) {
    ShadeMoment& moment = result.moments[k];
    if (!(sun[k].altitude > 0)) {
      moment = {};
      continue;
    }
    moment = {.cosine = moment.cosine / count,
              .shade = moment.shade / count,
              .shade_without_plants = moment.shade_without_plants / count,
              .direct = moment.direct / count};
  }
  for (std::size_t k = 0; k < points; ++k) {
    result.of_point[k] = static_cast<double>(of_point[k]) / static_cast<double>(moments);
    result.of_point_without_plants[k] = static_cast<double>(of_point_without[k]) / static_cast<double>(moments);
  }
  return result;
}

}  // namespace meristem
