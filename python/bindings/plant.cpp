// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "errors.h"
#include "meristem/components/camera.h"
#include "meristem/export/detail_levels.h"
#include "meristem/export/formats.h"
#include "meristem/export/output_files.h"
#include "meristem/export/packet/scene_packet.h"
#include "meristem/export/picture/picture.h"
#include "meristem/measure/counts.h"
#include "meristem/measure/foliage.h"
#include "meristem/measure/measures.h"
#include "meristem/output/picture/cards.h"
#include "meristem/output/skeleton/operation_csv.h"
#include "meristem/output/skeleton/organ_csv.h"
#include "meristem/output/skeleton/skeleton_table.h"
#include "meristem/output/write/names.h"
#include "meristem/output/write/picture_file.h"
#include "meristem/output/write/png.h"
#include "meristem/plant/plant_variant.h"
#include "values.h"

namespace meristem::python {

namespace {

using PlantPointer = std::shared_ptr<PlantInPython>;

constexpr std::uint64_t kMaxRays = 1'000'000'000;  // for a crown: some minutes

/// A part of a plant, which keeps the whole plant alive.
template <class Part>
std::shared_ptr<Part> part_of(const PlantPointer& plant, const Part& part) {
  return std::shared_ptr<Part>(plant, const_cast<Part*>(&part));
}

template <class Part>
py::list parts_of(const PlantPointer& plant, const std::vector<Part>& parts) {
  py::list list;
  for (const Part& part : parts) list.append(part_of(plant, part));
  return list;
}

/// Returns the growth, completed up to a part. This may take long.
const GrownDocument& up_to(const PlantPointer& plant, GrownPart part) {
  return *run_call(py::none(), 0, [&](Progress& inner) { return &plant->up_to(part, inner); });
}

const MeshScene& meshes_of(const PlantPointer& plant) { return up_to(plant, GrownPart::meshes).meshes; }

/// Returns the organs as columns.
struct Organs {
  PlantPointer plant;

  const std::vector<Organ>& rows() const { return plant->plant().organs; }

  py::object position() const {
    static const Organ kNone;
    const Organ* const first = rows().empty() ? &kNone : rows().data();
    return view(plant, &first->frame.origin.x, {static_cast<py::ssize_t>(rows().size()), 3},
                {sizeof(Organ), sizeof(float)});
  }

  template <class T, class Member>
  py::object column(Member Organ::*member, std::vector<py::ssize_t> inner) const {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows().size())};
    std::vector<py::ssize_t> strides{sizeof(Organ)};
    for (const py::ssize_t count : inner) {
      shape.push_back(count);
      strides.push_back(sizeof(T));
    }
    static const Organ kNone;
    const Organ* const first = rows().empty() ? &kNone : rows().data();
    return view(plant, reinterpret_cast<const T*>(&(first->*member)), std::move(shape), std::move(strides));
  }
};

/// Returns the ids of the organs' components, as fixed-width texts.
py::object components_of_organs(const PlantPointer& plant) {
  py::list names;
  for (const OrganPrototype& prototype : plant->plant().prototypes) names.append(prototype.component);
  const py::object array = py::module_::import("numpy").attr("array")(names, "str");
  std::vector<std::int64_t> numbers;
  for (const Organ& organ : plant->plant().organs) numbers.push_back(organ.prototype);
  return array.attr("take")(array_of(std::move(numbers)));
}

const SizeLimits& limits_of(const PlantPointer& plant) { return plant->origin->document.graph.limits; }

/// Returns the numbers of the organs' trees, -1 for organs that belong to no single tree.
py::object trees_in_python(const PlantPointer& plant) {
  std::vector<std::int64_t> trees;
  for (const std::uint32_t tree : trees_of_organs(plant->plant(), limits_of(plant), Progress())) {
    trees.push_back(tree == kNoTree ? -1 : static_cast<std::int64_t>(tree));
  }
  return array_of(std::move(trees));
}

const Scene& measured_scene(const PlantPointer& plant, const std::shared_ptr<Scene>& other) {
  return other != nullptr ? *other : plant->origin->document.scene;
}

