// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/mesh/ply.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/check_mesh.h"
#include "tests/support/sample_plants.h"
#include "tests/support/sample_scenes.h"

namespace meristem::ply_test {

/// A PLY as an independent reader sees it: columns of numbers by element and property.
struct Ply {
  struct Property {
    std::string type;   // type of the values
    std::string count;  // type of the length, for lists
    std::string name;
  };
  struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
  };

  std::string bytes;
  std::vector<std::string> comments;
  std::vector<Element> elements;
  std::map<std::string, std::vector<double>> columns;  // "vertex.x"; lists one after another

  const Element& element(const std::string& name) const {
    for (const Element& element : elements) {
      if (element.name == name) return element;
    }
    throw std::out_of_range(name);
  }
  std::vector<std::string> property_names(const std::string& of) const {
    std::vector<std::string> names;
    for (const Property& property : element(of).properties) names.push_back(property.name);
    return names;
  }
  bool has_comment(const std::string& text) const {
    return std::find(comments.begin(), comments.end(), text) != comments.end();
  }
  Vec3 vector(const std::array<const char*, 3>& names, std::size_t row) const {
    Vec3 result;
    for (int c = 0; c < 3; ++c) result[c] = static_cast<float>(columns.at(std::string("vertex.") + names[c]).at(row));
    return result;
  }

  Mesh mesh() const {
    Mesh result;
    for (std::size_t v = 0; v < element("vertex").count; ++v) {
      result.positions.push_back(vector({"x", "y", "z"}, v));
      if (columns.count("vertex.nx") > 0) result.normals.push_back(vector({"nx", "ny", "nz"}, v));
      if (columns.count("vertex.s") > 0) {
        result.uvs.emplace_back(columns.at("vertex.s")[v], columns.at("vertex.t")[v]);
      }
    }
    const std::vector<double>& indices = columns.at("face.vertex_indices");
    for (std::size_t k = 0; k < indices.size(); k += 3) {
      const auto index = [&](std::size_t corner) { return static_cast<std::uint32_t>(indices[k + corner]); };
      result.triangles.push_back({index(0), index(1), index(2)});
    }
    return result;
  }
};

template <class Value>
double take(const std::string& bytes, std::size_t& at) {
  Value value;
  std::memcpy(&value, bytes.substr(at, sizeof(Value)).data(), sizeof(Value));
  at += sizeof(Value);
  return static_cast<double>(value);
}

double take(const std::string& type, const std::string& bytes, std::size_t& at) {
  if (at >= bytes.size()) throw std::out_of_range("the file ends early");
  if (type == "float") return take<float>(bytes, at);
  if (type == "int") return take<std::int32_t>(bytes, at);
  if (type == "uchar") return take<std::uint8_t>(bytes, at);
  throw std::out_of_range("a property of type " + type);
}

std::size_t parse_header(Ply& ply) {
  const std::string end = "end_header\n";
  const std::size_t header_bytes = ply.bytes.find(end) + end.size();
  std::istringstream lines(ply.bytes.substr(0, header_bytes));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "ply");
  std::getline(lines, line);
  EXPECT_EQ(line, "format binary_little_endian 1.0");
  while (std::getline(lines, line)) {
    EXPECT_LT(line.size(), 1000U);
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "comment") ply.comments.push_back(line.substr(8));
    if (key == "element") {
      Ply::Element& element = ply.elements.emplace_back();
      words >> element.name >> element.count;
    }
    if (key != "property") continue;
    Ply::Property property;
    words >> property.type;
    if (property.type == "list") words >> property.count >> property.type;
    words >> property.name;
    ply.elements.back().properties.push_back(property);
  }
  return header_bytes;
}

Ply parse(const std::string& path) {
  Ply ply;
  std::ifstream in(path, std::ios::binary);
  ply.bytes.assign(std::istreambuf_iterator<char>(in), {});
  std::size_t at = parse_header(ply);
  for (const Ply::Element& element : ply.elements) {
    for (const Ply::Property& property : element.properties) ply.columns[element.name + "." + property.name];
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const Ply::Property& property : element.properties) {
        const double count = property.count.empty() ? 1 : take(property.count, ply.bytes, at);
        std::vector<double>& column = ply.columns[element.name + "." + property.name];
        for (int k = 0; k < count; ++k) column.push_back(take(property.type, ply.bytes, at));
      }
    }
  }
  EXPECT_EQ(at, ply.bytes.size());
  return ply;
}

std::string temporary_path() {
  return testing::TempDir() + "ply_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".ply";
}

Ply written(const MeshScene& scene, const PlyOptions& options = {}) {
  Progress progress;
  write_mesh_ply(scene, temporary_path(), options, progress);
  Ply ply = parse(temporary_path());
  std::filesystem::remove(temporary_path());
  return ply;
}

