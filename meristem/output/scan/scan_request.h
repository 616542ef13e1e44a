// SPDX-License-Identifier: Apache-2.0
// Requests for scans, as command lines and Python make them: one table says what is in them.
#pragma once

#include <cstdint>

#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// What a request means.
struct ScanPlan {
  ScanOptions options{};  ///< instrument, stations and noise
  bool obstacles = true;  ///< whether the scene's visible obstacles are seen as well
};

const ParameterTable& instrument_table();  ///< of Instrument
const ParameterTable& scan_table();        ///< of ScanPlan

/// Reads a request, an object of scan_table or null for none. `instrument` may be a class by its name; what it does not
/// say is as in instrument_of. The noise has `seed` unless the request has one. Throws one InputError with all faults,
/// each with a path from the request on, such as instrument.step.
ScanPlan plan_scan(const Value& request, std::uint64_t seed);

/// Whether such a scan sees any of the scene's obstacles.
bool sees_obstacles(const Obstacles& obstacles, const ScanPlan& plan);
/// The meshes that such a scan sees: those of the plant, and the obstacles if they are wanted.
MeshScene scanned_meshes(MeshScene meshes, const Obstacles& obstacles, const ScanPlan& plan);

}  // namespace meristem