py::dict organ_light(const PlantPointer& plant, const std::shared_ptr<Scene>& scene, int threads,
                     const py::object& progress) {
  std::vector<LitOrgan> organs = run_call(progress, threads, [&](Progress& inner) {
    const std::shared_ptr<const MeshScene> meshes = plant->ray_meshes(inner);
    return measure_organ_light(plant->with_holes(inner), limits_of(plant), *meshes, measured_scene(plant, scene),
                               inner);
  });
  const auto owner = std::make_shared<const std::vector<LitOrgan>>(std::move(organs));
  const auto column = [&](double LitOrgan::*member) -> py::object {
    static const LitOrgan kNone;
    const LitOrgan* const first = owner->empty() ? &kNone : owner->data();
    return view(owner, &(first->*member), {static_cast<py::ssize_t>(owner->size())}, {sizeof(LitOrgan)});
  };
  const Organs organs_of_plant{plant};
  py::dict columns;
  columns["component"] = components_of_organs(plant);
  columns["instance"] = array_of(organ_instances(plant->plant()));
  columns["tree"] = trees_in_python(plant);
  columns["position"] = organs_of_plant.position();
  columns["area"] = column(&LitOrgan::area);
  columns["exposure"] = column(&LitOrgan::exposure);
  columns["irradiance"] = column(&LitOrgan::irradiance);
  return columns;
}

/// Returns the records of operations as columns.
py::dict operations_of(const PlantPointer& plant) {
  const std::vector<OperationRecord> records = operation_records(plant->plant());
  py::dict columns;
  const auto texts = [&](const char* name, std::string OperationRecord::*member) {
    py::list list;
    for (const OperationRecord& record : records) list.append(record.*member);
    columns[name] = py::module_::import("numpy").attr("array")(list, "str");
  };
  const auto numbers = [&]<class T>(const char* name, T OperationRecord::*member) {
    std::vector<T> column;
    for (const OperationRecord& record : records) column.push_back(record.*member);
    columns[name] = array_of(std::move(column));
  };
  const auto vectors = [&](const char* name, Vec3 OperationRecord::*member) {
    std::vector<float> column;
    for (const OperationRecord& record : records) {
      for (int k = 0; k < 3; ++k) column.push_back((record.*member)[k]);
    }
    columns[name] = array_of(std::move(column)).attr("reshape")(-1, 3);
  };
  texts("operation", &OperationRecord::operation);
  texts("act", &OperationRecord::act);
  numbers("iteration", &OperationRecord::iteration);
  numbers("tree", &OperationRecord::tree);
  texts("shoot", &OperationRecord::shoot);
  numbers("rank", &OperationRecord::rank);
  numbers("metamer", &OperationRecord::metamer);
  vectors("position", &OperationRecord::position);
  vectors("bud", &OperationRecord::bud);
  vectors("bud_position", &OperationRecord::bud_position);
  numbers("diameter", &OperationRecord::diameter);
  numbers("metamers", &OperationRecord::metamers);
  numbers("length", &OperationRecord::length);
  numbers("wood", &OperationRecord::wood);
  numbers("light", &OperationRecord::light);
  return columns;
}

void check_options(double fork_diameter, std::uint64_t crown_rays) {
  if (!(fork_diameter >= 0)) throw py::value_error("fork_diameter must be at least 0 metres");
  if (crown_rays < 1 || crown_rays > kMaxRays) {
    throw py::value_error(fmt::format("crown_rays is {}; expected 1 to {}", crown_rays, kMaxRays));
  }
}

py::dict measures_in_python(const Measures& measures, std::span<const MeasureRow> rows) {
  py::dict values;
  for (const MeasureRow& row : rows) values[py::str(row.name.data(), row.name.size())] = row.value(measures);
  return values;
}

py::dict origin_in_python(const TreeOrigin& origin) {
  const bool is_known = !origin.component.empty();
  py::dict values;
  values["component"] = is_known ? py::object(py::str(origin.component)) : py::none();
  values["instance"] = is_known ? py::object(py::int_(origin.instance)) : py::none();
  values["row"] = origin.row != kNoRow ? py::object(py::int_(origin.row)) : py::none();
  values["position"] = array_of(std::vector<float>{origin.position.x, origin.position.y, origin.position.z});
  return values;
}

