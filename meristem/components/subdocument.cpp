// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/subdocument.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/seed.h"

namespace meristem {

namespace {

const ParameterTable& set_table() {
  static const ParameterTable table =
      Table<SetNumber>("a set value", "A number that is set in another document.")
          .number("value", &SetNumber::value, {},
                  "Value of the variable or parameter, in the unit that it has in the other document.")
          .required()
          .shorthand("value");
  return table;
}

/// Opens the document and resolves the names in `set`.
void open(Subdocument& document, const DocumentPath& path, ParameterReader& reader) {
  document.source = reader.files().plant_source(document.file, DocumentPath(path, "file"));
  if (document.source == nullptr) return;
  const DocumentPath set(path, "set");
  for (auto& [name, set_value] : document.set) {
    const PlantSource::Handle handle = document.source->handle(name);
    const DocumentPath own(set, name);
    if (!handle.is_known) {
      reader.add_name_error(own, fmt::format("'{}' has no variable or parameter '{}'", document.source->file(), name),
                            handle.nearest.empty() ? "a variable of that document, or a path such as leaf.length" : "",
                            handle.nearest);
      continue;
    }
    set_value.min = handle.min;
    set_value.max = handle.max;
    const bool is_beyond = set_value.value < handle.min || handle.max < set_value.value;
    if (!is_beyond || reader.numbers().is_worked_out(own) || reader.numbers().is_worked_out(DocumentPath(own, "value")))
      continue;
    reader.add_error(own, fmt::format("{} = {:.12g} lies beyond the variable's own range", name, set_value.value),
                     fmt::format("{:.12g} to {:.12g}", handle.min, handle.max));
  }
}

std::uint64_t seed_of(const Subdocument& document, const Site& site) {
  if (document.seed) return static_cast<std::uint64_t>(std::floor(*document.seed + 0.5));
  const RandomKey key = site.key.child("seed");
  if (!document.variants) return key.bits() % kLargestSeed;
  const auto drawn = static_cast<std::uint64_t>(key.uniform(0) * *document.variants);
  return 1 + std::min(drawn, static_cast<std::uint64_t>(*document.variants - 1));
}

void expand(const Subdocument& document, const Site& site, OrganSink& organs) {
  PlantRequest request{.seed = seed_of(document, site)};
  for (const auto& [name, set] : document.set) {
    request.values.emplace_back(name, std::clamp(set.value, set.min, set.max));
  }
  organs.add_plant(Frame{}, document.source, std::move(request));
}

}  // namespace

ComponentType subdocument_component() {
  return define_component<Subdocument>({
      .traits = {.name = "document",
                 .doc = "A whole plant of another document, which stands upright where the component stands.",
                 .is_whole_plant = true,
                 .tropism = Tropism::none},
      .parameters =
          Table<Subdocument>("a placed document", "A whole plant of another document.")
              .text("file", &Subdocument::file,
                    "Name of a shipped model, or path of a document from this document's folder.")
              .required()
              .map("set", &Subdocument::set, set_table,
                   "Values of the other document's variables by name, or of its parameters by path ('leaf.length').")
              .number("seed", &Subdocument::seed, {.min = 0, .max = static_cast<double>(kLargestSeed)},
                      "Seed of the plant; by default, each instance has its own.")
              .integer(
                  "variants", &Subdocument::variants, {.min = 1, .max = 1e6, .usual = {1, 20}, .fixed = true},
                  "Number of seeds that the instances draw from; raised, more different plants and a longer growth.")
              .never_with("seed", {"variants"})
              .prepare(open),
      .expand = expand,
      .minimum_counts =
          [](const Subdocument& document, const KnownMembers& known) {
            const bool has_own_seeds =
                !document.seed && !document.variants && !known.varies(member_of(document, &Subdocument::seed));
            const bool is_placed =
                known.varies(member_of(document, &ComponentBase::place)) || document.place.scale != Vec3(1);
            return MinimumCounts{.grows_other = has_own_seeds && !is_placed};
          },
  });
}

}  // namespace meristem
