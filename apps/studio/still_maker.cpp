// SPDX-License-Identifier: Apache-2.0
// Grows the states of a document in a few lanes and draws their pictures in parallel. Each lane has caches of its own;
// a state returns to its lane, so that it finds its earlier results. Detail is reduced to what few pixels can show.
#include "still_maker.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base64.h"
#include "meristem/base/cache.h"
#include "meristem/base/parallel.h"
#include "meristem/base/vec.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/export/picture/picture.h"
#include "meristem/graph/table/read_store.h"
#include "meristem/graph/texture_parameters.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/write/png.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

// Triangles of one small picture; with half as many, one can see through an old oak
constexpr double kEnoughTriangles = 60'000;
constexpr double kMinShare = 1e-3;  // minimum share of a plant's triangles that is requested
constexpr int kSamplesPerPixel = 4;
constexpr int kTexelsPerPixel = 2;    // along a picture's side, for textures on plants that are seen as a whole
constexpr std::size_t kMaxLanes = 4;  // maximum number of lanes
constexpr std::uint64_t kMaxStillBytes = 500'000'000;  // maximum size of grown plants that are kept between pictures

double triangles_of(const Plant& plant) {
  double triangles = 8 * static_cast<double>(plant.node_count());
  for (const Organ& organ : plant.organs)
    triangles += static_cast<double>(plant.prototypes[organ.prototype].mesh->triangle_count());
  return triangles;
}

/// Returns the detail of the meshes. Only few different details are used, so that caches are useful.
MeshDetail detail_for(const Plant& plant) {
  const double wanted = kEnoughTriangles / std::max(1.0, triangles_of(plant));
  if (wanted >= 1) return {};
  double share = 0.5;
  while (share > wanted && share > kMinShare) share /= 2;
  return {.level = 1, .share = share};
}

CameraView view_from(const CameraOptions& camera) {
  CameraView view;
  view.position = camera.position;
  view.target = camera.target;
  view.field_of_view = radians(camera.field_of_view_deg);
  return view;
}

const Prototype* owner_of(const Graph& graph, const Material& material) {
  const auto found = std::ranges::find(graph.components, material.name, &Prototype::id);
  return found == graph.components.end() ? nullptr : &*found;
}

/// Returns true if both documents have equal texture recipes, whatever the shape and the colour.
bool have_one_recipe(const Prototype* one, const Prototype* other) {
  if (one == nullptr || other == nullptr) return false;
  const auto fingerprint_of = [](const Prototype& prototype) {
    const auto sketch = sketch_texture(prototype.base().texture, TextureShape(), Vec3(0.5F));
    return sketch != nullptr ? sketch->fingerprint : 0;
  };
  return fingerprint_of(*one) == fingerprint_of(*other);
}

/// Replaces unpainted textures by pictures that were painted from an equal recipe. On another shape they are slightly
/// displaced, which is invisible in a small picture.
void lend_pictures(const GrownPlant& painted, const Graph& graph, std::vector<Material>& materials) {
  for (Material& material : materials) {
    if (material.texture == nullptr || material.texture->is_painted()) continue;
    const auto known = std::ranges::find(painted.plant.materials, material.name, &Material::name);
    if (known == painted.plant.materials.end() || known->texture == nullptr || !known->texture->is_painted()) continue;
    const Prototype* const before = owner_of(painted.document->graph, *known);
    if (have_one_recipe(owner_of(graph, material), before)) material.texture = known->texture;
  }
}

/// Returns the size of textures: a power of two, so that pictures of nearly equal size share their textures.
int small_texture_size(const StillsRequest& request) {
  const int pixels = kTexelsPerPixel * std::max(request.width, request.height);
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(pixels)));
}

/// Returns the view from a side that shows all of a scene.
CameraView fitted(const CameraView& view, const MeshScene& scene, double aspect) {
  const DVec3 away = DVec3(*view.position) - DVec3(*view.target);
  CameraView fit = view;
  fit.position.reset();
  fit.target.reset();
  fit.azimuth = std::atan2(away.x, -away.z);
  fit.altitude = std::atan2(away.y, std::hypot(away.x, away.z));
  return placed_view(scene, fit, aspect);
}

}  // namespace

/// A grown document with other values. It has no scene if the document has faults.
struct StillMaker::State {
  std::optional<Scene> scene{};
  SizeLimits limits{};
  GrownDocument grown{};
  Value errors{};
};

