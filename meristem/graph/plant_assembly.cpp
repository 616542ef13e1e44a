// SPDX-License-Identifier: Apache-2.0
// Puts a plant together from the results of all batches: materials, prototypes, organs, surfaces, stems and
// individuals. Order is fixed by components and batches, so the plant has the same bytes on any number of threads.
// Organs are copied in groups of blocks, whose memory is released after each group. Deformations come last.
#include "meristem/graph/plant_assembly.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/large_memory.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/looks.h"
#include "meristem/plant/join_stems.h"

namespace meristem {

namespace {

/// The different textures of a plant's materials.
class SharedTextures {
 public:
  /// Gives the material the texture of an earlier material if both textures are equal. Throws InputError if the
  /// textures have too many pixels together.
  void share(Material& material, const SizeLimits& limits) {
    if (material.texture == nullptr) return;
    const auto [known, is_new] = textures_.try_emplace(material.texture->fingerprint, material.texture);
    if (!is_new) {
      material.texture = known->second;
      return;
    }
    const Image& colour = material.texture->colour;
    pixels_ += static_cast<std::uint64_t>(colour.width) * static_cast<std::uint64_t>(colour.height);
    if (pixels_ <= limits.texture_pixels) return;
    throw_limit("pixels of textures", static_cast<double>(pixels_), limits.texture_pixels, "texture_pixels",
                fmt::format("components.{}.texture", material.name));
  }

