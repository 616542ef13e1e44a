// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/skeleton.h"

#include <limits>
#include <optional>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "meristem/base/read_file.h"
#include "meristem/base/reading_stop.h"
#include "meristem/output/skeleton/skeleton_mtg.h"
#include "meristem/plant/axis_labels.h"
#include "meristem/plant/file/node_table.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/split_trees.h"
#include "values.h"

namespace meristem::python {

namespace {

using SkeletonPointer = std::shared_ptr<Skeleton>;

constexpr const char* kColumns[] = {"parent", "position", "radius", "axis", "order", "birth"};

/// Parents as signed numbers: kNoNode reads as -1 in this memory.
py::object parent_of(const SkeletonPointer& skeleton) {
  return view(skeleton, reinterpret_cast<const std::int32_t*>(skeleton->parent.data()),
              {static_cast<py::ssize_t>(skeleton->node_count())}, {sizeof(NodeIndex)});
}

std::vector<std::string> names_of(const SkeletonPointer& skeleton) {
  std::vector<std::string> names(std::begin(kColumns), std::end(kColumns));
  for (const auto& [name, column] : skeleton->extra) names.push_back(name);
  return names;
}

py::object column_of(const SkeletonPointer& skeleton, const std::string& name) {
  if (name == "parent") return parent_of(skeleton);
  if (name == "position") return rows_view<float>(skeleton, skeleton->position);
  if (name == "radius") return column_view(skeleton, skeleton->radius);
  if (name == "axis") return column_view(skeleton, skeleton->axis);
  if (name == "order") return column_view(skeleton, skeleton->order);
  if (name == "birth") return column_view(skeleton, skeleton->birth);
  const auto found = skeleton->extra.find(name);
  if (found != skeleton->extra.end()) return column_view(skeleton, found->second);
  const std::vector<std::string> names = names_of(skeleton);
  const std::string nearest = nearest_name(name, names);
  throw py::key_error(fmt::format("the skeleton has no column '{}'; {}", name,
                                  nearest.empty() ? fmt::format("expected one of {}", fmt::join(names, ", "))
                                                  : fmt::format("did you mean '{}'?", nearest)));
}

std::vector<float> floats_of(const py::object& object, const char* name, std::size_t rows) {
  std::vector<float> column;
  for (const double number : numbers_of(object, name, rows)) {
    if (std::abs(number) > std::numeric_limits<float>::max())
      throw py::value_error(fmt::format("{} holds {}, which is too large", name, number));
    column.push_back(static_cast<float>(number));
  }
  return column;
}

/// Checks axes: they must be numbered in the order of their first nodes, and each must begin at one parent node.
void check_axes(const Skeleton& skeleton) {
  AxisIndex count = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.axis[node] > count) {
      throw py::value_error(
          fmt::format("axis[{}] is {}; axes are numbered from 0 in the order of their first nodes, so "
                      "at most {} was expected",
                      node, skeleton.axis[node], count));
    }
    if (skeleton.axis[node] == count) ++count;
  }
}

SkeletonPointer make_skeleton(const py::object& parent, const py::object& position, const py::object& radius,
                              const py::object& axis, const py::object& order, const py::object& birth,
                              const std::optional<std::map<std::string, py::object>>& extra) {
  auto skeleton = std::make_shared<Skeleton>();
  skeleton->position = points_of(position, "position");
  const std::size_t rows = skeleton->position.size();
  if (rows >= kNoNode / 2) throw py::value_error("a skeleton has fewer than 2^31 nodes");
  const std::vector<std::int64_t> parents =
      whole_numbers_of(parent, "parent", rows, -1, static_cast<std::int64_t>(rows) - 1);
  for (std::size_t k = 0; k < rows; ++k) {
    if (parents[k] >= static_cast<std::int64_t>(k)) {
      throw py::value_error(fmt::format(
          "parent[{}] is {}; a parent's index is smaller than its child's, or -1 for a root", k, parents[k]));
    }
    skeleton->parent.push_back(parents[k] < 0 ? kNoNode : static_cast<NodeIndex>(parents[k]));
  }
  skeleton->radius = radius.is_none() ? std::vector<float>(rows) : floats_of(radius, "radius", rows);
  for (std::size_t k = 0; k < rows; ++k) {
    if (skeleton->radius[k] < 0) throw py::value_error(fmt::format("radius[{}] is negative", k));
  }
  skeleton->birth = birth.is_none() ? std::vector<float>(rows) : floats_of(birth, "birth", rows);
  skeleton->axis.resize(rows);
  skeleton->order.resize(rows);
  if (axis.is_none() != order.is_none()) throw py::value_error("axis and order are given together or not at all");
  if (axis.is_none()) {
    if (radius.is_none()) assign_pipe_radii(*skeleton, {});
    assign_axes(*skeleton);
    if (radius.is_none()) skeleton->radius.assign(rows, 0);
  } else {
    const std::vector<std::int64_t> axes = whole_numbers_of(axis, "axis", rows, 0, static_cast<std::int64_t>(rows));
    const std::vector<std::int64_t> orders = whole_numbers_of(order, "order", rows, 0, 65535);
    for (std::size_t k = 0; k < rows; ++k) {
      skeleton->axis[k] = static_cast<AxisIndex>(axes[k]);
      skeleton->order[k] = static_cast<std::uint16_t>(orders[k]);
    }
    check_axes(*skeleton);
  }
  if (extra) {
    for (const auto& [name, column] : *extra) {
      for (const char* known : kColumns) {
        if (name == known) throw py::value_error(fmt::format("'{}' is not a further column", name));
      }
      skeleton->extra.emplace(name, floats_of(column, name.c_str(), rows));
    }
  }
  return skeleton;
}

