// SPDX-License-Identifier: Apache-2.0
// Requests for scans from command lines and Python. One table lists their members.
#pragma once

#include <cstdint>

#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The meaning of a request.
struct ScanPlan {
  ScanOptions options{};  ///< instrument, stations and noise
  bool obstacles = true;  ///< whether the scene's visible obstacles are scanned as well
};

const ParameterTable& instrument_table();  ///< table of ScanInstrument
const ParameterTable& scan_table();        ///< table of ScanPlan

/// Reads a request, which is an object of scan_table, or null for no request. `instrument` may be the name of a class.
/// Members that it does not set come from instrument_of. The noise uses `seed` unless the request has one. Throws one
/// InputError with all errors, each with a path within the request, such as instrument.step.
ScanPlan plan_scan(const Value& request, std::uint64_t seed);

/// Returns true if such a scan sees any of the scene's obstacles.
bool sees_obstacles(const Obstacles& obstacles, const ScanPlan& plan);
/// Returns the meshes that such a scan sees: the plant's meshes, and the obstacles if requested.
MeshScene scanned_meshes(MeshScene meshes, const Obstacles& obstacles, const ScanPlan& plan);

}  // namespace meristem
