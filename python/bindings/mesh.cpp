// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/mesh.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "meristem/components/parts/surface_table.h"
#include "meristem/graph/table/reader.h"
#include "meristem/measure/convex_hull.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/tube/tubes.h"
#include "values.h"

namespace meristem::python {

namespace {

using MeshPointer = std::shared_ptr<Mesh>;

/// Returns an array of the rows, or None if there are no rows.
template <class T, class Row>
py::object optional_rows(const MeshPointer& mesh, const std::vector<Row>& rows) {
  if (rows.empty()) return py::none();
  return rows_view<T>(mesh, rows);
}

MeshPointer make_mesh(const py::object& positions, const py::object& triangles) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = points_of(positions, "positions");
  const py::array given = py::array::ensure(triangles);
  if (given && given.size() == 0) return mesh;
  if (!given || given.ndim() != 2 || given.shape(1) != 3) {
    PyErr_Clear();
    throw py::value_error(
        fmt::format("triangles must have shape (m, 3){}", given ? ", not " + shape_text(given) : std::string()));
  }
  const auto count = static_cast<std::size_t>(given.shape(0));
  const std::vector<std::int64_t> corners = whole_numbers_of(given.attr("reshape")(-1), "triangles", 3 * count, 0,
                                                             static_cast<std::int64_t>(mesh->positions.size()) - 1);
  for (std::size_t k = 0; k < count; ++k) {
    mesh->triangles.push_back({static_cast<std::uint32_t>(corners[3 * k]),
                               static_cast<std::uint32_t>(corners[3 * k + 1]),
                               static_cast<std::uint32_t>(corners[3 * k + 2])});
  }
  return mesh;
}

/// Returns the arguments as a document's `surface`, which checks their ranges.
SurfaceOptions surface_of(const py::dict& values) {
  SurfaceOptions surface;
  ParameterReader reader({}, SizeLimits());
  reader.read(surface_table(), &surface, to_value(values), DocumentPath());
  if (reader.error_count() > 0) throw InputError(reader.take_diagnostics());
  return surface;
}

MeshPointer tubes(const std::shared_ptr<Skeleton>& skeleton, const py::object& sides, const py::object& error,
                  const py::object& uv_scale, const py::object& smooth, const py::object& collar,
                  const py::object& flare, const std::string& cap, int threads, const py::object& progress) {
  const SurfaceOptions surface = surface_of(
      py::dict(py::arg("sides") = sides, py::arg("error") = error, py::arg("uv_scale") = uv_scale,
               py::arg("smooth") = smooth, py::arg("collar") = collar, py::arg("flare") = flare, py::arg("cap") = cap));
  return run_call(progress, threads, [&](Progress& inner) {
    inner.begin("meshing", skeleton->node_count());
    return std::make_shared<Mesh>(make_tubes(*skeleton, surface, inner));
  });
}

MeshPointer hull_of(const py::object& points, int threads, const py::object& progress) {
  const std::vector<Vec3> places = points_of(points, "points");
  return run_call(progress, threads,
                  [&](Progress& inner) { return std::make_shared<Mesh>(convex_hull(places, &inner)); });
}

py::object picture(const std::shared_ptr<const void>& owner, const Image& image) {
  if (image.is_empty()) return py::none();
  return view(owner, image.rgba.data(), {image.height, image.width, 4}, {4 * image.width, 4, 1});
}

py::tuple colour_of(Vec3 colour) { return py::make_tuple(colour.x, colour.y, colour.z); }

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<Mesh, MeshPointer>(module, "Mesh", R"(Triangles with shared vertices, counter-clockwise seen from outside.

Arrays are read-only views of the mesh's own memory, and stay valid as long as they are kept. The constructor copies
`positions` (n, 3) metres and `triangles` (m, 3) indices. Raises TypeError for wrong types, ValueError for wrong shapes
and indices.

    square = meristem.Mesh([[0, 0, 0], [0, 0, 1], [1, 0, 1], [1, 0, 0]], [[0, 1, 2], [0, 2, 3]])
    assert square.area == 1  # square metres)")
      .def(py::init(&make_mesh), py::arg("positions"), py::arg("triangles"))
      .def_property_readonly(
          "positions", [](const MeshPointer& m) { return rows_view<float>(m, m->positions); },
          "(n, 3) float32: metres.")
      .def_property_readonly(
          "normals", [](const MeshPointer& m) { return optional_rows<float>(m, m->normals); },
          "(n, 3) float32: unit vectors; None if the mesh has no normals.")
      .def_property_readonly(
          "uvs", [](const MeshPointer& m) { return optional_rows<float>(m, m->uvs); },
          "(n, 2) float32: positions on textures, v from base to tip; None if the mesh has no texture coordinates.")
      .def_property_readonly(
          "tangents", [](const MeshPointer& m) { return optional_rows<float>(m, m->tangents); },
          "(n, 4) float32: direction in which u rises, and the side; None if the mesh has no tangents.")
      .def_property_readonly(
          "triangles", [](const MeshPointer& m) { return rows_view<std::uint32_t>(m, m->triangles); },
          "(m, 3) uint32: indices of vertices.")
      .def_property_readonly(
          "area", [](const MeshPointer& m) { return surface_area_of(*m); },
          "Area of all triangles in square metres, one side.")
      .def_property_readonly(
          "volume", [](const MeshPointer& m) { return volume_of(*m); },
          "Enclosed volume in cubic metres; only for closed meshes.")
      .def("__repr__", [](const MeshPointer& m) {
        return fmt::format("<meristem.Mesh of {} vertices and {} triangles>", m->vertex_count(), m->triangle_count());
      });

  py::class_<Material, std::shared_ptr<Material>>(module, "Material", "How a surface looks.")
      .def_property_readonly(
          "name", [](const Material& m) { return m.name; }, "The component's id.")
      .def_property_readonly(
          "colour", [](const Material& m) { return colour_of(m.colour); },
          "The mean colour, three floats, sRGB in 0 to 1.")
      .def_property_readonly(
          "roughness", [](const Material& m) { return m.roughness; }, "0 mirror-like, 1 matt.")
      .def_property_readonly(
          "translucency", [](const Material& m) { return m.translucency; },
          "The share of light that passes through a blade.")
      .def_property_readonly(
          "opacity", [](const Material& m) { return m.opacity; },
          "The share of light that does not pass straight through: 1 solid, lower like glass.")
      .def_property_readonly(
          "two_sided", [](const Material& m) { return m.two_sided; },
          "True if the material is visible from both sides, like blades.")
      .def_property_readonly(
          "picture",
          [](const std::shared_ptr<Material>& m) -> py::object {
            return m->texture ? picture(m->texture, m->texture->colour) : py::none();
          },
          "(height, width, 4) uint8: the texture's colours, sRGB and alpha; None without a texture.")
      .def_property_readonly(
          "normal_picture",
          [](const std::shared_ptr<Material>& m) -> py::object {
            return m->texture ? picture(m->texture, m->texture->normals) : py::none();
          },
          "(height, width, 4) uint8: the texture's normals in tangent space; None without normals.")
      .def("__repr__", [](const Material& m) { return fmt::format("<meristem.Material '{}'>", m.name); });

  py::class_<MeshInstances, std::shared_ptr<MeshInstances>>(module, "MeshInstances",
                                                            "One mesh, placed any number of times.")
      .def_property_readonly(
          "component", [](const MeshInstances& m) { return m.component; }, "The id of the component that made it.")
      .def_property_readonly(
          "mesh", [](const MeshInstances& m) { return std::const_pointer_cast<Mesh>(m.mesh); },
          "The Mesh, in its own frame.")
      .def_property_readonly(
          "material", [](const MeshInstances& m) { return m.material; }, "Its index in Plant.materials.")
      .def_property_readonly(
          "frames",
          [](const std::shared_ptr<MeshInstances>& m) {
            if (m->places == nullptr) return frames_view(m, m->frames.data(), m->frames.size(), sizeof(Frame));
            auto all = std::make_shared<std::vector<Frame>>(m->count());
            for (std::size_t i = 0; i < all->size(); ++i) (*all)[i] = m->frame(i);
            return frames_view(all, all->data(), all->size(), sizeof(Frame));
          },
          "(k, 4, 3) float32: for each instance the directions of the mesh's x, y and z, and its origin. A point p of "
          "the mesh is at p @ frame[:3] + frame[3].")
      .def_property_readonly(
          "tints",
          [](const std::shared_ptr<MeshInstances>& m) -> py::object {
            if (m->tints.empty()) return py::none();
            if (m->places == nullptr) return rows_view<float>(m, m->tints);
            const auto all = std::make_shared<std::vector<Vec3>>();
            for (std::size_t i = 0; i < m->count(); ++i) all->push_back(m->tint(i));
            return rows_view<float>(all, *all);
          },
          "(k, 3) float32: linear factors on the material's colour; None if all are 1.")
      .def("__len__", [](const MeshInstances& m) { return m.count(); })
      .def("__repr__", [](const MeshInstances& m) {
        return fmt::format("<meristem.MeshInstances of '{}': {} x {} triangles>", m.component, m.count(),
                           m.mesh->triangle_count());
      });

  refuse_new<Material>("plants have them");
  refuse_new<MeshInstances>("plants have them");

  const SurfaceOptions plain;
  module.def("tubes", &tubes, py::arg("skeleton"), py::kw_only(), py::arg("sides") = plain.sides,
             py::arg("error") = plain.error, py::arg("uv_scale") = plain.uv_scale, py::arg("smooth") = plain.smooth,
             py::arg("collar") = plain.collar, py::arg("flare") = plain.flare, py::arg("cap") = "pointed",
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             R"(Returns the tubes of a Skeleton as a Mesh with normals and uvs: a closed body for each axis.

The thickest tube has `sides` sides (3 to 64). A tube deviates by up to `error` radii from the skeleton. A texture's
tile covers `uv_scale` metres. Radii are smoothed over `smooth` radii along an axis. Branches grow out of their parent
over `collar` radii. Roots are wider at the ground by the share `flare`. `cap` is pointed, round or flat.)");
  module.def(
      "convex_hull", &hull_of, py::arg("points"), py::kw_only(), py::arg("threads") = 0,
      py::arg("progress") = py::none(),
      "Returns the convex hull of `points` (n, 3), metres, as a closed Mesh. It is empty for points in one plane.");
}

}  // namespace meristem::python