Ply written(const Plant& plant) {
  Progress progress;
  write_skeleton_ply(plant, {}, temporary_path(), {}, progress);
  Ply ply = parse(temporary_path());
  std::filesystem::remove(temporary_path());
  return ply;
}

TEST(MeshPly, HoldsEveryInstanceToTheLastBit) {
  const MeshScene scene = leafy_scene(1000);
  const Mesh mesh = written(scene).mesh();
  const Mesh expected = flattened(scene);
  EXPECT_EQ(mesh.positions, expected.positions);
  EXPECT_EQ(mesh.normals, expected.normals);
  EXPECT_EQ(mesh.uvs, expected.uvs);
  EXPECT_EQ(mesh.triangles, expected.triangles);
}

TEST(MeshPly, ClosedBodiesKeepAreaAndVolumeHoweverTheyAreMirrored) {
  const MeshScene scene = scene_of(std::make_shared<const Mesh>(make_cylinder(0.1, 2, 12)), {Frame(), mirror()});
  const Mesh mesh = written(scene).mesh();
  EXPECT_NEAR(signed_volume(mesh), 2 * signed_volume(*scene.meshes[0].mesh), 1e-9);
  EXPECT_NEAR(surface_area(mesh), 2 * surface_area(*scene.meshes[0].mesh), 1e-6);
  EXPECT_TRUE(check_mesh(written(scene_of(scene.meshes[0].mesh, {mirror()})).mesh()));
}

TEST(MeshPly, VerticesHaveTheColourOfTheirMaterialAndTheirComponent) {
  MeshScene scene = leafy_scene(2);
  scene.materials[0].colour = {1, 0.5F, 0};
  scene.meshes[1].component = "two\nlines";
  const Ply ply = written(scene);
  EXPECT_EQ(ply.property_names("vertex"),
            (std::vector<std::string>{"x", "y", "z", "nx", "ny", "nz", "s", "t", "red", "green", "blue", "component"}));
  EXPECT_TRUE(ply.has_comment("component 0 leaf"));
  EXPECT_TRUE(ply.has_comment("component 1 two lines"));
  EXPECT_EQ(ply.columns.at("vertex.red")[5], 255);
  EXPECT_EQ(ply.columns.at("vertex.green")[5], 128);
  EXPECT_EQ(ply.columns.at("vertex.blue")[5], 0);
  EXPECT_EQ(ply.columns.at("vertex.component")[5], 0);
  EXPECT_EQ(ply.columns.at("vertex.red")[6], 102);
  EXPECT_EQ(ply.columns.at("vertex.component")[6], 1);
}

TEST(MeshPly, VerticesHaveTheTintOfTheirInstance) {
  MeshScene scene = scene_of(triangle(), {Frame(), Frame()});
  scene.materials[0].colour = {0.8F, 0.5F, 0.25F};
  scene.meshes[0].tints = {{0.5F, 1, 3}, Vec3(1)};
  const Ply ply = written(scene);
  const Vec3 tinted = srgb_from_linear(linear_from_srgb(scene.materials[0].colour) * scene.meshes[0].tints[0]);
  const Vec3 expected[] = {tinted, scene.materials[0].colour};
  const char* const names[] = {"vertex.red", "vertex.green", "vertex.blue"};
  for (std::size_t v = 0; v < 6; ++v) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ply.columns.at(names[c])[v], 255 * expected[v / 3][c], 0.51) << v;
  }
}

TEST(MeshPly, LeavesOutWhatNoMeshHas) {
  const Ply ply = written(scene_of(strip(3), {Frame()}));
  EXPECT_EQ(ply.property_names("vertex"),
            (std::vector<std::string>{"x", "y", "z", "red", "green", "blue", "component"}));
  EXPECT_EQ(ply.mesh().positions, strip(3)->positions);
}

TEST(MeshPly, SaysWhereThePlantCameFromAndItsUnits) {
  const std::string long_name(5000, 'x');
  const Ply ply = written(leafy_scene(1), {{long_name, "A. Author", "CC0-1.0", 7, "1.2.3"}});
  EXPECT_TRUE(ply.has_comment("Meristem 1.2.3"));
  EXPECT_TRUE(ply.has_comment("seed: 7"));
  EXPECT_TRUE(ply.has_comment("units: metres, y up"));
}

TEST(MeshPly, AnEmptySceneHasNoVerticesAndNoFaces) {
  const Ply ply = written(MeshScene{});
  EXPECT_EQ(ply.element("vertex").count, 0U);
  EXPECT_EQ(ply.element("face").count, 0U);
}

