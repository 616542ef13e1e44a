// SPDX-License-Identifier: Apache-2.0
// In: a plant and a number of triangles. Out: its meshes with about as many. The triangles are divided among the plant
// itself and the variants that stand in it before anything is meshed. Each one is then meshed directly at the
// coarseness that its part of the triangles allows.
#include "meristem/shape/assembly/view_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/base/math.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/own_meshes.h"
#include "meristem/shape/assembly/planting_meshes.h"
#include "meristem/shape/detail/detail_budget.h"
#include "meristem/shape/stem/body_meshes.h"

namespace meristem {
namespace {

constexpr double kOwnShare = 0.25;            // share of the triangles for everything that is not a placed plant
constexpr double kCrowding = 0.75;            // larger values give fewer triangles to plants that stand in many places
constexpr double kSizeWeight = 0.2;           // larger values give more triangles to plants with more triangles
constexpr double kFewestPlantTriangles = 40;  // minimum for a placed plant; with fewer, it no longer looks like a plant
constexpr double kNearlyWhole = 4;   // a plant with up to this many times its part of the triangles is counted exactly
constexpr double kStepsPerHalf = 4;  // steps of shares per halving; few different shares make caches effective
constexpr double kAboutPart = 1.1;   // times its part of the triangles: a result up to this size is accepted
constexpr double kStillFalls = 0.9;  // times the triangles of the attempt before: above this, more attempts do not help
constexpr int kMaxTries = 3;
constexpr double kBytesPerTriangle = 44;  // maximum, for tubes

/// Estimates of the number of triangles of plants. Each variant is counted once.
class Estimates {
 public:
  /// Returns the estimate without plantings.
  double own(const Plant& plant) {
    double triangles = about_body_triangles(plant);
    for (const Stem& stem : plant.stems) {
      for (NodeIndex node = 0; node < stem.skeleton.node_count(); ++node) triangles += about_tube_triangles(stem, node);
    }
    for (const Organ& organ : plant.organs) {
      triangles += static_cast<double>(plant.prototypes[organ.prototype].mesh->triangle_count());
    }
    return triangles;
  }

  double whole(const Plant& plant) {
    double triangles = own(plant);
    for (const Planting& planting : plant.plantings) {
      triangles += of(*planting.variant) * static_cast<double>(planting.places.size());
    }
    return triangles;
  }

  double of(const PlantVariant& variant) {
    const auto found = known_.find(&variant);
    if (found != known_.end()) return found->second;
    const double triangles = whole(*variant.plant);
    known_.emplace(&variant, triangles);
    return triangles;
  }

 private:
  std::unordered_map<const PlantVariant*, double> known_;
};

/// A request for triangles.
struct Claim {
  const PlantVariant* variant = nullptr;  // null for the plant itself
  double whole = 0;                       // triangles of one plant
  double places = 1;
  double granted = 0;  // triangles of one plant