py::object bounds_of(const SkeletonPointer& skeleton) {
  if (skeleton->node_count() == 0) return py::none();
  const Box box = bounds(*skeleton);
  const auto corners = std::make_shared<const std::vector<Vec3>>(std::vector{box.low, box.high});
  return rows_view<float>(corners, *corners);
}

std::vector<SkeletonPointer> trees_of(const SkeletonPointer& skeleton) {
  std::vector<SkeletonPointer> trees;
  for (Skeleton& tree : split_trees(*skeleton)) trees.push_back(std::make_shared<Skeleton>(std::move(tree)));
  return trees;
}

SkeletonPointer read_mtg_file(const py::object& file, const std::array<std::string, 3>& coordinates,
                              const std::string& diameter, double unit, const std::optional<double>& diameter_unit) {
  if (!(unit > 0) || !(diameter_unit.value_or(unit) > 0)) throw py::value_error("units must be above 0 metres");
  const std::string path = path_of(file);
  return run_call(py::none(), 1, [&](Progress& progress) {
    const ReadingStop stop(&progress);
    const SizeLimits limits;
    MtgSkeleton read = skeleton_of(read_mtg(read_file(path, limits.file_bytes), path, limits), path,
                                   {.position = coordinates,
                                    .diameter = diameter,
                                    .length_unit = unit,
                                    .diameter_unit = diameter_unit.value_or(unit)},
                                   limits);
    return std::make_shared<Skeleton>(std::move(read.skeleton));
  });
}

SkeletonPointer read_skeleton_file(const py::object& file, double unit, const std::optional<double>& diameter_unit,
                                   const std::string& up, bool at_origin) {
  if (!(unit > 0) || !(diameter_unit.value_or(unit) > 0)) throw py::value_error("units must be above 0 metres");
  if (up != "file" && up != "y" && up != "z") throw py::value_error("up is 'file', 'y' or 'z'");
  const std::string path = path_of(file);
  return run_call(py::none(), 1, [&](Progress& progress) {
    const ReadingStop stop(&progress);
    const SizeLimits limits;
    const NodeTable table = read_node_table(read_file(path, limits.file_bytes), path, limits);
    const bool is_y_up = up == "file" ? table.is_y_up : up == "y";
    return std::make_shared<Skeleton>(skeleton_of(table,
                                                  {.unit = unit,
                                                   .radius_factor = diameter_unit.value_or(unit) / unit,
                                                   .is_y_up = is_y_up,
                                                   .begins_at_origin = at_origin},
                                                  path));
  });
}

void save_mtg(const SkeletonPointer& skeleton, const py::object& path, int threads, const py::object& progress) {
  const std::string target = file_of(path);
  watch_of(progress)->run(threads, [&](Progress& inner) {
    Plant plant;
    plant.stems.emplace_back().skeleton = *skeleton;
    write_skeleton_mtg(plant, SizeLimits(), target, {}, inner);
  });
}

}  // namespace

