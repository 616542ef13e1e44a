// SPDX-License-Identifier: Apache-2.0
// Fuzzes requests of scans: either errors, or an instrument whose numbers are in range.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "meristem/base/diagnostic.h"
#include "meristem/document/json.h"
#include "meristem/export/scan/scan_request.h"
#include "tests/fuzz/require.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer requires this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meristem;
  try {
    const ScanPlan plan = plan_scan(parse_json({reinterpret_cast<const char*>(data), size}), 1);
    const ScanInstrument& instrument = plan.options.instrument;
    require(instrument.step > 0 && instrument.rays >= 1 && instrument.returns >= 1 && instrument.returns <= 15);
    require(instrument.highest > instrument.lowest && instrument.farthest > instrument.nearest);
    require(plan.options.around >= 1 && std::isfinite(instrument.footprint(10)));
    for (const Vec3 station : plan.options.stations) require(std::isfinite(station.x + station.y + station.z));
  } catch (const InputError& error) {
    require(!error.diagnostics().empty());
  }
  return 0;
}
