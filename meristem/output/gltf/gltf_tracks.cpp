// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/gltf/gltf_tracks.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace meristem {

namespace {

bool has_volume(const Frame& frame) { return std::abs(glm::determinant(frame.axes)) > 0; }

/// Collects the tracks of nodes.
class TrackWriter {
 public:
  TrackWriter(const std::vector<double>& times, GltfAnimation& animation) : animation_(animation) {
    animation_.keys = times.size();
    for (const double time : times) animation_.data.push_back(static_cast<float>(time));
  }

  void begin_node() { animation_.tracks.emplace_back(); }

  /// `number(key)` appends the numbers of a key; a property that does not change has no track.
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
  tracks.add(GltfTrack::Property::translation, false,
             [&](std::size_t key, std::vector<float>& to) { append(pose_at(shared, row, key).translation, to); });
  Vec4 before(0);
  tracks.add(GltfTrack::Property::rotation, false, [&](std::size_t key, std::vector<float>& to) {
    Vec4 rotation = pose_at(shared, row, key).rotation;
    if (glm::dot(rotation, before) < 0) rotation = -rotation;  // the shorter way
    before = rotation;
    to.insert(to.end(), {rotation.x, rotation.y, rotation.z, rotation.w});
  });
  tracks.add(GltfTrack::Property::scale, false,
             [&](std::size_t key, std::vector<float>& to) { append(pose_at(shared, row, key).scale, to); });
}

void add_weights(std::size_t keys, TrackWriter& tracks) {
  tracks.add(GltfTrack::Property::weights, false, [&](std::size_t key, std::vector<float>& to) {
    for (std::size_t target = 0; target + 1 < keys; ++target) to.push_back(target == key ? 1.0F : 0.0F);
  });
}

}  // namespace

NodePose pose_at(const GltfSharedMesh& shared, std::size_t row, std::size_t key) {
  const auto& frames = shared.motion->frames;
  const std::uint32_t instance = shared.instances[row];
  const auto frame_of = [&](std::size_t k) -> const Frame& { return frames[k][instance]; };
  std::size_t seen = key;
  while (seen < frames.size() && !has_volume(frame_of(seen))) ++seen;
  if (seen == frames.size()) {
    seen = key;
    while (seen > 0 && !has_volume(frame_of(seen))) --seen;
  }
  NodePose pose{.translation = frame_of(key).origin - shared.origin};
  const Mat3& turned = frame_of(seen).axes;
  if (has_volume(frame_of(seen))) {
    const Mat3 turn(glm::normalize(turned[0]), glm::normalize(turned[1]), glm::normalize(turned[2]));
    const glm::quat rotation = glm::normalize(glm::quat_cast(turn));
    pose.rotation = {rotation.x, rotation.y, rotation.z, rotation.w};
  }
  const Mat3& axes = frame_of(key).axes;
  pose.scale = {glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])};
  return pose;
}

void add_tracks(const std::vector<double>& times, GltfLayout& layout) {
  TrackWriter tracks(times, layout.animation);
  for (const GltfComponent& component : layout.components) {
    for (const GltfSharedMesh& shared : component.shared) {
      for (std::size_t row = 0; shared.motion != nullptr && row < shared.instances.size(); ++row) {
        tracks.begin_node();
        add_poses(shared, row, tracks);
      }
    }
    for (const GltfMovingMesh& moving : component.moving) {
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
