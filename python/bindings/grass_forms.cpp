// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "grass.h"
#include "meristem/base/vec.h"
#include "meristem/shape/grass/bend_leaf.h"
#include "meristem/shape/grass/load_leaf.h"
#include "meristem/shape/grass/midrib_family.h"

namespace meristem::python {

namespace {

using Pair = std::pair<double, double>;

glm::dvec2 vector_of(Pair pair) { return {pair.first, pair.second}; }

/// A rate of a leaf's life: a number, or a function of the lived time and the visible share.
class Rate {
 public:
  Rate(const py::object& rate, const char* name) : name_(name) {
    if (PyCallable_Check(rate.ptr()) != 0) {
      call_ = rate;
    } else {
      number_ = checked(rate);
    }
  }
  double operator()(double lived, double visible) const { return call_ ? checked(call_(lived, visible)) : number_; }

 private:
  double checked(const py::object& value) const {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      throw py::type_error(fmt::format("{} must be a number, or give one when called with (lived, visible)", name_));
    }
    if (!std::isfinite(number)) throw py::value_error(fmt::format("{} is {}", name_, number));
    return number;
  }

  const char* name_;
  py::object call_;
  double number_ = 1;
};

GrassLeaf live(const GrassLeaf& leaf, const MidribFamily& family, double time, double step, const py::object& age,
               const py::object& length, const py::object& width, const py::object& bend, double full_age) {
  const Rate of_age(age, "age"), of_length(length, "length"), of_width(width, "width"), of_bend(bend, "bend");
  return lived(
      leaf, family, time, step,
      [&](double now, double visible) {
        return GrowthRates{.age = of_age(now, visible),
                           .length = of_length(now, visible),
                           .width = of_width(now, visible),
                           .bend = of_bend(now, visible)};
      },
      full_age);
}

GrassLeaf turn(const GrassLeaf& leaf, const std::vector<std::tuple<double, double, double>>& turns) {
  std::vector<LocalTurn> local;
  for (const auto& [from, to, angle] : turns) {
    if (!std::isfinite(angle)) throw py::value_error(fmt::format("turns[{}]: the angle is {}", local.size(), angle));
    local.push_back({from, to, radians(angle)});
  }
  return turned(leaf, local);
}

LeafLoads loads_of(Pair pull, Pair wind, Pair gravity, Pair measured_gravity) {
  return {vector_of(pull), vector_of(wind), vector_of(gravity), vector_of(measured_gravity)};
}

GrassLeaf load(const GrassLeaf& leaf, double stiffness, double tip_thickness, Pair pull, Pair wind, Pair gravity,
               Pair measured_gravity) {
  return loaded(leaf, {stiffness, tip_thickness}, loads_of(pull, wind, gravity, measured_gravity));
}

double find_load(const GrassLeaf& leaf, double place, double angle, double stiffness, double tip_thickness, Pair pull,
                 Pair wind, Pair gravity) {
  return load_for_turn(leaf, {stiffness, tip_thickness}, loads_of(pull, wind, gravity, gravity), place, radians(angle));
}

void bind_family(py::module_& module) {
  using Ages = std::vector<std::pair<double, GrassLeaf>>;
  py::class_<MidribFamily, std::shared_ptr<MidribFamily>>(module, "MidribFamily",
                                                          R"(The midribs of one leaf at several ages.

Made from one GrassLeaf, which is the form at age 1; at age 0 the leaf is straight along the stem. Or made from a list
of at least two pairs (age, GrassLeaf) with rising ages. Between ages the directions of the pieces are interpolated, so
that the length is kept. Raises ValueError.)")
      .def(py::init<const GrassLeaf&>(), py::arg("midribs"))
      .def(py::init<const Ages&>(), py::arg("midribs"))
      .def_property_readonly("first_age", &MidribFamily::first_age, "The least age.")
      .def_property_readonly("last_age", &MidribFamily::last_age, "The greatest age.")
      .def_property_readonly("piece_count", &MidribFamily::piece_count, "Number of equal pieces of each midrib.")
      .def(
          "angles", [](const MidribFamily& f, double age) { return array_of(in_degrees(f.angles(age))); },
          py::arg("age"),
          "Returns (n,) float64: degrees away from the stem of each piece. An age outside the family counts as the "
          "nearest age of the family.")
      .def("__repr__", [](const MidribFamily& f) {
        return fmt::format("<meristem.grass.MidribFamily of ages {:.4g} to {:.4g}>", f.first_age(), f.last_age());
      });
}

void bind_ages(py::module_& module) {
  bind_family(module);
  module.def("visible_share", &visible_share, py::arg("age"), py::kw_only(), py::arg("full_age") = 1.0,
             "Returns the visible share of the final length at `age`. It rises evenly to 1 at `full_age`.");
  module.def("aged", &aged, py::call_guard<py::gil_scoped_release>(), py::arg("leaf"), py::arg("family"),
             py::arg("age"), py::kw_only(), py::arg("full_age") = 1.0, R"(Returns the leaf at `age`, from a full-grown
leaf.

Its midrib comes from the MidribFamily `family`. It has the widths of the emerged part; the tip emerges first. It shows
visible_share(age, full_age) of its length, which may be 0.)");
  module.def("lived", &live, py::arg("leaf"), py::arg("family"), py::arg("time"), py::arg("step"), py::kw_only(),
             py::arg("age") = 1.0, py::arg("length") = 1.0, py::arg("width") = 1.0, py::arg("bend") = 1.0,
             py::arg("full_age") = 1.0, R"(Returns the leaf after a life up to `time` in steps of `step`, with its own
rates.

The rates are factors in each step; the plain leaf has 1. `age` is the speed of ageing. `length` is the length that
emerges with each step of age, and `width` is the width of this part. `bend` is the turn of the pieces. Each rate is a
number, or a function of the lived time and the visible share of the length that returns a number. Negative rates count
as 0, except `bend`. Raises TypeError, ValueError for a step that is not above 0 or for over 100,000 steps, and
exceptions of the functions.)");
}

void bind_turns(py::module_& module) {
  module.def("turned", &turn, py::arg("leaf"), py::arg("turns"), R"(Returns the leaf with local turns of its midrib.

`turns` is a list of (from, to, angle): two positions along the midrib, 0 to 1, and the degrees by which the part beyond
turns, positive down. A turn is spread evenly between its positions, or is a kink if they are equal. Pieces keep their
lengths. Raises ValueError.)");
  module.def(
      "inclined",
      [](const GrassLeaf& leaf, double angle) {
        if (!std::isfinite(angle)) throw py::value_error(fmt::format("angle is {}", angle));
        return inclined(leaf, radians(angle));
      },
      py::arg("leaf"), py::arg("angle"),
      "Returns the leaf, turned as a whole about its collar, so that it leaves the stem at `angle` degrees.");
}

void bind_loads(py::module_& module) {
  const LeafStrip strip;
  const Pair none(0, 0), down(0, -1);
  module.def("loaded", &load, py::call_guard<py::gil_scoped_release>(), py::arg("leaf"), py::kw_only(),
             py::arg("stiffness") = strip.stiffness, py::arg("tip_thickness") = strip.tip_thickness,
             py::arg("pull") = none, py::arg("wind") = none, py::arg("gravity") = down,
             py::arg("measured_gravity") = down, R"(Returns the leaf's form under loads, as an elastic strip that is
held at its collar.

Loads are vectors (x, y) in the leaf's plane, away from the stem and along it, in units of its weight per square metre:
`pull` acts on every part equally, and `wind` by the square of the sine of its angle to the blade. The given form
includes the leaf's own weight, which acts along `measured_gravity`. Another `gravity` describes a leaf that was turned
over. `stiffness` is the stiffness of the base divided by weight and cubed length: with 0.1 a leaf hardly carries
itself, with 1 it is upright. The stiffness falls to the tip with the width and with the cube of the thickness, which is
`tip_thickness` there. Raises ValueError, also for a leaf that does not come to rest.)");
  module.def("load_for_turn", &find_load, py::call_guard<py::gil_scoped_release>(), py::arg("leaf"), py::arg("place"),
             py::arg("angle"), py::kw_only(), py::arg("stiffness") = strip.stiffness,
             py::arg("tip_thickness") = strip.tip_thickness, py::arg("pull") = none, py::arg("wind") = none,
             py::arg("gravity") = down, R"(Returns the load that gives a wanted turn: the inverse of loaded().

The load is a factor on `pull` and `wind`. With it, the midrib at `place` (above 0, up to 1) turns by `angle` degrees,
positive down, from the given form. Raises ValueError if no factor up to 1000 gives this turn.)");
}

}  // namespace

void bind_grass_forms(py::module_& module) {
  bind_ages(module);
  bind_turns(module);
  bind_loads(module);
}

}  // namespace meristem::python