py::dict measures_in_python(const StandMeasures& measures, bool each) {
  py::dict values = measures_in_python(measures.whole, measure_rows());
  if (each) {
    py::list trees;
    for (std::size_t k = 0; k < measures.trees.size(); ++k) {
      py::dict tree = origin_in_python(measures.origins.at(k));
      tree.attr("update")(measures_in_python(measures.trees[k], tree_measure_rows()));
      trees.append(tree);
    }
    values["each"] = trees;
  }
  return values;
}

py::object measures_of(const PlantPointer& plant, bool light, bool each, const std::shared_ptr<Scene>& scene,
                       double fork_diameter, std::uint64_t crown_rays, int threads, const py::object& progress) {
  check_options(fork_diameter, crown_rays);
  const MeasureOptions options{.fork_diameter = fork_diameter, .crown_rays = crown_rays, .organ_light = light};
  const StandMeasures measures = run_call(progress, threads, [&](Progress& inner) {
    const Plant& grown = plant->with_holes(inner);
    StandMeasures stand;
    if (light) {
      const std::shared_ptr<const MeshScene> meshes = plant->ray_meshes(inner);
      stand = measure_plant(grown, limits_of(plant), *meshes, measured_scene(plant, scene), options, inner);
    } else {
      stand = measure_plant(grown, limits_of(plant), measured_scene(plant, scene), options, inner);
    }
    const MeshScene* const present = plant->present_meshes();
    stand.whole.set_geometry(present != nullptr ? count_geometry(*present)
                                                : count_geometry(plant->origin->document, grown, inner));
    return stand;
  });
  return measures_in_python(measures, each);
}

py::dict leaf_layers(const PlantPointer& plant, double height, int threads, const py::object& progress) {
  if (!(height > 0)) throw py::value_error("height must be above 0 metres");
  const LeafLayers layers = run_call(progress, threads, [&](Progress& inner) {
    return measure_leaf_layers(plant->with_holes(inner), limits_of(plant), height, inner);
  });
  std::vector<double> low;
  std::vector<double> high;
  for (std::size_t k = 0; k < layers.area.size(); ++k) {
    low.push_back(layers.low(k));
    high.push_back(layers.high(k));
  }
  py::dict columns;
  columns["low"] = array_of(std::move(low));
  columns["high"] = array_of(std::move(high));
  columns["leaf_area"] = array_of(layers.area);
  return columns;
}

py::object measures_of_skeleton(const std::shared_ptr<Skeleton>& skeleton, const std::shared_ptr<Scene>& scene,
                                bool each, double fork_diameter, std::uint64_t crown_rays, int threads,
                                const py::object& progress) {
  check_options(fork_diameter, crown_rays);
  const MeasureOptions options{.fork_diameter = fork_diameter, .crown_rays = crown_rays};
  const StandMeasures measures = run_call(progress, threads, [&](Progress& inner) {
    const Skeleton* const one = skeleton.get();
    return measure_skeletons(std::span(&one, 1), scene.get(), options, inner);
  });
  return measures_in_python(measures, each);
}

py::dict table_of(const PlantInPython& plant) {
  const SkeletonTable table(plant.plant());
  py::dict columns;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    const SkeletonColumn& column = table.columns()[c];
    std::vector<double> values;
    values.reserve(table.row_count());
    table.for_each_row(0, table.row_count(), [&](const SkeletonRow& row) { values.push_back(table.value(row, c)); });
    py::object array = array_of(std::move(values));
    const bool is_component = column.kind == SkeletonColumn::Kind::component;
    if (is_component || column.kind == SkeletonColumn::Kind::label) {
      // As fixed-width texts, so that comparing them needs no table.
      const std::vector<std::string>& texts = is_component ? table.components() : table.labels();
      const py::object names = py::module_::import("numpy").attr("array")(texts);
      array = names.attr("take")(array.attr("astype")("int64"));
    } else if (column.kind == SkeletonColumn::Kind::index) {
      array = array.attr("astype")("int64");
    }
    columns[py::str(column.name)] = array;
  }
  return columns;
}

