// SPDX-License-Identifier: Apache-2.0
// Reads the seeds and the views of a plan. Seeds are a count, a list, or a first seed with a count. Views are fixed
// angles, or a number of random views.
#include "meristem/dataset/plan_parts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "meristem/base/seed.h"
#include "meristem/scene/view.h"

namespace meristem {

namespace {

bool is_whole(const Value& value, double low, double high) {
  const double* const number = value.number();
  return number != nullptr && *number >= low && *number <= high && *number == std::floor(*number);
}

void read_fixed_views(const Value::List& views, const DocumentPath& path, ParameterReader& reader,
                      PicturePlan& pictures) {
  for (std::size_t k = 0; k < views.size(); ++k) {
    const Value::List* const pair = views[k].list();
    const bool is_pair = pair != nullptr && pair->size() == 2 && (*pair)[0].number() != nullptr &&
                         (*pair)[1].number() != nullptr &&
                         seen_from(CameraView(), *(*pair)[0].number(), *(*pair)[1].number());
    if (is_pair) {
      pictures.fixed_views.emplace_back(*(*pair)[0].number(), *(*pair)[1].number());
    } else {
      reader.add_error(DocumentPath(path, k), fmt::format("a view cannot be {}", views[k].description()),
                       fmt::format("[azimuth, altitude]: {}", kKnownSides));
    }
  }
}

void read_row_of_seeds(const Value& given, const DocumentPath& path, const char* expected, ParameterReader& reader,
                       DatasetPlan& plan) {
  const std::vector<std::string> names{"first", "count"};
  for (const auto& [name, value] : *given.object()) {
    if (name == "first" || name == "count") continue;
    reader.add_name_error(DocumentPath(path, name), fmt::format("'{}' is not a part of the seeds", name), expected,
                          nearest_name(name, names));
  }
  const Value* const first = given.find("first");
  const Value* const count = given.find("count");
  if (count == nullptr) return reader.add_error(path, "the seeds have no count", expected);
  if (!is_whole(*count, 1, static_cast<double>(kMaxPlants))) {
    return reader.add_error(DocumentPath(path, "count"),
                            fmt::format("the count of seeds cannot be {}", count->description()),
                            fmt::format("a whole number from 1 to {}", kMaxPlants));
  }
  plan.seed_count = static_cast<std::uint64_t>(*count->number());
  if (first == nullptr) return;
  if (is_whole(*first, 0, static_cast<double>(kLargestSeed - plan.seed_count))) {
    plan.first_seed = static_cast<std::uint64_t>(*first->number());
  } else {
    reader.add_error(DocumentPath(path, "first"), fmt::format("the first seed cannot be {}", first->description()),
                     "a whole number from 0, so that the last is at most 9007199254740992");
  }
}

}  // namespace

void read_plan_views(const Value& given, const DocumentPath& path, ParameterReader& reader, PicturePlan& pictures) {
  if (pictures.colour == PicturePlan::Colour::jpg && pictures.transparent) {
    reader.add_error(DocumentPath(path, "colour"), "a JPEG cannot be transparent", "\"colour\": \"png\"");
  }
  const bool is_anything = pictures.colour != PicturePlan::Colour::none || pictures.depth != PicturePlan::Map::none ||
                           pictures.normals != PicturePlan::Map::none || pictures.organs || pictures.shoots ||
                           pictures.plants || pictures.coco;
  if (!is_anything)
    reader.add_error(path, "these pictures show nothing", "one of depth, normals, organs, shoots, plants or coco");
  const Value* const views = given.find("views");
  const DocumentPath views_path(path, "views");
  if (views != nullptr && views->list() != nullptr && !views->list()->empty()) {
    read_fixed_views(*views->list(), views_path, reader, pictures);
  } else if (views != nullptr) {
    if (is_whole(*views, 1, 10'000)) {
      pictures.drawn_views = static_cast<int>(*views->number());
    } else {
      reader.add_error(views_path, fmt::format("the views are {}", views->description()),
                       "a number of views from 1 to 10000, or a list of pairs [azimuth, altitude]");
    }
  }
  for (const auto& [name, variation] : {std::pair{"azimuth", &pictures.azimuth}, {"altitude", &pictures.altitude}}) {
    const Value* const angle = given.find(name);
    if (angle == nullptr) continue;
    const DocumentPath own(path, name);
    if (!pictures.fixed_views.empty()) {
      reader.add_name_error(own, fmt::format("'{}' has no effect beside a list of views", name),
                            "a number of views, or no angles", "");
      continue;
    }
    if (pictures.drawn_views == 0) pictures.drawn_views = 1;
    if (auto read = read_variation(*angle, own, reader)) {
      const double max = variation == &pictures.azimuth ? 360 : 89;
      read->low = std::max(read->low.value_or(-max), -max);
      read->high = std::min(read->high.value_or(max), max);
      if (!read->is_number() || read->share_within() < kMinShareWithin) {
        reader.add_error(own, fmt::format("this is hardly ever an {}", name), std::string(kKnownSides));
      }
      *variation = *read;
    }
  }
}

void read_plan_seeds(const Value& given, const DocumentPath& path, ParameterReader& reader, DatasetPlan& plan) {
  const char* const expected =
      "a number of seeds, a list of them, or an object such as {\"first\": 1, \"count\": 1000}";
  const auto largest = static_cast<double>(kLargestSeed);
  const auto max = static_cast<double>(kMaxPlants);
  if (is_whole(given, 1, max)) {
    plan.seed_count = static_cast<std::uint64_t>(*given.number());
  } else if (const Value::List* list = given.list(); list != nullptr && !list->empty()) {
    std::set<std::uint64_t> known;
    for (std::size_t k = 0; k < list->size(); ++k) {
      const DocumentPath own(path, k);
      if (!is_whole((*list)[k], 0, largest)) {
        reader.add_error(own, fmt::format("a seed cannot be {}", (*list)[k].description()), std::string(kSeedRange));
        continue;
      }
      plan.seeds.push_back(static_cast<std::uint64_t>(*(*list)[k].number()));
      if (!known.insert(plan.seeds.back()).second) {
        reader.add_error(own, fmt::format("the seed {} stands twice", plan.seeds.back()), "each seed once");
      }
    }
    plan.seed_count = plan.seeds.size();
  } else if (given.object() != nullptr) {
    read_row_of_seeds(given, path, expected, reader, plan);
  } else {
    reader.add_error(path, fmt::format("the seeds are {}", given.description()), expected);
  }
}

}  // namespace meristem
