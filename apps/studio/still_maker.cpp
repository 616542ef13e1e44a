// SPDX-License-Identifier: Apache-2.0
#include "still_maker.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base64.h"
#include "meristem/base/vec.h"
#include "meristem/components/camera.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/picture.h"
#include "meristem/output/write/png.h"
#include "shown_pictures.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

constexpr double kEnoughTriangles = 60'000;  // of one small picture; more are not seen
constexpr double kLeastShare = 1e-3;         // of a plant's triangles, that is asked for
constexpr int kSamplesPerPixel = 8;

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

double distance_of(const View& view) { return glm::distance(*view.position, *view.target); }

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
    state.document =
        read_document(source.text, source.file, registry,
                      {.overrides = values, .root = source.root, .store = &store_, .models = source.models});
    const Document& document = *state.document;
    state.grown = grow_document(document, progress, {.time = source.time, .up_to = GrownPart::plant, .cache = &cache_});
    if (source.grown != nullptr) {
      ShownPictures pictures;
      std::vector<Material> painted = source.grown->plant.materials;
      pictures.keep(source.grown->wish.document->graph, painted);
      pictures.lend(document.graph, state.grown.plant.materials);
    }
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

  // One camera for all, as far back as the largest plant asks for.
  const double aspect = static_cast<double>(request.width) / request.height;
  const View asked = view_from(request.camera);
  std::optional<View> view;
  for (const State& state : states) {
    if (!request.fits || !state.document || state.grown.meshes.triangle_count() == 0) continue;
    const View fit = fitted(asked, state.grown.meshes, aspect);
    if (!view || distance_of(fit) > distance_of(*view)) view = fit;
  }

  const PictureOptions picture{
      .still = {.width = request.width, .height = request.height, .samples = kSamplesPerPixel, .transparent = true},
      .view = view.value_or(asked)};
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
