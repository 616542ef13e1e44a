// SPDX-License-Identifier: Apache-2.0
// Numbers count over documents, in each document over sets of values, and for each set over seeds. Seeds therefore
// change fastest; in a grid, the last path changes fastest, as in batches of Python. Random values of a plant depend on
// the document's name, the set of values and the seed. Further documents and seeds therefore leave all earlier plants
// unchanged.
#include "meristem/dataset/dataset_plan.h"

#include <algorithm>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/dataset/plan_parts.h"
#include "meristem/document/json.h"

namespace meristem {

namespace {

constexpr std::size_t kFewestDigits = 6;  // minimum number of digits of keys

}  // namespace

int PicturePlan::view_count() const { return std::max({1, drawn_views, static_cast<int>(fixed_views.size())}); }

std::uint64_t DatasetPlan::setting_count() const {
  if (!samples.empty()) return samples.size();
  std::uint64_t count = 1;
  for (const auto& [path, values] : grid) count *= values.size();
  return count;
}

std::uint64_t DatasetPlan::count() const { return documents.size() * setting_count() * seed_count; }

PlannedPlant DatasetPlan::plant(std::uint64_t number) const {
  if (number >= count()) throw std::invalid_argument("the plan has no plant of this number");
  PlannedPlant plant{.number = number};
  plant.key = fmt::format("{:0{}}", number, std::max(kFewestDigits, std::to_string(count() - 1).size()));
  const std::uint64_t place = number % seed_count;
  const std::uint64_t settings = setting_count();
  const std::uint64_t setting = number / seed_count % settings;
  plant.document = static_cast<std::size_t>(number / seed_count / settings);
  plant.seed = seeds.empty() ? first_seed + place : seeds[static_cast<std::size_t>(place)];
  const PlannedDocument& document = documents[plant.document];
  plant.random = RandomKey(seed).child("data set").child(document.name).child(setting).child(plant.seed);

  if (!samples.empty()) plant.values = samples[static_cast<std::size_t>(setting)];
  std::uint64_t rest = setting;
  for (std::size_t k = grid.size(); k-- > 0;) {
    const auto& [path, values] = grid[k];
    plant.values.insert(plant.values.begin(), {path, values[static_cast<std::size_t>(rest % values.size())]});
    rest /= values.size();
  }
  for (const auto& [path, variation] : document.vary) {
    plant.values.emplace_back(path, variation.draw(plant.random.child("values").child(path)));
  }
  return plant;
}

std::string hash_of_plan(const Value& tree) {
  // Names and descriptions of the plan may change, but plants and files must not.
  Value decisive = tree;
  if (Value::Object* object = decisive.object()) {
    std::erase_if(*object, [](const Value::Member& member) {
      return member.first == "name" || member.first == "description" || member.first == "author" ||
             member.first == "licence";
    });
  }
  const std::string text = write_json(decisive);
  return hash128_hex(std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace meristem