 private:
  std::unordered_map<std::uint64_t, std::shared_ptr<const Texture>> textures_;  // by fingerprint
  std::uint64_t pixels_ = 0;
};

constexpr std::size_t kManyOrgans = 100'000;   // number of organs from which freed memory is worth returning
constexpr std::size_t kManyStems = 25'000;     // number of stems whose freed memory is worth returning
constexpr std::size_t kBlocksTogether = 1024;  // number of blocks whose organs are copied in parallel and then released

/// The organs of one block, while they are copied into the plant.
struct OrgansOfBlock {
  const Emitted* block = nullptr;
  OrganList* own = nullptr;               // the same organs, if they may be released; else null
  std::vector<std::uint32_t> prototype;   // prototype in the plant, by number in the block
  std::vector<std::uint32_t> individual;  // individual in the plant, by number in the block
  std::size_t first = 0;                  // index of the block's first organ in the plant
};

/// Returns the individual of each root of a stem.
template <class NumberOf>
std::vector<std::uint32_t> individuals_of_roots(const EmittedStem& stem, NumberOf number_of) {
  const auto& parents = stem.skeleton.parent;
  const auto roots = static_cast<std::uint32_t>(std::count(parents.begin(), parents.end(), kNoNode));
  std::vector<std::uint32_t> individuals;
  for (std::uint32_t root = 0; root < roots; ++root) {
    individuals.push_back(number_of(stem.root_of_node.empty() ? stem.site.individual : stem.individual_of_root(root)));
  }
  return individuals;
}

}  // namespace

void PlantAssembly::add(ComponentIndex component, std::shared_ptr<const BatchResult> batch, BatchResult* own) {
  batches_of_[component].push_back(batches_.size());
  batches_.push_back({component, std::move(batch), own});
}

bool PlantAssembly::has_prototypes(ComponentIndex component, bool blades) const {
  return std::ranges::any_of(batches_of_[component], [&](std::size_t batch) {
    return std::ranges::any_of(batches_[batch].result->blocks, [&](const Emitted& block) {
      return std::ranges::any_of(block.prototypes, [&](const auto& made) { return made.is_blade == blades; });
    });
  });
}

bool PlantAssembly::has_visible_stems(ComponentIndex component) const {
  return std::ranges::any_of(batches_of_[component], [&](std::size_t batch) {
    return std::ranges::any_of(batches_[batch].result->blocks, [](const Emitted& block) {
      return std::ranges::any_of(block.stems, &EmittedStem::visible);
    });
  });
}

std::uint64_t PlantAssembly::organ_count() const {
  std::uint64_t count = 0;
  for (const Made& made : batches_) {
    for (const Emitted& block : made.result->blocks) count += block.organs.size();
  }
  return count;
}

Plant PlantAssembly::run(std::uint64_t mesh_bytes, Progress& progress) {
  require_stems_left();
  const Individuals individuals = find_individuals();
  const std::vector<Surfaces> surfaces = join_surfaces(individuals, mesh_bytes, progress);
  Plant plant;
  plant.individuals = individuals.list;
  std::uint64_t organs = organ_count();
  for (const Surfaces& own : surfaces) {
    for (const SurfacePiece& piece : own) organs += piece.organs.size();
  }
  plant.organs.reserve(organs);
  if (organs >= kManyOrgans) give_back_memory();  // of sites and of other steps of the expansion
  std::vector<std::uint32_t> material_of_component(batches_of_.size(), 0);
  SharedTextures textures;
  Rows deformed;
  for (ComponentIndex c = 0; c < batches_of_.size(); ++c) {
    progress.check();
    const std::uint32_t material = material_of_component[c] = add_materials(c, surfaces[c], plant);
    for (std::size_t k = material; k < plant.materials.size(); ++k) textures.share(plant.materials[k], graph_.limits);
    add_organs(c, material, individuals, plant, deformed);
    add_surfaces(c, material, surfaces[c], plant, deformed);
  }
  plant.stems = joined_stems(material_of_component, individuals);
  deform(plant, deformed, mesh_bytes, graph_.limits, progress);
  return plant;
}

/// Throws InputError if bodies have trimmed all stems of the plant to nothing: the stems then stand in the wrong place.
void PlantAssembly::require_stems_left() const {
  const Made* trimmed = nullptr;
  for (const Made& made : batches_) {
    for (const Emitted& block : made.result->blocks) {
      for (const EmittedStem& stem : block.stems) {
        if (stem.skeleton.node_count() > 0) return;
        if (stem.trimmed != nullptr && trimmed == nullptr) trimmed = &made;
      }
    }
  }
  if (trimmed == nullptr) return;
  const std::string& id = graph_.components[trimmed->component].id;
  throw InputError(Diagnostic{.message = fmt::format("trimming leaves nothing: all stems of '{}' begin outside the "
                                                     "body that is given above it",
                                                     id),
                              .expected = "a body around the base of the stems, or \"trim\": \"none\"",
                              .path = "components." + id});
}

std::uint32_t PlantAssembly::Individuals::number(std::uint64_t id) const {
  const auto found = number_by_id.find(id);
  return found == number_by_id.end() ? kNoIndividual : found->second;
}

PlantAssembly::Individuals PlantAssembly::find_individuals() const {
  Individuals individuals;
  std::vector<std::uint32_t> counts(batches_of_.size(), 0);
  for (const Made& made : batches_) {
    for (const Emitted& block : made.result->blocks) {
      for (const Emitted::Founded& founded : block.founded) {
        const auto next = static_cast<std::uint32_t>(individuals.list.size());
        if (!individuals.number_by_id.try_emplace(founded.id, next).second) continue;
        const std::string& component = graph_.components[made.component].id;
        individuals.list.push_back({component, counts[made.component]++, founded.foot, founded.row});
        if (founded.deformation == nullptr) continue;
        founded.deformation->map(std::span(&individuals.list.back().foot, 1), component);
      }
    }
  }
  return individuals;
}

/// Returns the surfaces through sections of many instances, grouped by the component of each piece.
std::vector<PlantAssembly::Surfaces> PlantAssembly::join_surfaces(const Individuals& individuals,
                                                                  std::uint64_t mesh_bytes, Progress& progress) const {
  std::vector<SurfaceSection> sections;
  for (const Made& made : batches_) {
    for (const Emitted& block : made.result->blocks) {
      for (const EmittedSection& section : block.sections) {
        sections.push_back({section, made.component, individuals.number(section.individual)});
      }
    }
  }
  turn_sections(sections);
  std::vector<Surfaces> surfaces(batches_of_.size());
  for (SurfacePiece& piece : join_sections(sections, graph_, mesh_bytes, progress)) {
    surfaces[piece.component].push_back(std::move(piece));
  }
  return surfaces;
}

/// Applies the part of deformations that moves axes to the sections. The surfaces through them are deformed later.
void PlantAssembly::turn_sections(std::vector<SurfaceSection>& sections) const {
  for (std::size_t begin = 0, end = 0; begin < sections.size(); begin = end) {
    const std::shared_ptr<const Deformation> own = sections[begin].deformation;
    const ComponentIndex component = sections[begin].component;
    const auto is_of_run = [&](std::size_t k) {
      return sections[k].deformation == own && sections[k].component == component;
    };
    for (end = begin; end < sections.size() && is_of_run(end); ++end) {
    }
    if (own == nullptr) continue;
    const auto of_axes = own->of_axes();
    const auto of_surface = own->of_surface();
    std::vector<Frame> frames;
    for (std::size_t k = begin; k < end; ++k) frames.push_back(sections[k].frame);
    if (of_axes != nullptr) meristem::deform(frames, *of_axes, graph_.components[component].id);
    for (std::size_t k = begin; k < end; ++k) {
      sections[k].frame = frames[k - begin];
      sections[k].deformation = of_surface;
    }
  }
}

/// Applies deformations to these organs, and to stems as their parts require.
void PlantAssembly::deform(Plant& plant, const Rows& organs, std::uint64_t mesh_bytes, const SizeLimits& limits,
                           Progress& progress) {
  const auto is_deformed = [](const Stem& stem) {
    return std::ranges::any_of(stem.parts, [](const StemPart& part) { return part.deformation != nullptr; });
  };
  const auto stems = static_cast<std::uint64_t>(std::ranges::count_if(plant.stems, is_deformed));
  if (organs.empty() && stems == 0) return;
  progress.begin("deforming", stems + 1);
  parallel_for(plant.stems.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Stem& stem = plant.stems[k];
      if (!is_deformed(stem)) continue;
      std::vector<std::shared_ptr<const Deformation>> of_part;
      for (StemPart& part : stem.parts) of_part.push_back(std::exchange(part.deformation, nullptr));
      meristem::deform(stem, of_part);
      progress.advance();
    }
  });
  deform_organs(plant, organs, mesh_bytes, limits, progress);
  progress.advance();
}