  /// Returns the number of triangles with which its meshes are made.
  double wanted() const { return std::max(granted, std::min(whole, kFewestPlantTriangles)); }
};

/// Grants each claim a number of triangles by its weight, but no more than it needs.
void divide(std::vector<Claim*> claims, double triangles) {
  double wanted = 0;
  for (const Claim* claim : claims) wanted += claim->whole * claim->places;
  if (wanted <= triangles) {
    for (Claim* claim : claims) claim->granted = claim->whole;
    return;
  }
  const auto weight = [](const Claim& claim) {
    return math::pow(std::max(claim.whole, 1.0), kSizeWeight) * math::pow(claim.places, -kCrowding);
  };
  std::stable_sort(claims.begin(), claims.end(),
                   [&](const Claim* a, const Claim* b) { return a->whole / weight(*a) < b->whole / weight(*b); });
  double weights = 0;
  for (const Claim* claim : claims) weights += weight(*claim) * claim->places;
  for (Claim* claim : claims) {
    const double max = weights > 0 ? std::max(0.0, triangles) * weight(*claim) / weights : 0;
    claim->granted = std::min(claim->whole, max);
    triangles -= claim->granted * claim->places;
    weights -= weight(*claim) * claim->places;
  }
}

/// Returns the granted claims of a plant and of its variants. The first is the plant's.
std::vector<Claim> granted_claims(const Plant& plant, double triangles, Estimates& estimates) {
  std::vector<Claim> claims{{.whole = estimates.own(plant)}};
  std::unordered_map<const PlantVariant*, std::size_t> number;
  for (const Planting& planting : plant.plantings) {
    if (planting.places.empty()) continue;
    const auto [known, is_new] = number.try_emplace(planting.variant.get(), claims.size());
    if (is_new) {
      claims.push_back({.variant = planting.variant.get(), .whole = estimates.of(*planting.variant), .places = 0});
    }
    claims[known->second].places += static_cast<double>(planting.places.size());
  }
  std::vector<Claim*> all;
  for (Claim& claim : claims) all.push_back(&claim);
  divide(all, triangles);
  Claim& own = claims.front();
  const double min = std::min(own.whole, kOwnShare * triangles);
  if (own.granted < min) {
    own.granted = min;
    divide({all.begin() + 1, all.end()}, triangles - min);
  }
  return claims;
}

/// Returns the next lower of a few shares.
double stepped(double share) {
  return math::pow(2.0, std::floor(kStepsPerHalf * math::log(share) / math::log(2.0) + 1e-9) / kStepsPerHalf);
}

struct OwnMeshes {
  MeshScene scene;
  bool is_whole = true;
};

/// Returns the meshes of a plant without its plantings, with about `granted` of its `whole` triangles.
OwnMeshes own_meshes_within(const Plant& plant, const SizeLimits& limits, double whole, double granted,
                            const ViewMeshOptions& options, Progress& progress, Cache* cache) {
  // The estimate is high. If it is near the limit, count exactly.
  if (whole > granted && whole <= kNearlyWhole * granted) {
    whole = static_cast<double>(planned_triangles(plant, limits)) + about_body_triangles(plant);
  }
  if (whole <= granted) return {make_own_meshes(plant, {limits, {.work = options.work}, cache}, progress), true};
  double share = stepped(std::max(granted, 1.0) / whole);
  MeshScene made;
  for (int k = 0; k < kMaxTries; ++k) {
    const std::uint64_t before = made.triangle_count();
    const MeshDetail detail{.level = 1, .share = share, .is_quick = true, .work = options.work};
    made = make_own_meshes(plant, {limits, detail, cache}, progress);
    const auto count = static_cast<double>(made.triangle_count());
    if (count <= kAboutPart * granted || (k > 0 && count > kStillFalls * static_cast<double>(before))) break;
    share = stepped(share * granted / count);
  }
  return {std::move(made), false};
}

/// Throws InputError if the whole plant would exceed a limit. Plans tubes only if the estimate is near a limit.
void check_whole(const Plant& plant, const SizeLimits& limits, Estimates& estimates) {
  double about = estimates.own(plant);
  std::unordered_map<const PlantVariant*, bool> seen;
  std::vector<const Plant*> plants{&plant};
  for (std::size_t k = 0; k < plants.size(); ++k) {
    for (const Planting& planting : plants[k]->plantings) {
      if (!seen.try_emplace(planting.variant.get(), true).second) continue;
      plants.push_back(planting.variant->plant.get());
      about += estimates.own(*planting.variant->plant);
    }
  }
  if (about <= static_cast<double>(limits.triangles) &&
      about * kBytesPerTriangle <= static_cast<double>(limits.mesh_bytes)) {
    return;
  }
  std::uint64_t triangles = 0;
  for (const Plant* each : plants) triangles += planned_triangles(*each, limits);
  if (triangles <= limits.triangles) return;
  throw_limit("triangles", static_cast<double>(triangles), limits.triangles, "triangles",
              "components." + plant.plantings.front().component);
}

ViewMeshes meshes_within(const Plant& plant, const SizeLimits& limits, const ViewMeshOptions& options,
                         Estimates& estimates, Progress& progress, Cache* cache) {
  const std::vector<Claim> claims = granted_claims(plant, static_cast<double>(options.triangles), estimates);
  const Claim& own = claims.front();
  OwnMeshes made = own_meshes_within(plant, limits, own.whole, own.granted, options, progress, cache);
  ViewMeshes meshes{.scene = std::move(made.scene), .is_whole = made.is_whole};
  if (has_plantings(plant)) {
    std::unordered_map<const PlantVariant*, const Claim*> claim_of;
    for (const Claim& claim : claims) claim_of.emplace(claim.variant, &claim);
    const auto granted = [&](const PlantVariant& variant) {
      const Claim& claim = *claim_of.at(&variant);
      return claim.granted >= claim.whole ? claim.whole : claim.whole * stepped(claim.wanted() / claim.whole);
    };
    const PlantingRecipe recipe{
        .make =
            [&](const std::shared_ptr<const PlantVariant>& variant, Progress& part) {
              const ViewMeshOptions of_variant{static_cast<std::uint64_t>(std::ceil(granted(*variant))), options.work};
              ViewMeshes placed = make_view_meshes(*variant->plant, limits, of_variant, part);
              return VariantMeshes{std::move(placed.scene), placed.is_whole};
            },
        .add_key = [&](const PlantVariant& variant, Fingerprint& key) { key.add_text("view").add(granted(variant)); },
        .shown_places =
            [&](const PlantVariant& variant, std::uint64_t triangles) {
              const double max = claim_of.at(&variant)->granted;
              return static_cast<double>(triangles) <= kAboutPart * max ? 1 : max / static_cast<double>(triangles);
            }};
    const bool are_whole = add_plantings(meshes.scene, plant.plantings, recipe, limits, progress, cache);
    meshes.is_whole = meshes.is_whole && are_whole;
  }
  meshes.triangles =
      meshes.is_whole ? meshes.scene.triangle_count() : static_cast<std::uint64_t>(estimates.whole(plant));
  return meshes;
}

}  // namespace

double about_triangles(const Plant& plant) { return Estimates().whole(plant); }

ViewMeshes make_view_meshes(const Plant& plant, const SizeLimits& limits, const ViewMeshOptions& options,
                            Progress& progress, Cache* cache) {
  if (has_deformed_plantings(plant)) {
    return make_view_meshes(with_deformed_copies(plant, limits, progress), limits, options, progress, cache);
  }
  Estimates estimates;
  check_whole(plant, limits, estimates);
  return meshes_within(plant, limits, options, estimates, progress, cache);
}

}  // namespace meristem
