// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <unordered_map>

#include "meristem/base/frame.h"
#include "meristem/base/function_ref.h"
#include "meristem/base/mesh.h"
#include "meristem/graph/emitted.h"
#include "meristem/graph/table/plant_source.h"
#include "meristem/shape/tube/loft.h"

namespace meristem {

struct PresentInstance;

/// Returns a key for geometry that instances with these numbers share.
std::uint64_t shape_key(std::initializer_list<double> numbers);

/// Collects the organs of instances, with sections of surfaces and whole plants of other documents. All are placed in
/// the frame of the instance, moved by its `place`. Throws InputError if the meshes exceed the limit of bytes.
class OrganSink {
 public:
  /// `present` must outlive the sink.
  explicit OrganSink(PresentInstance& present) : present_(&present) {}

  /// Emits geometry at `local`. Instances of one component with equal `key` share a mesh, which one of them makes. The
  /// key, together with all that the instances have in common, must therefore determine the whole mesh. `tint` has
  /// linear factors on the instance's colour.
  void add(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint = Vec3(1));
  /// Emits a flat shape with the component type's material of blades. The parameters are as for `add`.
  void add_blade(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint = Vec3(1));
  /// Skips one organ index, so that later organs keep their index when this organ does not exist at the current time.
  void skip() { ++count_; }
  /// Emits a section of a surface at `local`, once per instance. Sections of children by child and leaf links continue
  /// the surface. Instances of one component with equal `key` share the outline, which one of them makes.
  void add_section(const Frame& local, std::uint64_t key, bool is_capped, FunctionRef<LoftSection()> make);
  /// Emits a whole plant at `local`. Equal requests of equal sources are grown once.
  void add_plant(const Frame& local, std::shared_ptr<const PlantSource> source, PlantRequest request);

 private:
  friend class Emitter;

  void begin_instance() { count_ = 0; }
  void add_organ(const Frame& local, std::uint64_t key, bool is_blade, FunctionRef<Mesh()> make, Vec3 tint);
  std::shared_ptr<const Mesh> shared_mesh(std::uint64_t key, FunctionRef<Mesh()> make);
  void note_deformation();
  std::uint32_t number_of_individual();
  std::uint64_t next_name();

  PresentInstance* present_;
  std::uint32_t count_ = 0;  // number of organs and plants of the present instance
  std::unordered_map<std::uint64_t, std::uint32_t> prototype_by_key_;
  std::unordered_map<std::uint64_t, std::uint32_t> individual_by_id_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const SectionOutline>> outline_by_key_;
};

}  // namespace meristem
