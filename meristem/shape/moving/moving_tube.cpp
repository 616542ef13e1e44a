// SPDX-License-Identifier: Apache-2.0
// Resamples tubes to the rings and sides of another tube. Positions along the tube are matched in metres if one tube is
// the beginning of the other, and by share of the length otherwise. The seam around the tube is found by trying turns.
#include "meristem/shape/moving/moving_tube.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meristem {

namespace {

constexpr float kSameWay = 0.05F;     // share of a tube's length: maximum distance of its tip from another tube that it
                                      // begins
constexpr float kTurnedSeam = 0.9F;   // cosine of the turn about the axis beyond which seams are aligned
constexpr std::uint32_t kSeams = 64;  // number of turns that are tried

/// The middle of each ring, and the metres along the middles.
struct Spine {
  std::vector<Vec3> centre;
  std::vector<float> way;

  explicit Spine(const TubeShape& tube) {
    for (std::uint32_t ring = 0; ring < tube.rings; ++ring) {
      Vec3 sum(0);
      for (std::uint32_t side = 0; side < tube.sides; ++side) sum += tube.positions[tube.ring_vertex(ring, side)];
      centre.push_back(sum / static_cast<float>(tube.sides));
      way.push_back(ring == 0 ? 0 : way.back() + glm::distance(centre[ring], centre[ring - 1]));
    }
  }

  float length() const { return way.back(); }
  /// Returns the ring before a position, and the share of the distance to the next ring.
  std::pair<std::uint32_t, float> at(float place) const {
    const auto after = std::upper_bound(way.begin(), way.end(), place);
    const auto last = static_cast<std::uint32_t>(way.size() - 1);
    if (after == way.end()) return {last, 0};
    const auto ring = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(0, after - way.begin() - 1));
    const float length = way[ring + 1] - way[ring];
    return {ring, length > 0 ? std::clamp((place - way[ring]) / length, 0.0F, 1.0F) : 0};
  }
  Vec3 point(float place) const {
    const auto [ring, share] = at(place);
    return share > 0 ? glm::mix(centre[ring], centre[ring + 1], share) : centre[ring];
  }
};

/// Reads a tube at any position along and around it.
class TubeReader {
 public:
  TubeReader(const TubeShape& tube, const Spine& spine, const TubeShape& model, const Spine& of_model)
      : tube_(tube), spine_(spine) {
    find_seam(model, of_model);
  }

  /// Reads the vertex at a share of the circumference of the ring at this position.
  void read(float place, float around, Vec3& position, Vec3& normal) const {
    const auto [ring, share] = spine_.at(place);
    position = around_ring(tube_.positions, ring, around);
    normal = around_ring(tube_.normals, ring, around);
    if (share > 0) {
      position = glm::mix(position, around_ring(tube_.positions, ring + 1, around), share);
      normal = glm::mix(normal, around_ring(tube_.normals, ring + 1, around), share);
    }
    normal = unit_or(normal, tube_.normals[tube_.ring_vertex(ring, 0)]);
  }

 private:
  Vec3 around_ring(const std::vector<Vec3>& values, std::uint32_t ring, float around) const {
    const float turned = around + seam_;
    const float side = (turned - std::floor(turned)) * static_cast<float>(tube_.sides);
    const auto before = std::min(static_cast<std::uint32_t>(side), tube_.sides - 1);
    const float share = side - static_cast<float>(before);
    const Vec3 value = values[tube_.ring_vertex(ring, before)];
    return share > 0 ? glm::mix(value, values[tube_.ring_vertex(ring, before + 1)], share) : value;
  }

  /// Finds the position of the model's first corner around the tube. Bent tubes may begin at different sides.
  void find_seam(const TubeShape& model, const Spine& of_model) {
    const std::uint32_t ring = std::min(tube_.rings, model.rings) / 2;
    const Vec3 wanted = unit_or(model.positions[model.ring_vertex(ring, 0)] - of_model.centre[ring], Vec3(0));
    const auto likeness = [&](float seam) {
      seam_ = seam;
      return glm::dot(unit_or(around_ring(tube_.positions, ring, 0) - spine_.centre[ring], Vec3(0)), wanted);
    };
    float best = 0;
    float max = likeness(0);
    for (std::uint32_t k = 1; k < kSeams && max < kTurnedSeam; ++k) {
      const float seam = static_cast<float>(k) / kSeams;
      const float like = likeness(seam);
      if (like <= max) continue;
      max = like;
      best = seam;
    }
    seam_ = best;
  }

  const TubeShape& tube_;
  const Spine& spine_;
  float seam_ = 0;
};

/// The position of each ring of the model along the tube, and the first of the rings that lie together at its tip.
struct RingPlaces {
  std::vector<float> places;
  std::size_t first_beyond = 0;
};

RingPlaces places_of_rings(const Spine& tube, const Spine& model) {
  const float length = tube.length();
  const Vec3 tip = tube.centre.back();
  const bool begins_it = length <= model.length() * (1 + kSameWay) &&
                         glm::distance(model.point(length), tip) <= kSameWay * std::max(length, model.length());
  const float stretch = model.length() > 0 ? length / model.length() : 1;
  RingPlaces rings{.places = {}, .first_beyond = model.way.size()};
  for (std::size_t ring = 0; ring < model.way.size(); ++ring) {
    const float way = model.way[ring];
    rings.places.push_back(begins_it ? std::min(way, length) : way * stretch);
    if (begins_it && way > length) rings.first_beyond = std::min(rings.first_beyond, ring);
  }
  rings.places.back() = length;
  return rings;
}

}  // namespace