void save(const PlantPointer& plant, const py::object& path, bool instanced, bool nodes, int lod, int cards,
          int threads, const py::object& progress) {
  const std::string target = file_of(path);
  const FileFormat& format = format_of(target);
  if ((instanced || nodes) && !format.can_instance) throw py::value_error("only .glb can be instanced");
  if (instanced && nodes) throw py::value_error("leaves are instanced or nodes, not both");
  const FormatOptions options{.instances = instanced ? GltfInstances::rows
                                           : nodes   ? GltfInstances::nodes
                                                     : GltfInstances::automatic};
  if (lod < 0 || lod > kCoarsestDetail) {
    throw py::value_error(fmt::format("lod is {}; expected 0 to {}", lod, kCoarsestDetail));
  }
  if (cards < 0 || cards > kMaxCards) {
    throw py::value_error(fmt::format("cards is {}; expected 0 to {}", cards, kMaxCards));
  }
  if (cards > 0 && !format.has_textures()) throw py::value_error("only files with textures show cards");
  if (cards > 0 && lod > 0) throw py::value_error("a file holds a level of detail or cards, not both");
  if (lod > 0 && !format.has_meshes()) throw py::value_error("only files with meshes have levels of detail");
  check_grown_output(plant->origin->document, target);
  watch_of(progress)->run(threads, [&](Progress& inner) {
    const Document& document = plant->origin->document;
    if (cards > 0) {
      const GrownDocument& whole = plant->up_to(GrownPart::textures, inner);
      const GrownDocument shown{whole.plant, make_cards(whole.meshes, {.cards = cards}, inner), GrownPart::textures};
      return format.write(document, shown, target, options, inner);
    }
    if (lod == 0) return format.write(document, plant->up_to(format.needs, inner), target, options, inner);
    const GrownDocument& whole = plant->up_to(GrownPart::textures, inner);
    GrownDocument coarse{whole.plant};
    const auto keep = [&coarse](int, MeshScene level) { coarse.meshes = std::move(level); };
    if (const auto worthless = make_levels(document, whole.plant, whole.meshes, lod, keep, inner)) {
      const std::string finer =
          worthless->number < lod ? fmt::format(", as level {} is not", worthless->number) : std::string();
      throw py::value_error(fmt::format("level {} of detail is not worth a file{}: {}", lod, finer, worthless->reason));
    }
    format.write(document, coarse, target, options, inner);
  });
}

/// Returns meshes of at most about `triangles` triangles. Thinning is inexact, so it is repeated with smaller numbers.
MeshScene thinned(const PlantPointer& plant, std::uint64_t triangles, double& share, Progress& progress) {
  constexpr int kMaxTries = 4;
  const GrownDocument& whole = plant->up_to(GrownPart::textures, progress);
  const auto wanted = static_cast<double>(triangles);
  share = wanted / static_cast<double>(whole.meshes.triangle_count());
  for (int tries = 1;; ++tries) {
    MeshScene meshes = mesh_detail(plant->origin->document, whole.plant, {.level = 1, .share = share}, progress);
    const auto made = static_cast<double>(meshes.triangle_count());
    if (made <= wanted || tries == kMaxTries) return meshes;
    share *= 0.95 * wanted / made;
  }
}

py::bytes packet(const PlantPointer& plant, std::uint64_t triangles, int threads, const py::object& progress) {
  const std::string bytes = run_call(progress, threads, [&](Progress& inner) {
    const GrownDocument& whole = plant->up_to(GrownPart::textures, inner);
    // There is no editor with a text, so `hash` stays empty.
    PacketFacts facts{.fits = true,
                      .all = {.triangles = whole.meshes.triangle_count(),
                              .instances = whole.meshes.instance_count(),
                              .nodes = whole.plant.node_count()}};
    if (triangles == 0 || facts.all.triangles <= triangles) {
      return PacketMaker().next({.meshes = &whole.meshes}, facts, inner);
    }
    const MeshScene fewer = thinned(plant, triangles, facts.share, inner);
    return PacketMaker().next({.meshes = &fewer}, facts, inner);
  });
  return py::bytes(bytes);
}

