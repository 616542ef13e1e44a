// SPDX-License-Identifier: Apache-2.0
// Writes the ground truth of a picture as PNG, PFM and COCO JSON. Run-length text stores the difference to the run
// before the last, with five bits per character and one bit that says if more follow.
//
// Based on: P. Dollár, T.-Y. Lin: maskApi.c of the COCO API (2015).
#include "meristem/export/picture/truth_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/version.h"
#include "meristem/base/whole_file.h"
#include "meristem/document/json.h"
#include "meristem/output/write/names.h"
#include "meristem/output/write/png.h"

namespace meristem {

namespace {

constexpr std::array<TruthFormat, 6> kTruthFormats{{
    {"depth", {".png", ".pfm"}, "Distance of each pixel's surface from the camera, along the way that it looks."},
    {"normals", {".png", ".pfm"}, "Direction in which each pixel's surface faces, as the camera sees it."},
    {"organs", {".png"}, "Number of the leaf, flower, fruit or wood of a shoot in each pixel."},
    {"shoots", {".png"}, "Number of the shoot in each pixel, with the organs on it."},
    {"plants", {".png"}, "Number of the plant in each pixel."},
    {"coco", {".json"}, "Outline, box, area and kind of each thing that is seen, in the format of COCO data sets."},
}};

constexpr std::array<const char*, kTruthLevels> kLevelNames{"organ", "shoot", "plant"};

bool has_ending(const std::string& path, std::string_view ending) { return lower_case(path).ends_with(ending); }

std::string depth_png(const PictureTruth& truth) {
  std::vector<std::uint16_t> grey;
  grey.reserve(truth.depth.size());
  for (const float depth : truth.depth) {
    const double millimetres = std::isfinite(depth) ? std::floor(1000.0 * depth + 0.5) : 0;
    grey.push_back(static_cast<std::uint16_t>(std::clamp(millimetres, 0.0, 65535.0)));
  }
  return encode_grey_png(truth.width, truth.height, grey);
}

/// Returns a portable float map: rows from the bottom, little-endian.
std::string pfm(const PictureTruth& truth, int channels, const float* numbers) {
  std::string bytes = fmt::format("{}\n{} {}\n-1.0\n", channels == 1 ? "Pf" : "PF", truth.width, truth.height);
  const std::size_t row = sizeof(float) * channels * truth.width;
  const auto* const begin = reinterpret_cast<const char*>(numbers);
  for (int y = truth.height; y-- > 0;) bytes.append(begin + row * y, row);
  return bytes;
}

Image normals_image(const PictureTruth& truth) {
  Image image{truth.width, truth.height, {}};
  image.rgba.reserve(4 * truth.normal.size());
  for (const Vec3 normal : truth.normal) {
    const bool is_sky = normal == Vec3(0);
    for (int c = 0; c < 3; ++c) {
      const float shown = is_sky ? 0 : std::floor(127.5F * (normal[c] + 1) + 0.5F);
      image.rgba.push_back(static_cast<std::uint8_t>(std::clamp(shown, 0.0F, 255.0F)));
    }
    image.rgba.push_back(255);
  }
  return image;
}

Image mask_image(const PictureTruth& truth, const TruthMask& mask) {
  Image image{truth.width, truth.height, {}};
  image.rgba.reserve(4 * mask.number.size());
  for (const std::uint32_t number : mask.number) {
    image.rgba.push_back(static_cast<std::uint8_t>(number & 255U));
    image.rgba.push_back(static_cast<std::uint8_t>(number >> 8U & 255U));
    image.rgba.push_back(static_cast<std::uint8_t>(number >> 16U & 255U));
    image.rgba.push_back(255);
  }
  return image;
}

/// The extent of an object in the picture.
struct Extent {
  int left = std::numeric_limits<int>::max();
  int top = std::numeric_limits<int>::max();
  int right = -1;
  int bottom = -1;
  std::size_t area = 0;
  std::vector<std::uint32_t> runs;  // alternating runs of other pixels and of its own, column by column
  std::uint32_t counted = 0;        // number of pixels in the runs so far
};

/// Returns the extents of all objects of a mask in one pass over it.
std::vector<Extent> extents_of(const TruthMask& mask, int width, int height) {
  std::vector<Extent> extents(mask.things.size() + 1);
  std::uint32_t place = 0;
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < height; ++y, ++place) {
      const std::uint32_t number = mask.number[std::size_t{1} * y * width + x];
      if (number == 0) continue;
      Extent& extent = extents[number];
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x);
      extent.top = std::min(extent.top, y);
      extent.bottom = std::max(extent.bottom, y);
      ++extent.area;
      if (!extent.runs.empty() && extent.counted == place) {
        ++extent.runs.back();
      } else {
        extent.runs.push_back(place - extent.counted);
        extent.runs.push_back(1);
      }
      extent.counted = place + 1;
    }
  }
  const auto all = static_cast<std::uint32_t>(std::size_t{1} * width * height);
  for (Extent& extent : extents) {
    if (extent.counted < all) extent.runs.push_back(all - extent.counted);
  }
  return extents;
}

std::string text_of_runs(const std::vector<std::uint32_t>& runs) {
  std::string text;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::int64_t rest = runs[k];
    if (k > 2) rest -= runs[k - 2];
    for (bool more = true; more;) {
      auto bits = static_cast<int>(rest & 31);
      rest >>= 5;
      more = (bits & 16) != 0 ? rest != -1 : rest != 0;
      if (more) bits |= 32;
      text += static_cast<char>(bits + 48);
    }
  }
  return text;
}

/// The category of an object: its level and its component.
using Category = std::pair<int, std::string>;