std::optional<TubeShape> tube_shape(const TubePlan& plan, AxisIndex axis, const std::vector<Mesh>& meshes) {
  const AxisPlan& own = plan[axis];
  if (own.rings == 0) return std::nullopt;
  const bool is_lateral = plan.path(axis).is_lateral();
  TubeShape tube;
  tube.sides = own.sides;
  tube.rings = own.rings;
  tube.start_vertices = static_cast<std::uint32_t>(own.start_vertices(is_lateral));
  tube.end_vertices = own.cap == SurfaceOptions::Cap::flat ? own.sides + 1 : own.sides;
  const Mesh& mesh = meshes[own.mesh];
  const auto first = static_cast<std::ptrdiff_t>(own.first_vertex);
  const auto end = first + static_cast<std::ptrdiff_t>(own.vertices(is_lateral));
  tube.positions.assign(mesh.positions.begin() + first, mesh.positions.begin() + end);
  tube.normals.assign(mesh.normals.begin() + first, mesh.normals.begin() + end);
  tube.uvs.assign(mesh.uvs.begin() + first, mesh.uvs.begin() + end);
  return tube;
}

std::size_t fullest_shape(const std::vector<std::shared_ptr<const TubeShape>>& shapes) {
  std::size_t best = 0;
  std::size_t max = 0;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const std::size_t vertices = shapes[k] ? shapes[k]->positions.size() : 0;
    if (vertices < max) continue;
    max = vertices;
    best = k;
  }
  return best;
}

void add_tube_triangles(const TubeShape& tube, std::uint32_t first, Mesh& to) {
  const std::uint32_t sides = tube.sides;
  const bool is_lateral = tube.start_vertices == 1;
  const std::uint32_t rim = first + (is_lateral ? tube.ring_vertex(0, 0) : 1);
  for (std::uint32_t k = 0; k < sides; ++k) {
    const std::uint32_t next = is_lateral ? k + 1 : (k + 1) % sides;
    to.triangles.push_back({first, rim + next, rim + k});
  }
  for (std::uint32_t ring = 1; ring < tube.rings; ++ring) {
    const std::uint32_t lower = first + tube.ring_vertex(ring - 1, 0);
    const std::uint32_t upper = first + tube.ring_vertex(ring, 0);
    for (std::uint32_t k = 0; k < sides; ++k) {
      to.triangles.push_back({lower + k, lower + k + 1, upper + k + 1});
      to.triangles.push_back({lower + k, upper + k + 1, upper + k});
    }
  }
  const std::uint32_t last = first + tube.ring_vertex(tube.rings - 1, 0);
  const std::uint32_t end = first + tube.ring_vertex(tube.rings, 0);
  for (std::uint32_t k = 0; k < sides; ++k) {
    if (tube.end_vertices == sides) {
      to.triangles.push_back({last + k, last + k + 1, end + k});
    } else {
      to.triangles.push_back({end, end + 1 + k, end + 1 + (k + 1) % sides});
    }
  }
}

void add_tube_vertices(const TubeShape& tube, const TubeShape& model, Mesh& to) {
  if (&tube == &model || tube.positions == model.positions) {
    to.positions.insert(to.positions.end(), tube.positions.begin(), tube.positions.end());
    to.normals.insert(to.normals.end(), tube.normals.begin(), tube.normals.end());
    return;
  }
  const auto add = [&](Vec3 position, Vec3 normal) {
    to.positions.push_back(position);
    to.normals.push_back(normal);
  };
  const Spine spine(tube), of_model(model);
  const TubeReader reader(tube, spine, model, of_model);
  const RingPlaces rings = places_of_rings(spine, of_model);
  const auto add_ring = [&](float place, std::uint32_t corners, const Vec3* facing) {
    for (std::uint32_t k = 0; k < corners; ++k) {
      Vec3 position, normal;
      const std::uint32_t side = k % model.sides;
      reader.read(place, static_cast<float>(side) / static_cast<float>(model.sides), position, normal);
      add(position, facing != nullptr ? *facing : normal);
    }
  };
  add(tube.positions[0], tube.normals[0]);
  if (model.start_vertices > 1) add_ring(0, model.sides, &tube.normals[0]);
  for (std::size_t ring = 0; ring < rings.places.size(); ++ring) {
    add_ring(rings.places[ring], model.sides + 1, nullptr);
    if (ring < rings.first_beyond) continue;
    // Parts without area keep the model's normals, so that normals need not move.
    const auto own = model.normals.begin() + model.ring_vertex(static_cast<std::uint32_t>(ring), 0);
    std::copy(own, own + model.sides + 1, to.normals.end() - (model.sides + 1));
  }
  const std::uint32_t end = tube.ring_vertex(tube.rings, 0);
  if (model.end_vertices == model.sides) {
    for (std::uint32_t k = 0; k < model.sides; ++k) add(tube.positions[end], tube.normals[end]);
  } else {
    add(tube.positions[end], tube.normals[end]);
    add_ring(spine.length(), model.sides, &tube.normals[end]);
  }
}

void add_collapsed_vertices(const TubeShape& tube, const TubeShape& model, Mesh& to) {
  const Vec3 base = Spine(tube).centre[0];
  to.positions.insert(to.positions.end(), model.positions.size(), base);
  to.normals.insert(to.normals.end(), model.normals.begin(), model.normals.end());
}

}  // namespace meristem