/// Adds the component's materials to the plant. Returns the index of the component's own material, or the index that it
/// would have.
std::uint32_t PlantAssembly::add_materials(ComponentIndex component, const Surfaces& surfaces, Plant& plant) const {
  const auto first = static_cast<std::uint32_t>(plant.materials.size());
  if (has_visible_stems(component) || has_prototypes(component, false) || !surfaces.empty()) {
    plant.materials.push_back(material_of(graph_.components[component]));
    if (std::ranges::any_of(surfaces, &SurfacePiece::is_open)) plant.materials.back().two_sided = true;
  }
  if (has_prototypes(component, true)) plant.materials.push_back(blades_of(graph_.components[component]));
  return first;
}

/// Adds the component's organs in the order of their blocks. Meshes with equal keys become one prototype.
void PlantAssembly::add_organs(ComponentIndex component, std::uint32_t material, const Individuals& individuals,
                               Plant& plant, Rows& deformed) {
  const auto blades = static_cast<std::uint32_t>(plant.materials.size() - 1);  // the last material, if there are blades
  std::unordered_map<std::uint64_t, std::uint32_t> prototype_by_key;
  std::vector<OrgansOfBlock> blocks;
  std::size_t count = plant.organs.size();
  for (const std::size_t batch : batches_of_[component]) {
    const Made& of_batch = batches_[batch];
    for (std::size_t b = 0; b < of_batch.result->blocks.size(); ++b) {
      const Emitted& block = of_batch.result->blocks[b];
      OrganList* const own = of_batch.own != nullptr ? &of_batch.own->blocks[b].organs : nullptr;
      OrgansOfBlock& organs = blocks.emplace_back(OrgansOfBlock{&block, own, {}, {}, count});
      for (std::size_t k = 0; k < block.deformed.size(); ++k) {
        const auto& [first, deformation] = block.deformed[k];
        const std::size_t end = k + 1 < block.deformed.size() ? block.deformed[k + 1].organ : block.organs.size();
        if (deformation != nullptr) deformed.push_back({count + first, end - first, deformation});
      }
      count += block.organs.size();
      for (const std::uint64_t id : block.individuals) organs.individual.push_back(individuals.number(id));
      for (const Emitted::EmittedPrototype& made : block.prototypes) {
        const auto next = static_cast<std::uint32_t>(plant.prototypes.size());
        const auto [known, is_new] = prototype_by_key.try_emplace(made.key, next);
        organs.prototype.push_back(known->second);
        if (!is_new) continue;
        plant.prototypes.push_back({graph_.components[component].id, made.is_blade ? blades : material, made.mesh});
      }
    }
  }
  for (std::size_t first = 0; first < blocks.size(); first += kBlocksTogether) {
    const std::size_t last = std::min(blocks.size(), first + kBlocksTogether);
    plant.organs.resize(last < blocks.size() ? blocks[last].first : count);
    parallel_for(last - first, 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = first + begin; k < first + end; ++k) {
        Organ* next = plant.organs.data() + blocks[k].first;
        blocks[k].block->organs.read([&](const Organ& organ) {
          *next = organ;
          next->individual = blocks[k].individual[organ.individual];
          next++->prototype = blocks[k].prototype[organ.prototype];
        });
        if (blocks[k].own != nullptr) *blocks[k].own = OrganList();
      }
    });
    if (plant.organs.size() >= kManyOrgans) give_back_memory();
  }
}