Category category_of(int level, const SeenThing& thing) { return {level, thing.component}; }

Value list_of(Vec3 v) { return Value::List{double{v.x}, double{v.y}, double{v.z}}; }

std::string coco(const PictureTruth& truth, const TruthContext& context) {
  const Camera& camera = truth.camera;
  // Categories are numbered by level and name, so that equal plants have equal numbers.
  std::map<Category, int> categories;
  for (int level = 0; level < kTruthLevels; ++level) {
    for (const SeenThing& thing : truth.masks[level].things) categories.emplace(category_of(level, thing), 0);
  }
  Value::List category_list;
  int id = 0;
  for (auto& [category, number] : categories) {
    number = ++id;
    category_list.emplace_back(
        Value::Object{{"id", number}, {"name", category.second}, {"supercategory", kLevelNames[category.first]}});
  }

  Value::List annotations;
  id = 0;
  for (int level = 0; level < kTruthLevels; ++level) {
    const TruthMask& mask = truth.masks[level];
    const std::vector<Extent> extents = extents_of(mask, truth.width, truth.height);
    for (std::size_t k = 0; k < mask.things.size(); ++k) {
      const SeenThing& thing = mask.things[k];
      const Extent& extent = extents[k + 1];
      Value::Object annotation{{"id", ++id},
                               {"image_id", 1},
                               {"category_id", categories.at(category_of(level, thing))},
                               {"bbox", Value::List{extent.left, extent.top, extent.right - extent.left + 1,
                                                    extent.bottom - extent.top + 1}},
                               {"area", static_cast<double>(extent.area)},
                               {"iscrowd", 0},
                               {"segmentation", Value::Object{{"size", Value::List{truth.height, truth.width}},
                                                              {"counts", text_of_runs(extent.runs)}}},
                               {"number", static_cast<double>(k + 1)}};
      if (level == 0) annotation.emplace_back("wood", !thing.is_organ);
      if (level == 0) annotation.emplace_back("shoot", static_cast<double>(thing.shoot));
      if (level < 2) annotation.emplace_back("plant", static_cast<double>(thing.plant));
      if (thing.order >= 0) annotation.emplace_back("order", thing.order);
      annotations.emplace_back(std::move(annotation));
    }
  }

  const double focal = 0.5 * truth.height / camera.half_height();
  const Value::Object image{{"id", 1},
                            {"file_name", context.picture},
                            {"width", truth.width},
                            {"height", truth.height},
                            {"camera", Value::Object{{"position", list_of(camera.position())},
                                                     {"right", list_of(camera.right())},
                                                     {"up", list_of(camera.up())},
                                                     {"forward", list_of(camera.forward())},
                                                     {"focal_length", focal},
                                                     {"centre", Value::List{0.5 * truth.width, 0.5 * truth.height}}}}};
  Value::Object info{{"description", context.name}, {"version", std::string(version())}};
  Value::Object whole{{"info", std::move(info)}, {"images", Value::List{image}}};
  Value::List licences;
  if (!context.licence.empty()) licences.emplace_back(Value::Object{{"id", 1}, {"name", context.licence}});
  whole.emplace_back("licenses", std::move(licences));
  whole.emplace_back("categories", std::move(category_list));
  whole.emplace_back("annotations", std::move(annotations));
  return write_json_line(Value(std::move(whole))) + "\n";
}

}  // namespace

std::span<const TruthFormat> truth_formats() { return kTruthFormats; }

const TruthFormat& truth_format(std::string_view name) {
  std::vector<std::string> names;
  for (const TruthFormat& format : kTruthFormats) {
    if (format.name == name) return format;
    names.emplace_back(format.name);
  }
  throw InputError(Diagnostic{.message = fmt::format("'{}' is no kind of file about a picture", name),
                              .expected = fmt::format("one of {}", fmt::join(names, ", ")),
                              .nearest = nearest_name(name, names)});
}

std::string TruthFormat::ending_list() const {
  return endings[1].empty() ? std::string(endings[0]) : fmt::format("{} or {}", endings[0], endings[1]);
}

void check_truth_file(const TruthFormat& format, const std::string& path) {
  for (const std::string_view ending : format.endings) {
    if (!ending.empty() && has_ending(path, ending)) return;
  }
  throw InputError(Diagnostic{.message = fmt::format("{} cannot be written to '{}'", format.name, path),
                              .expected = "a file that ends in " + format.ending_list()});
}

std::string encode_truth(const PictureTruth& truth, const TruthFormat& format, const std::string& path,
                         const TruthContext& context) {
  check_truth_file(format, path);
  const bool is_pfm = has_ending(path, ".pfm");
  if (format.name == "depth") return is_pfm ? pfm(truth, 1, truth.depth.data()) : depth_png(truth);
  if (format.name == "normals") {
    return is_pfm ? pfm(truth, 3, &truth.normal[0].x) : encode_png(normals_image(truth), PixelKind::numbers);
  }
  if (format.name == "coco") return coco(truth, context);
  for (int level = 0; level < kTruthLevels; ++level) {
    if (format.name.starts_with(kLevelNames[level])) {
      return encode_png(mask_image(truth, truth.masks[level]), PixelKind::numbers);
    }
  }
  return {};
}

void write_truths(const PictureTruth& truth, std::span<const TruthFile> files, const TruthContext& context) {
  for (const TruthFile& file : files) {
    write_whole_file(file.path, encode_truth(truth, *file.format, file.path, context));
  }
}

std::string coco_counts(const TruthMask& mask, int width, int height, std::uint32_t number) {
  return text_of_runs(extents_of(mask, width, height).at(number).runs);
}

}  // namespace meristem
