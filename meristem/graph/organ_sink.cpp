// SPDX-License-Identifier: Apache-2.0
// Stores the organs of instances. Instances of one component share the mesh of a key, and all blocks of a batch share
// their meshes (SharedMeshes).
#include "meristem/graph/organ_sink.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "meristem/base/hash.h"
#include "meristem/graph/present_instance.h"

namespace meristem {

std::uint64_t shape_key(std::initializer_list<double> numbers) {
  return hash64(std::string_view(reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(double)));
}

void OrganSink::add(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint) {
  add_organ(local, key, false, make, present_->tint * tint);
}

void OrganSink::add_blade(const Frame& local, std::uint64_t key, FunctionRef<Mesh()> make, Vec3 tint) {
  const bool has_own_colour = present_->prototype().type->blades.has_document_colours;
  add_organ(local, key, true, make, has_own_colour ? present_->tint * tint : tint);
}

void OrganSink::add_organ(const Frame& local, std::uint64_t key, bool is_blade, FunctionRef<Mesh()> make, Vec3 tint) {
  if (!present_->is_visible) return;
  Emitted& emitted = present_->emitted;
  const auto next = static_cast<std::uint32_t>(emitted.prototypes.size());
  const auto [found, is_new] = prototype_by_key_.try_emplace(key, next);
  if (is_new) emitted.prototypes.push_back({key, shared_mesh(key, make), is_blade});
  note_deformation();
  emitted.organs.add({present_->geometry_frame * local, found->second, tint, present_->site.birth,
                      number_of_individual(), next_name()});
}

/// Returns the mesh of a key, which is made if it is new.
std::shared_ptr<const Mesh> OrganSink::shared_mesh(std::uint64_t key, FunctionRef<Mesh()> make) {
  const EmitterContext& context = *present_->context;
  std::shared_ptr<const Mesh> mesh = context.meshes.find(key);
  if (mesh == nullptr) {
    Mesh made = make();
    lay_picture(present_->prototype().base().texture, made);
    mesh = context.meshes.keep(key, std::make_shared<const Mesh>(std::move(made)));
  }
  const std::uint64_t limit = context.limits.mesh_bytes;
  if (context.mesh_bytes + context.meshes.bytes() <= limit) return mesh;
  throw_past_limit(fmt::format("the shapes of '{}' take more than {} bytes", present_->prototype().id, limit), limit,
                   "mesh_bytes", present_->path());
}

/// Records the deformation of the following organs if it differs from the previous one.
void OrganSink::note_deformation() {
  Emitted& emitted = present_->emitted;
  const std::shared_ptr<const Deformation>& own = deformation_at(present_->site);
  const bool is_other = emitted.deformed.empty() ? own != nullptr : emitted.deformed.back().deformation != own;
  if (is_other) emitted.deformed.push_back({emitted.organs.size(), own});
}

/// Returns the number, within the block, of the plant to which the instance belongs.
std::uint32_t OrganSink::number_of_individual() {
  std::vector<std::uint64_t>& individuals = present_->emitted.individuals;
  const std::uint64_t own = present_->site.individual;
  if (!individuals.empty() && individuals.back() == own) return static_cast<std::uint32_t>(individuals.size() - 1);
  const auto [found, is_new] = individual_by_id_.try_emplace(own, static_cast<std::uint32_t>(individuals.size()));
  if (is_new) individuals.push_back(own);
  return found->second;
}

/// Returns the name of the next organ, from its number in the instance.
std::uint64_t OrganSink::next_name() { return present_->site.key.child("organ").child(count_++).bits(); }

void OrganSink::add_plant(const Frame& local, std::shared_ptr<const PlantSource> source, PlantRequest request) {
  request.time = present_->time();
  const Site& site = present_->site;
  present_->emitted.plants.push_back({present_->geometry_frame * local, std::move(source), std::move(request),
                                      site.birth, present_->is_visible, deformation_at(site), site.row, next_name()});
}

void OrganSink::add_section(const Frame& local, std::uint64_t key, bool is_capped, FunctionRef<LoftSection()> make) {
  if (!present_->is_visible) return;
  std::shared_ptr<const SectionOutline>& outline = outline_by_key_[key];
  if (outline == nullptr) {
    SectionOutline made{.key = key, .section = make()};
    for (const Vec3 point : made.section.points) made.extent = std::max(made.extent, glm::length(point));
    outline = std::make_shared<const SectionOutline>(std::move(made));
  }
  // One random colour holds for a whole surface.
  Site& site = present_->site;
  const bool is_first = present_->parent_section == 0;
  if (is_first) site.surface = site.key;
  const Vec3 tint =
      is_first ? present_->tint : present_->context->tinting.tint(*present_->base, site.surface.child("colour"));
  present_->section = std::max<std::uint64_t>(1, site.key.child("section").bits());
  present_->emitted.sections.push_back({.outline = outline,
                                        .frame = present_->geometry_frame * local,
                                        .is_capped = is_capped,
                                        .id = present_->section,
                                        .parent = present_->parent_section,
                                        .tint = tint,
                                        .birth = site.birth,
                                        .individual = site.individual,
                                        .deformation = deformation_at(site)});
}

}  // namespace meristem