/// States that grow one after another, in parallel with other lanes, and the results that they leave for the next
/// pictures.
struct StillMaker::Lane {
  ReadStore store{};
  GrowthCache plants{};
  GrowthCache meshes{};

  std::uint64_t kept_bytes() const { return plants.bytes() + meshes.bytes(); }

  State grow(const StillSource& source, const std::vector<ValueOverride>& values, const Registry& registry,
             Progress& progress) {
    State state;
    try {
      const Document document = read_document(
          source.text, source.file, registry,
          {.overrides = values, .time = source.time, .root = source.root, .store = &store, .models = source.models});
      GrownDocument& grown = state.grown;
      grown = grow_document(document, progress, {.time = source.time, .up_to = GrownPart::plant, .cache = &plants});
      if (source.grown != nullptr) lend_pictures(*source.grown, document.graph, grown.plant.materials);
      grown.meshes = mesh_detail(document, grown.plant, detail_for(grown.plant), progress, &meshes);
      grown.up_to = GrownPart::meshes;
      complete_growth(document, grown, progress, {.time = source.time, .cache = &plants});
      grown.plant = {};
      state.scene = document.scene;
      state.limits = document.graph.limits;
    } catch (const InputError& error) {
      state = {};
      state.errors = errors_value(error.diagnostics(), {}, "");
    }
    return state;
  }
};

StillMaker::StillMaker() = default;
StillMaker::~StillMaker() = default;

std::uint64_t StillMaker::kept_bytes() const {
  std::uint64_t sum = 0;
  for (const std::unique_ptr<Lane>& lane : lanes_) sum += lane->kept_bytes();
  return sum;
}

/// Grows all states. A state keeps its lane while the number of states is unchanged, so that it finds its earlier
/// results.
std::vector<StillMaker::State> StillMaker::grow(const StillSource& source, const StillsRequest& request,
                                                const Registry& registry, Progress& progress) {
  std::vector<State> states(request.states.size());
  const std::size_t count = std::min({states.size(), static_cast<std::size_t>(thread_count()), kMaxLanes});
  while (lanes_.size() < count) lanes_.push_back(std::make_unique<Lane>());
  lanes_.resize(count);
  progress.begin("growing", states.size());
  parallel_for(count, 1, [&](std::size_t first, std::size_t) {
    Lane& lane = *lanes_[first];
    CacheSeries plants(lane.plants);
    CacheSeries meshes(lane.meshes);
    for (std::size_t k = first; k < states.size(); k += count) {
      Progress part(&progress);
      states[k] = lane.grow(source, request.states[k], registry, part);
      progress.advance();
    }
    plants.end();
    meshes.end();
    if (lane.kept_bytes() > kMaxStillBytes / count) {
      lane.plants.clear();
      lane.meshes.clear();
    }
  });
  return states;
}

Value StillMaker::make(const StillSource& source, const StillsRequest& request, const Registry& registry,
                       Progress& progress) {
  std::vector<State> states = grow(source, request, registry, progress);

  // All states share a camera, as far back as necessary to show each of them.
  const double aspect = static_cast<double>(request.width) / request.height;
  CameraView view = view_from(request.camera);
  if (request.fits) {
    MeshScene all;
    for (const State& state : states) {
      const std::vector<MeshInstances>& meshes = state.grown.meshes.meshes;
      all.meshes.insert(all.meshes.end(), meshes.begin(), meshes.end());
    }
    if (all.triangle_count() > 0) view = fitted(view, all, aspect);
    // If a plant is seen as a whole, no part of it is larger than the picture. Seen from near, parts may be.
    std::vector<std::vector<Material>*> worn;
    for (State& state : states) worn.push_back(&state.grown.meshes.materials);
    textures_.fit(worn, small_texture_size(request), progress);
  }

  // The pictures are drawn in parallel.
  const PictureOptions picture{
      .still = {.width = request.width, .height = request.height, .samples = kSamplesPerPixel, .transparent = true},
      .view = view};
  Value::List made(states.size());
  progress.begin("drawing", states.size());
  parallel_for(states.size(), 1, [&](std::size_t k, std::size_t) {
    const State& state = states[k];
    if (state.scene) {
      Progress part(&progress);
      const Image image = take_picture(state.grown, state.limits, *state.scene, picture, part);
      made[k] = Value::Object{{"picture", base64(encode_png(image, PixelKind::srgb, PngPacking::quick))}};
    } else {
      made[k] = Value::Object{{"faults", state.errors}};
    }
    progress.advance();
  });
  return made;
}

}  // namespace meristem::studio
