// SPDX-License-Identifier: Apache-2.0
// Turns overlay layers into meshes. Each kind of piece (ball, rod, cone) is one mesh with many instances in different
// colours.
#include "meristem/export/overlay/overlay_meshes.h"

#include <memory>
#include <utility>

#include "meristem/base/colour.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem {

namespace {

// Sizes as shares of the size of the shown object.
constexpr double kBall = 0.012;  // diameter of a ball
constexpr double kNode = 0.008;  // diameter of a ball at a point where lines join
constexpr double kRod = 0.003;
constexpr double kShaft = 0.004;
constexpr double kHead = 0.25;     // length of an arrow's head, as a share of the arrow
constexpr double kMaxHead = 0.03;  // maximum length of a head, as a share of the size
constexpr int kRodCorners = 6;
constexpr int kBallSegments = 10;

/// Instances of one mesh in many colours.
class Pieces {
 public:
  explicit Pieces(Mesh mesh) : mesh_(std::make_shared<const Mesh>(std::move(mesh))) {}

  void add(const Frame& frame, Vec3 colour) {
    frames_.push_back(frame);
    tints_.push_back(linear_from_srgb(colour));
  }
  /// Adds a piece of height 1 and radius 1 about y, stretched from one position to another.
  void span(Vec3 from, Vec3 to, double radius, Vec3 colour) {
    const float length = glm::distance(from, to);
    if (!(length > 0)) return;
    Frame frame = frame_along(from, (to - from) / length, kUp);
    frame.axes[0] *= static_cast<float>(radius);
    frame.axes[1] *= length;
    frame.axes[2] *= static_cast<float>(radius);
    add(frame, colour);
  }
  void move_to(MeshScene& scene, std::uint32_t material) {
    if (frames_.empty()) return;
    scene.meshes.push_back({.component = "overlay",
                            .mesh = mesh_,
                            .material = material,
                            .frames = std::move(frames_),
                            .tints = std::move(tints_)});
  }

 private:
  std::shared_ptr<const Mesh> mesh_;
  std::vector<Frame> frames_;
  std::vector<Vec3> tints_;
};

}  // namespace

MeshScene with_overlays(const MeshScene& meshes, std::span<const OverlayLayer> layers, double size) {
  Pieces balls(make_sphere(0.5, kBallSegments));
  Pieces rods(make_cylinder(1, 1, kRodCorners));
  Pieces heads(make_cone(1, 1, 2 * kRodCorners));
  for (const OverlayLayer& layer : layers) {
    const double across = size * (layer.part == OverlayPart::skeleton ? kNode : kBall);
    for (const OverlayPoint& point : layer.points) {
      balls.add({Mat3(static_cast<float>(across)), point.position}, point.colour);
    }
    for (const OverlayLine& line : layer.lines) rods.span(line.from, line.to, 0.5 * kRod * size, line.colour);
    for (const OverlayLine& arrow : layer.arrows) {
      const float length = glm::distance(arrow.from, arrow.to);
      const double head = std::min(kHead * static_cast<double>(length), kMaxHead * size);
      const Vec3 neck = arrow.to - static_cast<float>(head / static_cast<double>(length)) * (arrow.to - arrow.from);
      rods.span(arrow.from, neck, 0.5 * kShaft * size, arrow.colour);
      heads.span(neck, arrow.to, 0.4 * head, arrow.colour);
    }
  }
  MeshScene scene = meshes;
  const auto material = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({.name = "overlay", .colour = Vec3(1), .roughness = 1});
  for (Pieces* const pieces : {&balls, &rods, &heads}) pieces->move_to(scene, material);
  return scene;
}

}  // namespace meristem
