// SPDX-License-Identifier: Apache-2.0
// A growth step by step, as arrays.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"

namespace meristem::python {

namespace {

using PlantPointer = std::shared_ptr<PlantInPython>;

/// The traces of a plant, which they keep alive.
struct Trace {
  PlantPointer plant;

  const GrowthTraces& all() const { return plant->traces(); }
};

int checked(const Trace& trace, const std::optional<int>& step) {
  const int last = trace.all().last_step;
  const int asked = step.value_or(trace.all().shown_step());
  if (asked < 0 || asked > last) throw py::value_error(fmt::format("step must be 0 to {}", last));
  return asked;
}

/// Returns the id of the grown component for each row; `count` gives the number of rows of a component's marks.
template <class Count>
py::object components_of_rows(const std::vector<GrowthMarks>& growths, Count count) {
  py::list names;
  std::vector<std::int64_t> numbers;
  for (std::size_t k = 0; k < growths.size(); ++k) {
    names.append(growths[k].component);
    numbers.insert(numbers.end(), count(growths[k].marks), static_cast<std::int64_t>(k));
  }
  if (growths.empty()) names.append("");
  const py::object array = py::module_::import("numpy").attr("array")(names, "str");
  return array.attr("take")(array_of(std::move(numbers)));
}

std::vector<GrowthMarks> marks_of(const Trace& trace, const std::optional<int>& step, TracePart part) {
  const int asked = checked(trace, step);
  return run_call(py::none(), 0, [&](Progress& inner) { return trace.all().marks_of_growths(asked, {part}, inner); });
}

/// Ways toward more light or toward more room; a growth has only one kind.
std::vector<GrowthMarks> ways_of(const Trace& trace, const std::optional<int>& step) {
  std::vector<GrowthMarks> growths = marks_of(trace, step, TracePart::ways);
  for (auto& [component, instance, marks] : growths)
    marks.ways.insert(marks.ways.end(), marks.room_ways.begin(), marks.room_ways.end());
  return growths;
}

py::dict places_in_python(const std::vector<GrowthMarks>& growths, std::vector<TracedPlace> StepMarks::*member) {
  static constexpr std::array<const char*, 3> kStates{"free", "used", "removed"};
  std::vector<Vec3> positions;
  std::vector<std::int64_t> states, used_in;
  for (const GrowthMarks& growth : growths) {
    for (const TracedPlace& place : growth.marks.*member) {
      positions.push_back(place.position);
      states.push_back(static_cast<std::int64_t>(place.state));
      used_in.push_back(place.used_in);
    }
  }
  py::list names;
  for (const char* name : kStates) names.append(name);
  py::dict columns;
  columns["component"] = components_of_rows(growths, [&](const StepMarks& one) { return (one.*member).size(); });
  const auto owner = std::make_shared<const std::vector<Vec3>>(std::move(positions));
  columns["position"] = rows_view<float>(owner, *owner);
  columns["state"] = py::module_::import("numpy").attr("array")(names, "str").attr("take")(array_of(std::move(states)));
  columns["used_in"] = array_of(std::move(used_in));
  return columns;
}

py::dict ways_in_python(const std::vector<GrowthMarks>& growths, std::vector<TracedWay> StepMarks::*member) {
  auto begins = std::make_shared<std::vector<Vec3>>();
  auto ends = std::make_shared<std::vector<Vec3>>();
  for (const GrowthMarks& growth : growths) {
    for (const TracedWay& way : growth.marks.*member) {
      begins->push_back(way.from);
      ends->push_back(way.to);
    }
  }
  py::dict columns;
  columns["component"] = components_of_rows(growths, [&](const StepMarks& one) { return (one.*member).size(); });
  columns["begin"] = rows_view<float>(begins, *begins);
  columns["end"] = rows_view<float>(ends, *ends);
  return columns;
}

py::list losses_in_python(const std::vector<GrowthMarks>& growths) {
  py::list list;
  for (const GrowthMarks& growth : growths) {
    for (const TracedLoss& loss : growth.marks.losses) {
      auto segments = std::make_shared<std::vector<TracedWay>>(loss.segments);
      static_assert(sizeof(TracedWay) == 6 * sizeof(float));
      py::dict told;
      told["step"] = loss.step;
      told["why"] = loss.why.path;
      told["position"] = py::make_tuple(loss.position.x, loss.position.y, loss.position.z);
      told["length"] = loss.length;
      told["segments"] = view(segments, reinterpret_cast<const float*>(segments->data()),
                              {static_cast<py::ssize_t>(segments->size()), 2, 3},
                              {sizeof(TracedWay), 3 * sizeof(float), sizeof(float)});
      list.append(std::move(told));
    }
  }
  return list;
}

py::list skeletons_in_python(const Trace& trace, const std::optional<int>& step) {
  const int asked = checked(trace, step);
  std::vector<std::shared_ptr<Skeleton>> skeletons = run_call(py::none(), 0, [&](Progress& inner) {
    std::vector<std::shared_ptr<Skeleton>> made;
    for (const TracedGrowth& growth : trace.all().growths) {
      made.push_back(
          std::make_shared<Skeleton>(growth.trace->standing(asked, trace.plant->origin->document.scene, inner)));
    }
    return made;
  });
  py::list list;
  for (const std::shared_ptr<Skeleton>& skeleton : skeletons) list.append(skeleton);
  return list;
}

}  // namespace

py::object trace_of(const PlantPointer& plant) {
  return plant->traces().has_growths() ? py::cast(Trace{plant}) : py::object(py::none());
}

void bind_trace(py::module_& module) {
  py::class_<Trace>(module, "Trace", R"(The growth of a plant step by step, if grow() has recorded it.

Steps count from 1; step 0 is before growth. `step` is by default the step of the plant. Columns are read-only arrays,
one row per point, way or marker, with the id of the grown `component`. Plants of other documents have rows at each of
their places, with ids such as "oak.tree".

    trace = meristem.read("oak", set={"age": 8}).grow(trace=True).trace
    for step in range(0, trace.steps, 20):
        print(step, sum(len(skeleton) for skeleton in trace.skeletons(step)), "nodes"))")
      .def_property_readonly(
          "steps", [](const Trace& trace) { return trace.all().last_step; }, "Steps that growth took.")
      .def_property_readonly(
          "step", [](const Trace& trace) { return trace.all().shown_step(); }, "Step that the plant stands at.")
      .def_property_readonly(
          "bytes", [](const Trace& trace) { return trace.all().bytes(); }, "Bytes of memory that it takes.")
      .def("skeletons", &skeletons_in_python, py::arg("step") = py::none(),
           "Returns the skeletons after a step, one for each instance of a component that grows. They equal the "
           "skeletons of a growth with no more iterations. Plants of other documents are not included.")
      .def(
          "points",
          [](const Trace& trace, const std::optional<int>& step) {
            return places_in_python(marks_of(trace, step, TracePart::points), &StepMarks::points);
          },
          py::arg("step") = py::none(),
          "Returns attraction points: component, position (n, 3), state (free, used or removed), used_in (step; 0 if "
          "the point was not used).")
      .def(
          "pulls",
          [](const Trace& trace, const std::optional<int>& step) {
            return ways_in_python(marks_of(trace, step, TracePart::pulls), &StepMarks::pulls);
          },
          py::arg("step") = py::none(),
          "Returns lines from nodes to the attraction points that pull them in the next step: component, begin (n, 3), "
          "end (n, 3).")
      .def(
          "ways",
          [](const Trace& trace, const std::optional<int>& step) {
            return ways_in_python(ways_of(trace, step), &StepMarks::ways);
          },
          py::arg("step") = py::none(),
          "Returns lines of one metre from buds that grew in the step toward more light or room: component, begin (n, "
          "3), end (n, 3).")
      .def(
          "markers",
          [](const Trace& trace, const std::optional<int>& step) {
            return places_in_python(marks_of(trace, step, TracePart::markers), &StepMarks::markers);
          },
          py::arg("step") = py::none(),
          "Returns markers of room around self-organizing plants, with the columns of points().")
      .def(
          "losses",
          [](const Trace& trace, const std::optional<int>& step) {
            return losses_in_python(marks_of(trace, step, TracePart::losses));
          },
          py::arg("step") = py::none(),
          "Returns branches that were shed or cut in the step: step, why (path of the cause in the document), "
          "position, length (m), segments (n, 2, 3).");
  refuse_new<Trace>("Document.grow(trace=True) records one");
}

}  // namespace meristem::python