void PlantAssembly::add_surfaces(ComponentIndex component, std::uint32_t material, const Surfaces& surfaces,
                                 Plant& plant, Rows& deformed) const {
  for (const SurfacePiece& piece : surfaces) {
    for (std::size_t k = 0; k < piece.organs.size(); ++k) {
      Organ organ = piece.organs[k];
      if (piece.deformations[k] != nullptr) deformed.push_back({plant.organs.size(), 1, piece.deformations[k]});
      organ.prototype = static_cast<std::uint32_t>(plant.prototypes.size());
      plant.organs.push_back(organ);
    }
    plant.prototypes.push_back({graph_.components[component].id, material, piece.mesh});
  }
}

std::vector<Stem> PlantAssembly::joined_stems(const std::vector<std::uint32_t>& material_of_component,
                                              const Individuals& individuals) {
  std::size_t count = 0;
  for (const Made& made : batches_) {
    for (const Emitted& block : made.result->blocks) count += block.stems.size();
  }
  std::vector<LooseStem> stems;
  stems.reserve(count);
  std::unordered_map<std::uint64_t, std::uint32_t> number_of_stem;  // index in `stems`, by stem id
  number_of_stem.reserve(count);
  std::vector<std::uint32_t> instances(batches_of_.size(), 0);
  std::size_t given_back = 0;  // number of stems when freed memory was last returned
  const auto parent_of = [&](const EmittedStem& stem) {
    const auto found = number_of_stem.find(stem.site.stem);
    return found == number_of_stem.end() ? kNoStem : found->second;
  };
  for (const Made& made : batches_) {
    for (std::size_t b = 0; b < made.result->blocks.size(); ++b) {
      std::vector<EmittedStem>* const own = made.own != nullptr ? &made.own->blocks[b].stems : nullptr;
      bool is_kept = false;  // true: a stem's skeleton is still in the block
      for (std::size_t k = 0; k < made.result->blocks[b].stems.size(); ++k) {
        const EmittedStem& emitted = made.result->blocks[b].stems[k];
        if (!emitted.visible) continue;
        // A stem that `place` has moved is attached to nothing.
        const bool is_moved = emitted.moved != nullptr;
        LooseStem& stem = stems.emplace_back();
        stem.parent = is_moved ? kNoStem : parent_of(emitted);
        number_of_stem.emplace(emitted.id(), static_cast<std::uint32_t>(stems.size() - 1));
        stem.part = {.component = graph_.components[made.component].id,
                     .instance = instances[made.component]++,
                     .material = material_of_component[made.component],
                     .surface = *emitted.surface,
                     .tint = emitted.tint,
                     .deformation = emitted.deformation()};
        if (is_moved && stem.part.surface.crown) stem.part.surface.crown->scale(emitted.moved_scale);
        stem.node = emitted.site.node;
        stem.along = emitted.site.along;
        if (individuals.list.size() > 1) {
          stem.individual_of_root =
              individuals_of_roots(emitted, [&](std::uint64_t id) { return individuals.number(id); });
        }
        stem.name = emitted.id();
        if (emitted.trimmed != nullptr) stem.number_of_axis = emitted.trimmed->whole_axes();
        if (own != nullptr && !is_moved) {
          stem.skeleton = stem.own = std::make_shared<Skeleton>(std::move((*own)[k].skeleton));
        } else {
          // Keeps the whole batch alive, which owns the skeleton.
          stem.skeleton = {made.result, is_moved ? emitted.moved.get() : &emitted.skeleton};
          is_kept = true;
        }
      }
      if (own == nullptr || is_kept) continue;
      *own = std::vector<EmittedStem>();
      if (stems.size() < given_back + kManyStems) continue;
      give_back_memory();
      given_back = stems.size();
    }
  }
  std::vector<Stem> joined = join_stems(std::move(stems));
  std::erase_if(joined, [](const Stem& stem) { return stem.skeleton.node_count() == 0; });
  return joined;
}

}  // namespace meristem
