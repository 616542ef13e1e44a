// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_pictures.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/components/camera.h"
#include "meristem/output/picture/picture.h"
#include "meristem/output/picture/truth_files.h"
#include "meristem/output/write/picture_file.h"

namespace meristem {

namespace {

/// The view of a number among those of a plant.
View view_of(const PicturePlan& pictures, const PlannedPlant& plant, const Document& document, int number) {
  View view = camera_view(document.graph);
  if (pictures.fixed_views.empty() && pictures.drawn_views == 0) return view;
  double azimuth = 0;
  double altitude = 0;
  if (!pictures.fixed_views.empty()) {
    std::tie(azimuth, altitude) = pictures.fixed_views[static_cast<std::size_t>(number)];
  } else {
    const RandomKey key = plant.random.child("view").child(static_cast<std::uint64_t>(number));
    azimuth = *pictures.azimuth.draw(key.child("azimuth")).number();
    altitude = *pictures.altitude.draw(key.child("altitude")).number();
  }
  return seen_from(view, std::clamp(azimuth, -360.0, 360.0), std::clamp(altitude, -89.0, 89.0)).value_or(view);
}

/// The files of the truth that a plan asks for: each kind with its ending.
std::vector<std::pair<std::string_view, std::string>> truth_endings(const PicturePlan& pictures) {
  std::vector<std::pair<std::string_view, std::string>> endings;
  const auto add_map = [&](std::string_view name, PicturePlan::Map map) {
    if (map == PicturePlan::Map::none) return;
    endings.emplace_back(name, fmt::format(".{}.{}", name, map == PicturePlan::Map::png ? "png" : "pfm"));
  };
  add_map("depth", pictures.depth);
  add_map("normals", pictures.normals);
  if (pictures.organs) endings.emplace_back("organs", ".organs.png");
  if (pictures.shoots) endings.emplace_back("shoots", ".shoots.png");
  if (pictures.plants) endings.emplace_back("plants", ".plants.png");
  if (pictures.coco) endings.emplace_back("coco", ".coco.json");
  return endings;
}

}  // namespace

void write_plant_pictures(const DatasetPlan& plan, const PlannedPlant& plant, const Document& document,
                          const GrownDocument& grown, const std::string& base, Progress& progress) {
  const PicturePlan& pictures = *plan.pictures;
  const auto endings = truth_endings(pictures);
  const int count = pictures.view_count();
  for (int k = 0; k < count; ++k) {
    const std::string path = count == 1 ? base : fmt::format("{}_{:0{}}", base, k, std::to_string(count - 1).size());
    const View view = view_of(pictures, plant, document, k);
    std::string picture;
    if (pictures.colour != PicturePlan::Colour::none) {
      picture = path + (pictures.colour == PicturePlan::Colour::png ? ".png" : ".jpg");
      const PictureOptions options{.still = {.width = pictures.size[0],
                                             .height = pictures.size[1],
                                             .samples = pictures.samples,
                                             .transparent = pictures.transparent},
                                   .view = view};
      write_picture(take_picture(grown, document.scene, options, progress), picture);
    }
    if (endings.empty()) continue;
    const TruthOptions options{
        .width = pictures.size[0], .height = pictures.size[1], .transparent = pictures.transparent};
    const Truth truth = see_truth(grown, document.scene, view, options, progress);
    const Camera camera = truth_camera(grown, document.scene, view, options);
    const TruthContext context{.picture = std::filesystem::path(picture).filename().string(),
                               .name = plan.name.empty() ? document.name : plan.name,
                               .licence = plan.licence.empty() ? document.licence : plan.licence};
    for (const auto& [name, ending] : endings) {
      AtomicFile file(path + ending);
      file.write(encode_truth(truth, camera, truth_format(name), path + ending, context));
      file.commit();
    }
  }
}

}  // namespace meristem