PictureOptions planned_picture(const PlantPointer& plant, const std::optional<std::pair<int, int>>& size,
                               const std::optional<int>& samples, const std::optional<std::pair<double, double>>& view,
                               bool transparent, bool hull) {
  const Document& document = plant->origin->document;
  PictureOptions picture{.still = {.width = document.output.size[0], .height = document.output.size[1]},
                         .view = camera_view(document.graph),
                         .crown_hulls = hull};
  if (size) std::tie(picture.still.width, picture.still.height) = *size;
  picture.still.samples = samples.value_or(document.output.samples);
  picture.still.transparent = transparent;
  check_still_options(picture.still);
  if (view) {
    const std::optional<CameraView> seen = seen_from(picture.view, view->first, view->second);
    if (!seen) throw py::value_error(fmt::format("view must be {}", kKnownSides));
    picture.view = *seen;
  }
  return picture;
}

Image picture_of(const PlantPointer& plant, const PictureOptions& options, int threads, const py::object& progress) {
  return run_call(progress, threads, [&](Progress& inner) {
    return take_picture(plant->up_to(GrownPart::textures, inner), limits_of(plant), plant->origin->document.scene,
                        options, inner);
  });
}

py::object render(const PlantPointer& plant, const std::optional<std::pair<int, int>>& size,
                  const std::optional<int>& samples, const std::optional<std::pair<double, double>>& view,
                  bool transparent, bool hull, int threads, const py::object& progress) {
  const auto image = std::make_shared<const Image>(
      picture_of(plant, planned_picture(plant, size, samples, view, transparent, hull), threads, progress));
  return array_over(image, image->rgba.data(), {image->height, image->width, 4}, {4 * image->width, 4, 1});
}

py::bytes png(const PlantPointer& plant, const std::optional<std::pair<int, int>>& size,
              const std::optional<int>& samples, const std::optional<std::pair<double, double>>& view, bool transparent,
              bool hull, int threads, const py::object& progress) {
  return encode_png(
      picture_of(plant, planned_picture(plant, size, samples, view, transparent, hull), threads, progress));
}

void save_picture(const PlantPointer& plant, const py::object& path, const std::optional<std::pair<int, int>>& size,
                  const std::optional<int>& samples, const std::optional<std::pair<double, double>>& view,
                  bool transparent, bool hull, const std::optional<int>& quality,
                  const std::optional<std::uint64_t>& max_bytes, int threads, const py::object& progress) {
  const std::string target = file_of(path);
  const PictureFileOptions file{.quality = quality, .max_bytes = max_bytes};
  check_picture_file(target, transparent, file);
  const PictureOptions picture = planned_picture(plant, size, samples, view, transparent, hull);
  check_output(target, input_files(plant->origin->document));
  write_picture(picture_of(plant, picture, threads, progress), target, file);
}

