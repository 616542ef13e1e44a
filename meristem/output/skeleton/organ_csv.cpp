// SPDX-License-Identifier: Apache-2.0
// Writes organs with the light on them as rows of CSV. The numbers of organs within their component are found in one
// pass.
#include "meristem/output/skeleton/organ_csv.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "meristem/base/atomic_file.h"
#include "meristem/measure/measures.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/csv.h"
#include "meristem/output/write/finite.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

constexpr std::string_view kHeader = "component,instance,tree,x,y,z,area,exposure,irradiance\n";
constexpr std::size_t kNumbers = 8;  // numbers in a row

void append_row(const std::string& component, std::uint32_t instance, std::uint32_t tree, Vec3 position,
                const LitOrgan& lit, std::string& out) {
  out += component;
  out += ',';
  append_csv_number(instance, out);
  out += ',';
  if (tree != kNoTree) append_csv_number(tree, out);
  for (const double value :
       {double{position.x}, double{position.y}, double{position.z}, lit.area, lit.exposure, lit.irradiance}) {
    out += ',';
    append_csv_number(static_cast<float>(value), out);
  }
  out += '\n';
}

}  // namespace

std::vector<std::uint32_t> organ_instances(const Plant& plant) {
  std::map<std::string_view, std::uint32_t> of_component;
  std::vector<std::uint32_t*> next;  // for each prototype
  for (const OrganPrototype& prototype : plant.prototypes) next.push_back(&of_component[prototype.component]);
  std::vector<std::uint32_t> numbers;
  numbers.reserve(plant.organs.size());
  for (const Organ& organ : plant.organs) numbers.push_back((*next[organ.prototype])++);
  return numbers;
}

void write_organ_csv(const Plant& grown, const SizeLimits& limits, std::span<const LitOrgan> lit,
                     const std::string& path, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  require_finite(*expanded);
  const Plant& plant = *expanded;
  if (lit.size() != plant.organs.size()) throw std::invalid_argument("there must be one light per organ");
  std::vector<std::string> components;  // for each prototype, as CSV fields
  std::size_t longest = 0;
  for (const OrganPrototype& prototype : plant.prototypes) {
    components.push_back(csv_field(prototype.component));
    longest = std::max(longest, components.back().size());
  }
  const std::vector<std::uint32_t> numbers = organ_instances(plant);
  const std::vector<std::uint32_t> trees = trees_of_organs(plant, limits, progress);
  progress.begin("writing CSV", lit.size());
  AtomicFile file(path);
  file.write(kHeader);
  const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
    for (std::size_t k = begin; k < end; ++k) {
      const Organ& organ = plant.organs[k];
      append_row(components[organ.prototype], numbers[k], trees[k], organ.frame.origin, lit[k], out);
    }
  };
  BlockWriter(file, progress).write(lit.size(), longest + kNumbers * kCsvNumberBytes + 1, fill);
  file.commit();
}

}  // namespace meristem
