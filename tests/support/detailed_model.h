// SPDX-License-Identifier: Apache-2.0
// A shipped model with its levels of detail. Sources that include it must define MERISTEM_SOURCE_DIR, the folder of the
// project.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/document/models.h"
#include "meristem/export/detail_levels.h"

namespace meristem {

struct DetailedModel {
  Document document;
  GrownDocument grown;

  explicit DetailedModel(const std::string& name) : document(read(name)) {
    Progress progress;
    grown = grow_document(document, progress, {.up_to = GrownPart::meshes});
  }

  MeshScene level(int number) const {
    Progress progress;
    return mesh_detail(document, grown.plant, {.level = number}, progress);
  }

  /// Returns the reason why a level after one with `before` triangles is not worth a file.
  std::string error_of(std::uint64_t before, const MeshScene& scene, int number) const {
    Progress progress;
    return error_of_level(grown.meshes, before, scene, number, progress);
  }

 private:
  static Document read(const std::string& name) {
    const std::string file = model_path(std::string(MERISTEM_SOURCE_DIR) + "/models", name);
    return read_document(read_text_file(file), file, builtin_components());
  }
};

struct MadeLevels {
  std::vector<std::uint64_t> triangles;  // number of triangles of the levels that were made, from level 1 on
  std::optional<WorthlessLevel> worthless;
};

inline MadeLevels made_levels(const DetailedModel& model, int count) {
  MadeLevels made;
  Progress progress;
  const auto take = [&made](int number, const MeshScene& level) {
    made.triangles.push_back(level.triangle_count());
    EXPECT_EQ(made.triangles.size(), static_cast<std::size_t>(number));
  };
  made.worthless = make_levels(model.document, model.grown.plant, model.grown.meshes, count, take, progress);
  return made;
}

}  // namespace meristem
