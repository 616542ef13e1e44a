// SPDX-License-Identifier: Apache-2.0
// Computes the animation tracks of nodes. Rigid instances get translation, rotation and scale per key, and changing
// meshes get the weights of their morph targets. Properties that never change get no track.
#include "meristem/output/gltf/gltf_tracks.h"

#include <glm/gtc/quaternion.hpp>

#include "meristem/shape/moving/nearest_keys.h"

namespace meristem {

namespace {

/// Collects the tracks of nodes.
class TrackWriter {
 public:
  TrackWriter(const std::vector<double>& times, GltfAnimation& animation) : animation_(animation) {
    animation_.keys = times.size();
    for (const double time : times) animation_.data.push_back(static_cast<float>(time));
  }

  void begin_node() { animation_.tracks.emplace_back(); }

  /// Adds the track of a property. `append(key, data)` appends the numbers of a key. A property that does not change
  /// gets no track.
  template <class Numbers>
  void add(GltfTrack::Property property, bool is_stepped, Numbers append) {
    GltfTrack track{.property = property, .first = animation_.data.size(), .is_stepped = is_stepped};
    std::vector<float>& data = animation_.data;
    for (std::size_t key = 0; key < animation_.keys; ++key) append(key, data);
    track.numbers = data.size() - track.first;
    const std::size_t row = track.numbers / animation_.keys;
    bool changes = false;
    for (std::size_t k = row; k < track.numbers; ++k) {
      changes = changes || data[track.first + k] != data[track.first + k - row];
    }
    if (!changes) {
      data.resize(track.first);
      return;
    }
    animation_.tracks.back().push_back(track);
  }

 private:
  GltfAnimation& animation_;
};

void append(Vec3 value, std::vector<float>& to) { to.insert(to.end(), {value.x, value.y, value.z}); }

void add_poses(const GltfSharedMesh& shared, std::size_t row, TrackWriter& tracks) {
  const std::vector<NodePose> poses = poses_of(shared, row);
  tracks.add(GltfTrack::Property::translation, false,
             [&](std::size_t key, std::vector<float>& to) { append(poses[key].translation, to); });
  Vec4 before(0);
  tracks.add(GltfTrack::Property::rotation, false, [&](std::size_t key, std::vector<float>& to) {
    Vec4 rotation = poses[key].rotation;
    if (glm::dot(rotation, before) < 0) rotation = -rotation;  // takes the shorter way
    before = rotation;
    to.insert(to.end(), {rotation.x, rotation.y, rotation.z, rotation.w});
  });
  tracks.add(GltfTrack::Property::scale, false,
             [&](std::size_t key, std::vector<float>& to) { append(poses[key].scale, to); });
}

void add_weights(std::size_t keys, TrackWriter& tracks) {
  tracks.add(GltfTrack::Property::weights, false, [&](std::size_t key, std::vector<float>& to) {
    for (std::size_t target = 0; target + 1 < keys; ++target) to.push_back(target == key ? 1.0F : 0.0F);
  });
}

}  // namespace

std::vector<NodePose> poses_of(const GltfSharedMesh& shared, std::size_t row) {
  const auto& frames = shared.motion->frames;
  const std::uint32_t instance = shared.instances[row];
  const std::vector<std::size_t> nearest =
      nearest_keys(frames.size(), [&](std::size_t key) { return is_there(frames[key][instance]); });
  std::vector<NodePose> poses(frames.size());
  for (std::size_t key = 0; key < frames.size(); ++key) {
    const Frame& now = frames[key][instance];
    poses[key].translation = now.origin - shared.origin;
    poses[key].scale = {glm::length(now.axes[0]), glm::length(now.axes[1]), glm::length(now.axes[2])};
    const Frame& seen = frames[nearest[key]][instance];
    if (!is_there(seen)) continue;
    const Mat3 turn(glm::normalize(seen.axes[0]), glm::normalize(seen.axes[1]), glm::normalize(seen.axes[2]));
    const glm::quat rotation = glm::normalize(glm::quat_cast(turn));
    poses[key].rotation = {rotation.x, rotation.y, rotation.z, rotation.w};
  }
  return poses;
}

void add_tracks(const std::vector<double>& times, GltfLayout& layout, const Progress& progress) {
  TrackWriter tracks(times, layout.animation);
  for (const GltfComponent& component : layout.components) {
    for (const GltfSharedMesh& shared : component.shared) {
      for (std::size_t row = 0; shared.motion != nullptr && row < shared.instances.size(); ++row) {
        progress.check();
        tracks.begin_node();
        add_poses(shared, row, tracks);
      }
    }
    for (const GltfMovingMesh& moving : component.moving) {
      progress.check();
      tracks.begin_node();
      if (moving.shown_at == GltfMovingMesh::kAlways) {
        add_weights(times.size(), tracks);
        continue;
      }
      tracks.add(GltfTrack::Property::scale, true, [&](std::size_t key, std::vector<float>& to) {
        append(Vec3(key == moving.shown_at ? 1.0F : 0.0F), to);
      });
    }
  }
}

}  // namespace meristem
