// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/mesh.h"
#include "meristem/graph/site.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"

namespace meristem {

struct ComponentBase;

/// A key for geometry that instances with these numbers share.
std::uint64_t shape_key(std::initializer_list<double> numbers);

/// A stem with what its children need to know.
struct EmittedStem {
  Skeleton skeleton;
  Surface surface;
  Site site;  ///< of the instance that made it; its key is the instance's
  bool visible = true;
};

/// Takes what the instances of one block emit. One thread uses one emitter; blocks are merged in their order.
class Emitter {
 public:
  Emitter(const Scene& scene, double time) : scene_(&scene), time_(time) {}

  // For components.

  /// Geometry at `local` in the instance's frame (moved by its `place`). Instances of one component with equal `key`
  /// share what the first one makes.
  void organ(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make);
  /// A skeleton in world space.
  void stem(Skeleton skeleton, const Surface& surface);
  /// A place for children, relative to the instance's frame; called n times it multiplies them. Without a call,
  /// children stand in the instance's frame.
  void child_site(const Frame& local, float length = 0, float radius = 0);
  /// A place for the children of branch links that differs from those of child links.
  void branch_site(const Frame& local, float u, float length, float radius);

  const Scene& scene() const { return *scene_; }
  double time() const { return time_; }
  /// The skeleton that this instance has grown.
  Skeleton take_grown() { return std::move(grown_[instance_]); }

  // For the graph.

  /// Calls `expand` for one instance, unless it is omitted; `index` counts within the block.
  void instance(const ComponentBase& base, const Site& site, std::size_t index, FunctionRef<void(const Site&)> expand);
  void set_grown(std::vector<Skeleton> skeletons) { grown_ = std::move(skeletons); }

  struct EmittedPrototype {
    std::uint64_t key = 0;
    std::shared_ptr<const Mesh> mesh;
  };
  std::vector<EmittedPrototype> prototypes;
  std::vector<Organ> organs;  ///< their prototypes count within this emitter
  std::vector<EmittedStem> stems;
  std::vector<Site> child_sites;  ///< with the key and depth of the instance that offers them
  std::vector<Site> branch_sites;

 private:
  Site site_below(const Frame& local, std::uint32_t i) const;
  void number_siblings(std::vector<Site>& sites, std::size_t first);

  const Scene* scene_;
  double time_;
  std::size_t instance_ = 0;
  Site site_;             // of the present instance, with its own frame
  Frame geometry_frame_;  // that frame moved by `place`
  bool visible_ = true;
  std::unordered_map<std::uint64_t, std::uint32_t> prototype_by_key_;
  std::vector<Skeleton> grown_;
};

}  // namespace meristem