void bind_parts(py::module_& module) {
  py::class_<Organs>(module, "Organs", R"(The organs of a plant: leaves, fruits, petals.

Columns are read-only arrays over the plant's own memory, one entry per organ.

    organs = meristem.read("tulip").grow().organs
    petals = organs.position[organs.component == "tepal"]  # (k, 3), metres
    assert len(petals) and petals[:, 1].min() > 0)")
      .def("__len__", [](const Organs& o) { return o.rows().size(); })
      .def_property_readonly(
          "frame",
          [](const Organs& o) {
            static const Organ kNone;
            const Organ* const first = o.rows().empty() ? &kNone : o.rows().data();
            return frames_view(o.plant, &first->frame, o.rows().size(), sizeof(Organ));
          },
          "(n, 4, 3) float32: the directions of x, y (the heading) and z (the upper face), and the origin. A point p "
          "of the prototype is at p @ frame[:3] + frame[3].")
      .def_property_readonly(
          "position", [](const Organs& o) { return o.position(); },
          "(n, 3) float32: position of its base, metres: the origin of its frame.")
      .def_property_readonly(
          "component", [](const Organs& o) { return components_of_organs(o.plant); },
          "(n,) texts: the id of the component that made it.")
      .def_property_readonly(
          "instance", [](const Organs& o) { return array_of(organ_instances(o.plant->plant())); },
          "(n,) uint32: its number among the organs of its component, from 0.")
      .def_property_readonly(
          "tree", [](const Organs& o) { return trees_in_python(o.plant); },
          "(n,) int64: index of its tree in measure(each=True)[\"each\"]; -1 if several trees share it, or if the "
          "trees cannot be distinguished.")
      .def_property_readonly(
          "prototype", [](const Organs& o) { return o.column<std::uint32_t>(&Organ::prototype, {}); },
          "(n,) uint32: index in Plant.prototypes.")
      .def_property_readonly(
          "tint", [](const Organs& o) { return o.column<float>(&Organ::tint, {3}); },
          "(n, 3) float32: linear factors on the material's colour.")
      .def_property_readonly(
          "birth", [](const Organs& o) { return o.column<float>(&Organ::birth, {}); },
          "(n,) float32: the growth step at which it appeared.")
      .def("__repr__", [](const Organs& o) { return fmt::format("<meristem.Organs: {}>", o.rows().size()); });

  py::class_<OrganPrototype, std::shared_ptr<OrganPrototype>>(module, "OrganPrototype",
                                                              "Geometry that many organs share.")
      .def_property_readonly(
          "component", [](const OrganPrototype& p) { return p.component; }, "The id of the component that made it.")
      .def_property_readonly(
          "material", [](const OrganPrototype& p) { return p.material; }, "Its index in Plant.materials.")
      .def_property_readonly(
          "mesh", [](const OrganPrototype& p) { return std::const_pointer_cast<Mesh>(p.mesh); },
          "The Mesh, in the organ's own frame.");

  py::class_<Stem, std::shared_ptr<Stem>>(module, "Stem", "One grown skeleton and its components.")
      .def_property_readonly(
          "skeleton", [](const std::shared_ptr<Stem>& s) { return std::shared_ptr<Skeleton>(s, &s->skeleton); },
          "The Skeleton, in world space.")
      .def_property_readonly(
          "component", [](const Stem& s) { return s.parts[0].component; },
          "The id of the component that made it. For a skeleton of several components, the id of the root's component.")
      .def_property_readonly(
          "parts",
          [](const Stem& s) {
            std::vector<std::pair<std::string, std::uint32_t>> parts;
            for (const StemPart& part : s.parts) parts.emplace_back(part.component, part.instance);
            return parts;
          },
          "The component and instance of each part: a list of (str, int).")
      .def_property_readonly(
          "part_of_axis",
          [](const Stem& s) {
            if (!s.part_of_axis.empty()) return array_of(s.part_of_axis);
            return array_of(std::vector<std::uint32_t>(SkeletonAxes(s.skeleton).count()));
          },
          "(axes,) uint32: the index in `parts` of each axis.")
      .def("__repr__", [](const Stem& s) {
        return fmt::format("<meristem.Stem of '{}', {} nodes>", s.parts[0].component, s.skeleton.node_count());
      });
  refuse_new<Organs>("plants have them");
  refuse_new<OrganPrototype>("plants have them");
  refuse_new<Stem>("plants have them");
}

std::string repr(const PlantInPython& plant) {
  const MeshScene* const meshes = plant.present_meshes();
  const PlantCounts counts = count(plant.unexpanded(), meshes != nullptr ? *meshes : MeshScene());
  std::string text = fmt::format("<meristem.Plant '{}': {} nodes, {} organs", plant.origin->document.name, counts.nodes,
                                 counts.organs);
  if (meshes != nullptr) text += fmt::format(", {} triangles, {:.2f} m high", counts.triangles, counts.height);
  return text + ">";
}

}  // namespace