TEST(MeshPly, HasTheSameBytesOnAnyNumberOfThreads) {
  const MeshScene scene = leafy_scene(20'000);
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    return written(scene).bytes;
  };
  const std::string expected = bytes(1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(bytes(threads) == expected) << threads << " threads";
}

TEST(MeshPly, RefusesMoreVerticesThanItCounts) {
  Progress progress;
  const MeshScene scene = scene_of(strip(100'000), std::vector<Frame>(30'000));
  EXPECT_THROW(write_mesh_ply(scene, temporary_path(), {}, progress), InputError);
  EXPECT_FALSE(std::filesystem::exists(temporary_path()));
}

TEST(MeshPly, ReportsAFullDiskAndARefusedPath) {
  Progress progress;
  EXPECT_THROW(write_mesh_ply(leafy_scene(10), "/dev/full", {}, progress), MachineError);
  EXPECT_THROW(write_mesh_ply(leafy_scene(10), "/nonexistent/plant.ply", {}, progress), MachineError);
}

TEST(MeshPly, LeavesNothingWhenCancelled) {
  const std::string folder = testing::TempDir() + "ply_cancelled/";
  std::filesystem::create_directory(folder);
  Progress* self = nullptr;
  Progress progress([&](std::string_view, double fraction) {
    if (fraction > 0.5) self->cancel();
  });
  self = &progress;
  EXPECT_THROW(write_mesh_ply(leafy_scene(200'000), folder + "plant.ply", {}, progress), Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove(folder);
}

TEST(SkeletonPly, HasAVertexANodeWithItsColumns) {
  const Ply ply = written(two_stems());
  EXPECT_EQ(ply.property_names("vertex"), (std::vector<std::string>{"x", "y", "z", "radius", "parent", "axis", "order",
                                                                    "birth", "component", "instance", "light"}));
  EXPECT_EQ(ply.columns.at("vertex.x"), (std::vector<double>{0, 0, 0, 0.5, 3, 3, 3}));
  EXPECT_EQ(ply.columns.at("vertex.y")[5], 0.1F);
  EXPECT_EQ(ply.columns.at("vertex.radius")[6], 1e-7F);
  EXPECT_EQ(ply.columns.at("vertex.parent"), (std::vector<double>{-1, 0, 1, 1, -1, 4, 5}));
  EXPECT_EQ(ply.columns.at("vertex.axis"), (std::vector<double>{0, 0, 0, 1, 2, 2, 2}));
  EXPECT_EQ(ply.columns.at("vertex.order"), (std::vector<double>{0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(ply.columns.at("vertex.birth"), (std::vector<double>{0, 1, 2, 2, 0, 1, 2.5}));
  EXPECT_EQ(ply.columns.at("vertex.component"), (std::vector<double>{0, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(ply.columns.at("vertex.instance"), (std::vector<double>{0, 0, 0, 0, 3, 3, 3}));
  EXPECT_EQ(ply.columns.at("vertex.light")[3], 0.3F);
  EXPECT_TRUE(std::isnan(ply.columns.at("vertex.light")[4]));
  EXPECT_TRUE(ply.has_comment("component 1 vine"));
}

TEST(SkeletonPly, HasAnEdgeFromEveryParentToItsChild) {
  const Ply ply = written(two_stems());
  EXPECT_EQ(ply.columns.at("edge.vertex1"), (std::vector<double>{0, 1, 1, 4, 5}));
  EXPECT_EQ(ply.columns.at("edge.vertex2"), (std::vector<double>{1, 2, 3, 5, 6}));
}

TEST(SkeletonPly, LeavesLabelsOutWhichAreTexts) {
  Plant plant = two_stems();
  plant.stems[0].skeleton.extra["metamer"] = {0, 1, 2, 1};
  const Ply ply = written(plant);
  EXPECT_EQ(ply.columns.at("vertex.metamer")[3], 1);
  EXPECT_FALSE(ply.columns.contains("vertex.label"));
}

TEST(SkeletonPly, NamesOfColumnsStayWords) {
  Plant plant = two_stems();
  plant.stems[0].skeleton.extra = {{"red light", {1, 2, 3, 4}}};
  EXPECT_EQ(written(plant).columns.at("vertex.red_light")[3], 4);
}

TEST(SkeletonPly, APlantWithoutStemsHasNoVerticesAndNoEdges) {
  const Ply ply = written(Plant{});
  EXPECT_EQ(ply.element("vertex").count, 0U);
  EXPECT_EQ(ply.element("edge").count, 0U);
}

TEST(SkeletonPly, HasTheSameBytesOnAnyNumberOfThreads) {
  const Plant plant = long_stem(50'000);
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    return written(plant).bytes;
  };
  const std::string expected = bytes(1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(bytes(threads) == expected) << threads << " threads";
}

TEST(SkeletonPly, ReportsAFullDiskAndARefusedPath) {
  Progress progress;
  EXPECT_THROW(write_skeleton_ply(two_stems(), {}, "/dev/full", {}, progress), MachineError);
  EXPECT_THROW(write_skeleton_ply(two_stems(), {}, "/nonexistent/plant.ply", {}, progress), MachineError);
}

}  // namespace meristem::ply_test
