// SPDX-License-Identifier: Apache-2.0
#include "still_maker.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base64.h"
#include "meristem/base/vec.h"
#include "meristem/graph/texture_parameters.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/picture.h"
#include "meristem/output/write/png.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

constexpr double kEnoughTriangles = 30'000;  // of one small picture; more are not seen
constexpr double kLeastShare = 1e-3;         // of a plant's triangles, that is asked for
constexpr int kSamplesPerPixel = 4;

double triangles_of(const Plant& plant) {
  double triangles = 8 * static_cast<double>(plant.node_count());
  for (const Organ& organ : plant.organs)
    triangles += static_cast<double>(plant.prototypes[organ.prototype].mesh->triangle_count());
  return triangles;
}

/// How coarse meshes may be. Few different answers, so that a cache is of use.
Detail detail_for(const Plant& plant) {
  const double wanted = kEnoughTriangles / std::max(1.0, triangles_of(plant));
  if (wanted >= 1) return {};
  double share = 0.5;
  while (share > wanted && share > kLeastShare) share /= 2;
  return {.level = 1, .share = share};
}

View view_from(const CameraOptions& camera) {
  View view;
  view.position = camera.position;
  view.target = camera.target;
  view.field_of_view = radians(camera.field_of_view_deg);
  return view;
}

const Prototype* owner_of(const Graph& graph, const Material& material) {
  const auto found = std::ranges::find(graph.components, material.name, &Prototype::id);
  return found == graph.components.end() ? nullptr : &*found;
}

/// Whether both documents ask for one texture, whatever the shape that wears it and its colour.
bool have_one_recipe(const Prototype* one, const Prototype* other) {
  if (one == nullptr || other == nullptr) return false;
  const auto fingerprint_of = [](const Prototype& prototype) {
    const auto sketch = sketch_texture(prototype.base().texture, TextureShape(), Vec3(0.5F));
    return sketch != nullptr ? sketch->fingerprint : 0;
  };
  return fingerprint_of(*one) == fingerprint_of(*other);
}

/// Has materials that wait for their painting wear what has been painted by the same recipe: on another shape it lies a
/// little otherwise than it will, which nobody sees in a small picture.
void lend_pictures(const GrownWish& painted, const Graph& graph, std::vector<Material>& materials) {
  for (Material& material : materials) {
    if (material.texture == nullptr || material.texture->is_painted()) continue;
    const auto known = std::ranges::find(painted.plant.materials, material.name, &Material::name);
    if (known == painted.plant.materials.end() || known->texture == nullptr || !known->texture->is_painted()) continue;
    const Prototype* const before = owner_of(painted.document->graph, *known);
    if (have_one_recipe(owner_of(graph, material), before)) material.texture = known->texture;
  }
}

/// The view from the same side that shows all of a scene.
View fitted(const View& view, const MeshScene& scene, double aspect) {
  const DVec3 away = DVec3(*view.position) - DVec3(*view.target);
  View fit = view;
  fit.position.reset();
  fit.target.reset();
  fit.azimuth = std::atan2(away.x, -away.z);
  fit.altitude = std::atan2(away.y, std::hypot(away.x, away.z));
  return placed_view(scene, fit, aspect);
}

}  // namespace

/// A document with other values, as it has grown; without a document where it has faults.
struct StillMaker::State {
  std::optional<Document> document{};
  GrownDocument grown{};
  Value faults{};
};

StillMaker::State StillMaker::grow(const StillSource& source, const std::vector<Override>& values,
                                   const Registry& registry, Progress& progress) {
  State state;
  try {
    state.document = read_document(
        source.text, source.file, registry,
        {.overrides = values, .time = source.time, .root = source.root, .store = &store_, .models = source.models});
    const Document& document = *state.document;
    state.grown = grow_document(document, progress, {.time = source.time, .up_to = GrownPart::plant, .cache = &cache_});
    if (source.grown != nullptr) lend_pictures(*source.grown, document.graph, state.grown.plant.materials);
    state.grown.meshes =
        mesh_detail(document, state.grown.plant, detail_for(state.grown.plant), progress, &coarse_cache_);
    state.grown.up_to = GrownPart::meshes;
    complete_growth(document, state.grown, progress, {.time = source.time, .cache = &cache_});
  } catch (const InputError& error) {
    state.document.reset();
    state.faults = faults_value(error.diagnostics(), {}, "");
  }
  return state;
}

Value StillMaker::make(const StillSource& source, const StillsRequest& request, const Registry& registry,
                       Progress& progress) {
  std::vector<State> states;
  for (const std::vector<Override>& values : request.states) states.push_back(grow(source, values, registry, progress));

  // One camera for all, as far back as shows each of them.
  const double aspect = static_cast<double>(request.width) / request.height;
  View view = view_from(request.camera);
  if (request.fits) {
    MeshScene all;
    for (const State& state : states) {
      const std::vector<MeshInstances>& meshes = state.grown.meshes.meshes;
      if (state.document) all.meshes.insert(all.meshes.end(), meshes.begin(), meshes.end());
    }
    if (all.triangle_count() > 0) view = fitted(view, all, aspect);
  }

  const PictureOptions picture{
      .still = {.width = request.width, .height = request.height, .samples = kSamplesPerPixel, .transparent = true},
      .view = view};
  Value::List made;
  for (const State& state : states) {
    if (!state.document) {
      made.push_back(Value::Object{{"faults", state.faults}});
      continue;
    }
    const Image image = take_picture(state.grown, state.document->scene, picture, progress);
    made.push_back(Value::Object{{"picture", base64(encode_png(image, PixelKind::srgb, PngPacking::quick))}});
  }
  return made;
}

}  // namespace meristem::studio
