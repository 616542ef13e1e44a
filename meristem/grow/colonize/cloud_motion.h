// SPDX-License-Identifier: Apache-2.0
// Moves clouds of attraction points with the light on the nodes that they pull, and along fields such as a wind.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/colonize/light_response.h"
#include "meristem/grow/colonize/moving_points.h"
#include "meristem/scene/directions.h"
#include "meristem/scene/scene.h"

namespace meristem {

class CloudMotion {
 public:
  /// The points that one tree brought.
  struct Cloud {
    LightResponse response;
    double base = 0;        ///< height of its tree's root, metres
    double top = 0;         ///< height of its highest point above the root, metres; constant if the height is held
    Directions directions;  ///< fields that carry the points: those that were added to the scene's own
  };

  /// A point with the group k belongs to `clouds[k]`. `origin` is the world position of the points' coordinate origin.
  /// `scene` must outlive this object.
  CloudMotion(const Scene& scene, Vec3 origin, std::vector<Cloud> clouds)
      : scene_(scene), origin_(origin), clouds_(std::move(clouds)) {}

  /// Adds the next node; nodes are numbered from 0. `sunlit_weight` is the weight of light that arrives, relative to
  /// blocked light.
  void add_node(Vec3 position, double sunlit_weight) { nodes_.push_back({position, sunlit_weight}); }

  /// Moves all clouds by one step, and marks points inside obstacles as inert. A cloud rests until it pulls a node.
  /// Light is computed once for each node that pulls points. The result does not depend on the number of threads.
  /// Throws Cancelled.
  void move(MovingPoints& points, const Progress& progress);

 private:
  struct Node {
    Vec3 position{0};
    double sunlit_weight = 1;
    bool knows_light = false;
    DVec3 brighter{0};
  };
  /// A node that pulls points of a cloud.
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
  DVec3 carried(const MovingPoint& point) const;

  const Scene& scene_;
  Vec3 origin_;
  std::vector<Cloud> clouds_;
  std::vector<std::uint8_t> pulls_;  // by cloud: 1 if it pulls a node in this step
  std::vector<Node> nodes_;
};

}  // namespace meristem
