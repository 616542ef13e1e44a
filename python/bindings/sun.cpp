// SPDX-License-Identifier: Apache-2.0
// Positions of the sun, for numbers and for arrays, in degrees.
#include "meristem/scene/light/sun.h"

#include <limits>

#include <fmt/format.h>

#include "arrays.h"
#include "scene.h"

namespace meristem::python {

namespace {

/// An argument and its allowed range.
struct Asked {
  const char* name;
  py::object value;
  double low;
  double high;
};

Asked latitude_asked(const py::object& latitude) { return {"latitude", latitude, -90, 90}; }
Asked day_asked(const py::object& day) { return {"day", day, 1, 366}; }

/// Arguments, broadcast to one shape by numpy.
class Broadcast {
 public:
  explicit Broadcast(const std::vector<Asked>& asked) {
    py::list arrays;
    for (const Asked& each : asked) arrays.append(checked(each));
    const py::object same = py::module_::import("numpy").attr("broadcast_arrays")(*arrays);
    for (const py::handle array : same) columns_.push_back(py::cast<Numbers>(array));
    shape_ = columns_[0].attr("shape");
  }

  std::size_t count() const { return static_cast<std::size_t>(columns_[0].size()); }
  bool is_number() const { return columns_[0].ndim() == 0; }
  double operator()(std::size_t argument, std::size_t k) const { return columns_[argument].data()[k]; }

  /// Returns a float if all arguments are numbers, else an array of their shape.
  py::object shaped(std::vector<double> values) const {
    if (is_number()) return py::float_(values[0]);
    return array_of(std::move(values)).attr("reshape")(shape_);
  }
  /// Returns an array of their shape with 3 numbers each.
  py::object shaped_vectors(std::vector<float> values) const {
    return array_of(std::move(values)).attr("reshape")(shape_ + py::make_tuple(3));
  }

 private:
  using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

  static py::array checked(const Asked& asked) {
    const py::array given = py::array::ensure(asked.value);
    const std::size_t count = given ? static_cast<std::size_t>(given.size()) : 0;
    const py::object flat = given ? given.attr("reshape")(-1) : asked.value;
    if (!given) PyErr_Clear();
    const std::vector<double> numbers = numbers_of(flat, asked.name, count);
    for (std::size_t k = 0; k < count; ++k) {
      if (numbers[k] >= asked.low && numbers[k] <= asked.high) continue;
      const std::string place = given.ndim() == 0 ? asked.name : fmt::format("{}[{}]", asked.name, k);
      throw py::value_error(fmt::format("{} is {}; expected {} to {}", place, numbers[k], asked.low, asked.high));
    }
    return given;
  }

  std::vector<Numbers> columns_;
  py::tuple shape_;
};

py::tuple position(const py::object& latitude, const py::object& day, const py::object& hour) {
  const Broadcast asked({latitude_asked(latitude), day_asked(day), {"hour", hour, 0, 24}});
  std::vector<double> azimuth;
  std::vector<double> altitude;
  for (std::size_t k = 0; k < asked.count(); ++k) {
    const SkyDirection sun = sun_position(radians(asked(0, k)), asked(1, k), asked(2, k));
    azimuth.push_back(degrees(sun.azimuth));
    altitude.push_back(degrees(sun.altitude));
  }
  return py::make_tuple(asked.shaped(std::move(azimuth)), asked.shaped(std::move(altitude)));
}

py::object hours_of_daylight(const py::object& latitude, const py::object& day) {
  const Broadcast asked({latitude_asked(latitude), day_asked(day)});
  const double night = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sunrise;
  std::vector<double> sunset;
  for (std::size_t k = 0; k < asked.count(); ++k) {
    const auto hours = daylight(radians(asked(0, k)), asked(1, k));
    if (!hours && asked.is_number()) return py::none();
    sunrise.push_back(hours ? hours->first : night);
    sunset.push_back(hours ? hours->second : night);
  }
  return py::make_tuple(asked.shaped(std::move(sunrise)), asked.shaped(std::move(sunset)));
}

py::object declination_of(const py::object& day) {
  const Broadcast asked({day_asked(day)});
  std::vector<double> angles;
  for (std::size_t k = 0; k < asked.count(); ++k) angles.push_back(degrees(declination(asked(0, k))));
  return asked.shaped(std::move(angles));
}

py::object unit_vectors(const py::object& azimuth, const py::object& altitude) {
  const Broadcast asked({{"azimuth", azimuth, -360, 360}, {"altitude", altitude, -90, 90}});
  std::vector<float> numbers;
  for (std::size_t k = 0; k < asked.count(); ++k) {
    const Vec3 vector = unit_vector({radians(asked(0, k)), radians(asked(1, k))});
    numbers.insert(numbers.end(), {vector.x, vector.y, vector.z});
  }
  return asked.shaped_vectors(std::move(numbers));
}

}  // namespace

void bind_sun(py::module_& module) {
  module.def("sun_position", &position, py::arg("latitude"), py::arg("day"), py::arg("hour"),
             R"(Returns the position of the sun as (azimuth, altitude) in degrees. An altitude below 0 is night.

`latitude` in degrees, north positive; `day` of the year, 1 to 366; `hour` in true solar time, 0 to 24, so that the sun
is highest at 12. Each is a number or an array; arrays are broadcast, and the results have their shape. Azimuths from
north over east. Raises TypeError, and ValueError for values out of range.)");
  module.def("daylight", &hours_of_daylight, py::arg("latitude"), py::arg("day"),
             R"(Returns the hours of (sunrise, sunset): (0, 24) on the polar day, and None in the polar night.

Arguments as in sun_position(). For arrays the hours are arrays, with nan in the polar night.)");
  module.def(
      "declination", &declination_of, py::arg("day"),
      "Returns the sun's declination in degrees on a `day` of the year, 1 to 366. For an array, returns an array.");
  module.def("unit_vector", &unit_vectors, py::arg("azimuth"), py::arg("altitude"),
             R"(Returns (3,) float32: the unit vector toward an azimuth and an altitude (degrees). For arrays, returns
(..., 3).

x east, y up, z south. Azimuths from north over east, -360 to 360; altitudes -90 to 90.)");
}

}  // namespace meristem::python