void bind_plant(py::module_& module) {
  py::list need_light;
  for (const MeasureRow& row : measure_rows()) {
    if (row.needs_light) need_light.append(row.name);
  }
  module.attr("LIGHT_MEASURES") = py::module_::import("builtins").attr("frozenset")(need_light);
  bind_parts(module);
  py::class_<PlantInPython, PlantPointer>(module, "Plant", R"(A grown document: skeletons, organs and their meshes.

Document.grow() makes it. It never changes. Arrays over its memory keep it alive. Meshes and their pictures are made on
first use, which raises InputError if a limit is exceeded.

    plant = meristem.read("tulip", seed=2).grow()
    plant.save("tulip.glb")
    print(plant.measure()["height"], "m,", plant.triangle_count, "triangles"))")
      .def_property_readonly(
          "document", [](const PlantInPython& p) { return std::const_pointer_cast<DocumentInPython>(p.origin); },
          "The Document that has grown.")
      .def_property_readonly(
          "warnings", [](const PlantInPython& p) { return to_python(p.warnings()); },
          "Warnings about the plant, such as stems that go into obstacles: a tuple of Diagnostic.")
      .def_property_readonly("trace", &trace_of,
                             "The Trace of its growth if grow(trace=True) has recorded it, else None.")
      .def_property_readonly(
          "stems", [](const PlantPointer& p) { return parts_of(p, p->plant().stems); },
          "A list of Stem, one for each grown skeleton.")
      .def_property_readonly(
          "organs", [](const PlantPointer& p) { return Organs{p}; }, "All organs as Organs.")
      .def_property_readonly(
          "operations", &operations_of,
          R"(Records of the operations on self-organizing trees, done during growth or only planned: a dict of arrays.

"operation" (path in the document), "act" (cut, disbud, ring, bend, tie or mark), "iteration", "tree" (number of the
root), "shoot" (label), "rank" and "metamer" (number of the metamer at whose end the operation acted, 0 at the shoot's
base). (n, 3) float32 "position" (metres) and "bud" (unit vector to the living lateral bud there, or zeros). The removed
"metamers", "length" (metres), "wood" (cubic metres) and "light", 0 if nothing was removed.)")
      .def_property_readonly(
          "prototypes", [](const PlantPointer& p) { return parts_of(p, p->plant().prototypes); },
          "A list of OrganPrototype. Organs are instances of these.")
      .def_property_readonly(
          "meshes", [](const PlantPointer& p) { return parts_of(p, meshes_of(p).meshes); },
          "All surfaces, of stems and organs: a list of MeshInstances.")
      .def_property_readonly(
          "materials",
          [](const PlantPointer& p) { return parts_of(p, up_to(p, GrownPart::textures).meshes.materials); },
          "A list of Material.")
      .def_property_readonly(
          "node_count", [](const PlantInPython& p) { return totals_of(p.unexpanded()).nodes; },
          "Nodes of all skeletons.")
      .def_property_readonly(
          "triangle_count", [](const PlantPointer& p) { return meshes_of(p).triangle_count(); },
          "Triangles of all instances.")
      .def_property_readonly(
          "bounds",
          [](const PlantPointer& p) -> py::object {
            const Box box = meshes_of(p).bounds();
            if (box.is_empty()) return py::none();
            const auto corners = std::make_shared<const std::vector<Vec3>>(std::vector{box.low, box.high});
            return rows_view<float>(corners, *corners);
          },
          "(2, 3) float32: low and high corner of all meshes, metres; None if there are none.")
      .def("skeleton_table", &table_of,
           "Returns all nodes of all stems as columns by name, as in .csv files: a dict of arrays of one length, for "
           "pandas.DataFrame.")
      .def("measure", &measures_of, py::kw_only(), py::arg("light") = false, py::arg("each") = false,
           py::arg("scene") = py::none(), py::arg("fork_diameter") = 0.02, py::arg("crown_rays") = kCrownRays,
           py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Measures the plant: a dict of numbers, lists and None by the names that the manual lists; metres, degrees.

`light` measures the light on leaves too, which may take seconds. `each` adds a list "each" with the measures of each
tree, its "component", "instance" and "position", and the "row" of the table that has placed it, from 0, or None. The
light comes from `scene`; by default, from the scene of growth. Area ratios count from forks of `fork_diameter` metres.
The lit share uses `crown_rays` rays.)")
      .def("organ_light", &organ_light, py::kw_only(), py::arg("scene") = py::none(), py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           R"(Returns the light on each organ, in the order of the organs: a dict of arrays.

"component", "instance", "tree" and "position" as in Organs; (n,) float64 "area" (m², one side for blades), "exposure"
(the share of the light's rays that arrive) and "irradiance" (rays weighted by the cosine to the surface's normal), both
0 to 1. The light comes from `scene`; by default, from the scene of growth.)")
      .def("leaf_layers", &leaf_layers, py::arg("height") = 1.0, py::kw_only(), py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           R"(Returns the leaf area by height: a dict of float64 arrays, from the lowest layer up.

"low" and "high" of each layer above y = 0 (metres, `height` apart) and the "leaf_area" between them (m²).)")
      .def("save", &save, py::arg("path"), py::kw_only(), py::arg("instanced") = false, py::arg("nodes") = false,
           py::arg("lod") = 0, py::arg("cards") = 0, py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Writes the plant to a file. The ending selects the format: .glb, .obj, .ply, .labels.ply, .skeleton.ply,
.csv, .qsm.csv, .trees.txt, .operations.csv, .points.csv, .mtg.

`instanced` writes leaves into .glb as instances of one mesh, the default beyond 5 million triangles. Such files are
small, but not every program reads them. `nodes` writes leaves as nodes, which every program reads. `lod` (0 to 8) is
the level of detail. Each level has about a quarter of the triangles of the level before. `cards` (0 to 16) writes this
number of upright crossed cards, pictures of the plant, instead. The file appears whole or not at all. Raises ValueError
for levels that `meristem grow --lod` does not write: levels with hardly fewer triangles than the level before, levels
that would lose the plant's outline, and all coarser levels. Raises InputError for unknown endings, for .points.csv of
plants that grew without `trace=True`, and for files that the document reads. Raises MachineError.)")
      .def(
          "packet", &packet, py::kw_only(), py::arg("triangles") = 0, py::arg("threads") = 0,
          py::arg("progress") = py::none(),
          R"(Returns the plant as the bytes of a scene packet for viewers: meshes, their instances, materials, pictures.

A plant of more than `triangles` triangles is thinned out to about this number; 0 keeps all. The packet is equal on any
number of threads. apps/studio/protocol.md in the source tree describes its head and arrays.)")
      .def("render", &render, py::kw_only(), py::arg("size") = py::none(), py::arg("samples") = py::none(),
           py::arg("view") = py::none(), py::arg("transparent") = false, py::arg("hull") = false,
           py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Returns a picture: (height, width, 4) uint8, sRGB and alpha, rows from top to bottom.

`size` is (width, height) and `samples` is the number of paths per pixel, by default from the document. `view` is
(azimuth, altitude) of the camera in degrees. `transparent` leaves sky and ground out, and `hull` draws the crowns'
hulls. Raises InputError for sizes and samples out of range.)")
      .def("png", &png, py::kw_only(), py::arg("size") = py::none(), py::arg("samples") = py::none(),
           py::arg("view") = py::none(), py::arg("transparent") = false, py::arg("hull") = false,
           py::arg("threads") = 0, py::arg("progress") = py::none(), "Returns a picture as the bytes of a PNG file.")
      .def("save_picture", &save_picture, py::arg("path"), py::kw_only(), py::arg("size") = py::none(),
           py::arg("samples") = py::none(), py::arg("view") = py::none(), py::arg("transparent") = false,
           py::arg("hull") = false, py::arg("quality") = py::none(), py::arg("max_bytes") = py::none(),
           py::arg("threads") = 0, py::arg("progress") = py::none(),
           R"(Writes the picture of `render` to a .png or .jpg file, which appears whole or not at all.

`quality` (1 to 100, 90 by default) is the quality of a JPEG. It is lowered until the file has at most `max_bytes`.
Raises InputError for other endings, for options that the format lacks and for files that the document reads, and
MachineError.)")
      .def("__repr__", &repr);
  refuse_new<PlantInPython>("Document.grow() makes plants");

  auto skeleton = module.attr("Skeleton").cast<py::class_<Skeleton, std::shared_ptr<Skeleton>>>();
  skeleton.def("measure", &measures_of_skeleton, py::kw_only(), py::arg("scene") = py::none(), py::arg("each") = false,
               py::arg("fork_diameter") = 0.02, py::arg("crown_rays") = kCrownRays, py::arg("threads") = 0,
               py::arg("progress") = py::none(),
               "Returns measures like Plant.measure(), without leaves and meshes. `lit_share` needs a `scene`.");
}

}  // namespace meristem::python
