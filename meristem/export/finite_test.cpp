// SPDX-License-Identifier: Apache-2.0
// Gives every format of the table in formats.cpp a plant with numbers that are not finite. Each format must refuse it
// and leave no file. New formats in the table are tested automatically.
#include "meristem/output/write/finite.h"

#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/export/formats.h"
#include "meristem/export/packet/packet_arrays.h"
#include "meristem/output/write/append_bytes.h"
#include "meristem/output/write/csv.h"
#include "meristem/plant/operation_record.h"
#include "tests/support/temporary_folder.h"

namespace meristem::finite_test {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

const Document& document() {
  static const Document tree = read_document(R"({"meristem": 1, "components": {
      "tree": {"type": "colonize", "crown": {"sphere": {"centre": [0, 2, 0], "radius": 1}}, "points": 50},
      "leaf": {"type": "leaf", "length": 0.1}},
      "links": [{"from": "tree", "to": "leaf", "kind": "branch", "count": 9}]})",
                                             "tree.json", builtin_components());
  return tree;
}

GrownDocument grown() {
  Progress progress;
  GrowthOptions options;
  options.up_to = GrownPart::textures;
  options.view.request = {TracePart::points};
  return grow_document(document(), progress, options);
}

Mesh& mesh_of(MeshInstances& part) {
  auto own = std::make_shared<Mesh>(*part.mesh);
  Mesh& mesh = *own;
  part.mesh = std::move(own);
  return mesh;
}

MeshInstances& part_of(GrownDocument& grown, const std::string& component) {
  for (MeshInstances& part : grown.meshes.meshes) {
    if (part.component == component) return part;
  }
  throw std::logic_error("no such component");
}

/// Adds a record of an operation, and the points of a plant that stands at infinity.
void spoil_records(GrownDocument& grown) {
  OperationRecord record;
  record.act = "cut";
  record.length = kInfinity;
  grown.plant.stems[0].skeleton.operations.add(record);
  Frame far;
  far.origin.x = kInfinity;
  auto traces = std::make_shared<GrowthTraces>(grown.traces);
  grown.traces.placed.push_back({"far", {far}, std::move(traces)});
}

/// Returns the error with which a format refuses a plant. The folder must be empty afterwards.
std::string refusal(const FileFormat& format, const GrownDocument& spoilt) {
  const TemporaryFolder folder;
  Progress progress;
  std::string refusal = "no error";
  try {
    format.write(document(), spoilt, (folder / ("oak" + std::string(format.ending))).string(), {}, progress);
  } catch (const InputError& error) {
    refusal = error.what();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << format.ending << " has left a file: " << refusal;
  return refusal;
}

TEST(Finite, EveryFormatRefusesNumbersThatAreNotFinite) {
  for (const FileFormat& format : formats()) {
    GrownDocument spoilt = grown();
    if (format.needs >= GrownPart::meshes) {
      mesh_of(part_of(spoilt, "leaf")).normals[0].y = kNan;
    } else {
      spoil_records(spoilt);
      spoilt.plant.stems[0].skeleton.radius[1] = kInfinity;
    }
    EXPECT_NE(refusal(format, spoilt).find("finite"), std::string::npos) << format.ending;
  }
}

TEST(Finite, TablesRefuseRecordsAndPointsThatAreNotFinite) {
  GrownDocument spoilt = grown();
  spoil_records(spoilt);
  for (const char* name : {"a.operations.csv", "a.points.csv"}) {
    EXPECT_NE(refusal(format_of(name), spoilt).find("would not be finite"), std::string::npos) << name;
  }
}

TEST(Finite, FaultsNameTheComponent) {
  const auto scene_error = [](const GrownDocument& spoilt) -> std::string {
    try {
      require_finite(spoilt.meshes);
      require_finite(spoilt.plant);
    } catch (const InputError& error) {
      return error.diagnostics()[0].message;
    }
    return "no fault";
  };
  EXPECT_EQ(scene_error(grown()), "no fault");
  GrownDocument spoilt = grown();
  mesh_of(part_of(spoilt, "leaf")).positions[0].x = kInfinity;
  EXPECT_EQ(scene_error(spoilt), "a position of the mesh of 'leaf' is not finite");
  spoilt = grown();
  part_of(spoilt, "leaf").frames[0].origin.z = kNan;
  EXPECT_EQ(scene_error(spoilt), "the place or size of an instance of 'leaf' is not finite");
  spoilt = grown();
  spoilt.plant.stems[0].skeleton.position[2].y = kNan;
  EXPECT_EQ(scene_error(spoilt), "the position of a node of 'tree' is not finite");
  spoilt = grown();
  spoilt.plant.organs[0].frame.axes[1].x = kInfinity;
  EXPECT_EQ(scene_error(spoilt), "the place or size of an organ of 'leaf' is not finite");
}

TEST(Finite, InstancesThatWouldBecomeInfiniteAreRefused) {
  GrownDocument spoilt = grown();
  MeshInstances& leaf = part_of(spoilt, "leaf");
  for (Vec3& position : mesh_of(leaf).positions) position *= 1e20F;
  leaf.frames[0].axes *= 1e20F;  // both are finite, but their product is not
  for (const FileFormat& format : formats()) {
    if (format.needs < GrownPart::meshes || format.is_whole) continue;
    EXPECT_NE(refusal(format, spoilt).find("an instance of 'leaf' is not finite"), std::string::npos) << format.ending;
  }
}

TEST(Finite, UnknownValuesOfColumnsAreNoFault) {
  GrownDocument plant = grown();
  Skeleton& skeleton = plant.plant.stems[0].skeleton;
  skeleton.extra["light"].assign(skeleton.node_count(), kNan);
  EXPECT_NO_THROW(require_finite(plant.plant));
  skeleton.extra["light"][0] = kInfinity;
  EXPECT_THROW(require_finite(plant.plant), InputError);
}

TEST(Finite, NumbersAreCheckedOnceMoreAsTheyAreWritten) {
  std::string out;
  for (const double number : {double{kNan}, double{kInfinity}, -double{kInfinity}}) {
    EXPECT_THROW(append_csv_number(number, out), InputError);
    EXPECT_THROW(append_bytes(out, number), InputError);
    EXPECT_THROW(append_bytes(out, static_cast<float>(number)), InputError);
    EXPECT_THROW(append_bytes(out, Vec3(0, 0, static_cast<float>(number))), InputError);
    EXPECT_THROW(append_bytes(out, std::array{0.0, number}), InputError);
    EXPECT_THROW(packed_vectors({Vec3(0, static_cast<float>(number), 0)}), InputError);
    EXPECT_THROW(wide_uvs({Vec2(static_cast<float>(number), 0)}), InputError);
  }
  EXPECT_TRUE(out.empty());
  append_csv_number(1.5, out);
  append_csv_number(7, out);
  EXPECT_EQ(out, "1.57");
}

}  // namespace meristem::finite_test
