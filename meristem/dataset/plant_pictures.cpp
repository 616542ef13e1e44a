// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_pictures.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "meristem/components/camera.h"
#include "meristem/export/picture/picture.h"
#include "meristem/export/picture/truth_files.h"
#include "meristem/output/write/picture_file.h"

namespace meristem {

namespace {

/// Returns the view with this number, among the views of a plant.
CameraView view_of(const PicturePlan& pictures, const PlannedPlant& plant, const Document& document, int number) {
  CameraView view = camera_view(document.graph);
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

/// Returns the files of truth that a plan requests for a picture at `base`.
std::vector<TruthFile> truth_files(const PicturePlan& pictures, const std::string& base) {
  std::vector<TruthFile> files;
  const auto add = [&](std::string_view name, bool is_wanted, bool is_second = false) {
    if (!is_wanted) return;
    const TruthFormat& format = truth_format(name);
    files.push_back({&format, fmt::format("{}.{}{}", base, name, format.endings[is_second ? 1 : 0])});
  };
  const auto add_map = [&](std::string_view name, PicturePlan::Map map) {
    add(name, map != PicturePlan::Map::none, map == PicturePlan::Map::pfm);
  };
  add_map("depth", pictures.depth);
  add_map("normals", pictures.normals);
  add("organs", pictures.organs);
  add("shoots", pictures.shoots);
  add("plants", pictures.plants);
  add("coco", pictures.coco);
  return files;
}

}  // namespace

void write_plant_pictures(const DatasetPlan& plan, const PlannedPlant& plant, const Document& document,
                          const GrownDocument& grown, const std::string& base, Progress& progress) {
  const PicturePlan& pictures = *plan.pictures;
  const int count = pictures.view_count();
  for (int k = 0; k < count; ++k) {
    const std::string path = count == 1 ? base : fmt::format("{}_{:0{}}", base, k, std::to_string(count - 1).size());
    const CameraView view = view_of(pictures, plant, document, k);
    std::string picture;
    if (pictures.colour != PicturePlan::Colour::none) {
      picture = path + (pictures.colour == PicturePlan::Colour::png ? ".png" : ".jpg");
      const PictureOptions options{.still = {.width = pictures.size[0],
                                             .height = pictures.size[1],
                                             .samples = pictures.samples,
                                             .transparent = pictures.transparent},
                                   .view = view};
      write_picture(take_picture(grown, document.graph.limits, document.scene, options, progress), picture);
    }
    const std::vector<TruthFile> files = truth_files(pictures, path);
    if (files.empty()) continue;
    const TruthOptions options{
        .width = pictures.size[0], .height = pictures.size[1], .transparent = pictures.transparent};
    write_truths(see_truth(grown, document.graph.limits, document.scene, view, options, progress), files,
                 {.picture = std::filesystem::path(picture).filename().string(),
                  .name = plan.name.empty() ? document.name : plan.name,
                  .licence = plan.licence.empty() ? document.licence : plan.licence});
  }
}

}  // namespace meristem