void bind_skeleton(py::module_& module) {
  py::class_<Skeleton, SkeletonPointer>(module, "Skeleton", R"(Nodes joined by segments from parent to child.

Columns are read-only arrays over the skeleton's own memory, one entry per node. They stay valid as long as they are
kept. A parent's index is smaller than its children's. The constructor copies: `parent` (n,) whole numbers, -1 for
roots; `position` (n, 3) metres; `radius` (n,) metres; `axis` and `order` (n,), by default determined from the thickest
children; `birth` (n,) growth steps; `extra`: further columns of numbers by name. Raises TypeError for wrong types,
ValueError for wrong shapes and values.

    fork = meristem.Skeleton([-1, 0, 1, 1], [[0, 0, 0], [0, 1, 0], [-0.5, 2, 0], [0.5, 2, 0]],
                             radius=[0.03, 0.03, 0.01, 0.01])
    lengths = np.linalg.norm(fork.position[1:] - fork.position[fork.parent[1:]], axis=1)
    assert abs(lengths.sum() - fork.measure()["length"]) < 1e-5)")
      .def(py::init(&make_skeleton), py::arg("parent"), py::arg("position"), py::kw_only(),
           py::arg("radius") = py::none(), py::arg("axis") = py::none(), py::arg("order") = py::none(),
           py::arg("birth") = py::none(), py::arg("extra") = py::none())
      .def_property_readonly("parent", &parent_of, "(n,) int32: the index of each node's parent, -1 for roots.")
      .def_property_readonly(
          "position", [](const SkeletonPointer& s) { return column_of(s, "position"); },
          "(n, 3) float32: metres; y up, x east, z south.")
      .def_property_readonly(
          "radius", [](const SkeletonPointer& s) { return column_of(s, "radius"); },
          "(n,) float32: metres at the node.")
      .def_property_readonly(
          "axis", [](const SkeletonPointer& s) { return column_of(s, "axis"); },
          "(n,) uint32: number of the node's axis. Axes are numbered in the order of their first nodes.")
      .def_property_readonly(
          "order", [](const SkeletonPointer& s) { return column_of(s, "order"); },
          "(n,) uint16: branching order, 0 on the stem.")
      .def_property_readonly(
          "birth", [](const SkeletonPointer& s) { return column_of(s, "birth"); },
          "(n,) float32: the growth step at which a node appeared.")
      .def("keys", &names_of,
           "Returns the names of all columns: the six columns of every skeleton, and further columns.")
      .def("__getitem__", &column_of, py::arg("name"), "A column by its name. Raises KeyError.")
      .def(
          "__contains__",
          [](const SkeletonPointer& s, const std::string& name) {
            const std::vector<std::string> names = names_of(s);
            return std::find(names.begin(), names.end(), name) != names.end();
          },
          py::arg("name"))
      .def("__len__", [](const SkeletonPointer& s) { return s->node_count(); })
      .def("__repr__",
           [](const SkeletonPointer& s) { return fmt::format("<meristem.Skeleton of {} nodes>", s->node_count()); })
      .def("trees", &trees_of, "One Skeleton for each root, in their order.")
      .def(
          "tip_distance", [](const SkeletonPointer& s) { return array_of(tip_distance(*s)); },
          "Returns (n,) float32: metres along the skeleton from each node to the farthest tip beyond it.")
      .def_property_readonly(
          "bounds", &bounds_of,
          "Returns (2, 3) float32: low and high corner, including radii; None if the skeleton is empty.")
      .def_property_readonly(
          "hash", [](const SkeletonPointer& s) { return skeleton_hash(*s); },
          "Returns 32 hexadecimal digits, equal for skeletons of equal bytes.")
      .def_property_readonly(
          "labels", [](const SkeletonPointer& s) { return axis_labels(*s); },
          "The label of each axis, a list of str: \"main\" for those from a root, else the parent's label, a dot and "
          "the "
          "number of the node that bears it, from the column \"metamer\" if there is one.")
      .def("save_mtg", &save_mtg, py::arg("path"), py::kw_only(), py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           R"(Writes the skeleton to an .mtg file, a multiscale tree graph in metres. read_mtg restores an equal
skeleton.

The file appears whole or not at all. Raises InputError for columns whose names a file cannot have, and
MachineError.)");

  module.def("read_mtg", &read_mtg_file, py::arg("path"), py::kw_only(),
             py::arg("coordinates") = std::array<std::string, 3>{"XX", "YY", "ZZ"}, py::arg("diameter") = "",
             py::arg("unit") = 1.0, py::arg("diameter_unit") = py::none(),
             R"(Reads a coded and digitised plant from an MTG file. Returns a Skeleton.

`coordinates` are the names of the features with the coordinates to the east, to the north and up. `diameter` is the
name of the feature with diameters (TopDia or TopDiameter if empty). `unit` and `diameter_unit` are the units in metres.
Other numeric features become columns, and `birth` becomes the column of that name. Raises InputError with the line.)");
  module.def("read_skeleton", &read_skeleton_file, py::arg("path"), py::kw_only(), py::arg("unit") = 1.0,
             py::arg("diameter_unit") = py::none(), py::arg("up") = "file", py::arg("at_origin") = true,
             R"(Reads a Skeleton from a table of cylinders (TreeQSM, SimpleForest), of trees (treetools) or of nodes.

`unit` and `diameter_unit` are the units in metres. `up` is the axis of the file that points up: "file" is y in tables
that Meristem has written and z in all others. `at_origin` moves the first root to the origin. Raises InputError with
the line.)");
}

}  // namespace meristem::python
