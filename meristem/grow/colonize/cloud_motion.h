// SPDX-License-Identifier: Apache-2.0
// How clouds of attraction points move with the light that falls on the nodes which they pull.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/colonize/light_response.h"
#include "meristem/grow/colonize/moving_points.h"
#include "meristem/scene/scene.h"

namespace meristem {

class CloudMotion {
 public:
  /// The points that one tree has brought.
  struct Cloud {
    LightResponse response;
    double base = 0;  ///< metres up to the root of its tree
    double top = 0;   ///< metres from there to its highest point; where the height is held, that stays
  };

  /// Points with the group k are of `clouds[k]`; `origin` is where their coordinates begin in the world. `scene` must
  /// outlive this.
  CloudMotion(const Scene& scene, Vec3 origin, std::vector<Cloud> clouds)
      : scene_(scene), origin_(origin), clouds_(std::move(clouds)) {}

  /// The next node, counted from 0; light that arrives at it has this weight over light that it is shaded from.
  void add_node(Vec3 position, double sunlit_weight) { nodes_.push_back({position, sunlit_weight}); }

  /// Moves all clouds by one step, and sets which of their points are inert, inside obstacles, from then on. Light is
  /// sought once for each node that comes to pull. Points end equal on any number of threads. Throws Cancelled.
  void move(MovingPoints& points, const Progress& progress);

 private:
  struct Node {
    Vec3 position{0};
    double sunlit_weight = 1;
    bool knows_light = false;
    DVec3 brighter{0};
  };
  /// A node with points of a cloud.
  struct Pulled {
    std::uint32_t cloud;
    NodeIndex node;
    auto operator<=>(const Pulled&) const = default;
  };

  std::vector<Pulled> pulled_nodes(const MovingPoints& points) const;
  void seek_light(std::span<const Pulled> pulled, const Progress& progress);
  std::vector<DVec3> shifts(std::span<const Pulled> pulled) const;
  std::vector<double> height_factors(const MovingPoints& points, std::span<const DVec3> shifts) const;
  DVec3 displacement(const MovingPoint& point, std::span<const DVec3> shifts) const;

  const Scene& scene_;
  Vec3 origin_;
  std::vector<Cloud> clouds_;
  std::vector<Node> nodes_;
};

}  // namespace meristem
