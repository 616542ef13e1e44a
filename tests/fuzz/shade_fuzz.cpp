// SPDX-License-Identifier: Apache-2.0
// Fuzzes days, hours, dates and clock times: either values in range that are equal after writing and reading, or an
// error.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "meristem/base/diagnostic.h"
#include "meristem/export/shade/shade_request.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meristem;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto date = parse_date(text)) require(date_text(*date) == text);
  if (const auto hour = parse_clock_hour(text)) require(*hour >= 0 && *hour <= 24);
  try {
    for (const ShadeDay& day : parse_shade_days(text)) {
      require(day.day >= 1 && day.day <= 366 && (!day.date || day_of_year(*day.date) == day.day));
    }
  } catch (const InputError& error) {
    require(!error.diagnostics().empty() && error.diagnostics()[0].path == "days");
  }
  try {
    for (const double hour : parse_shade_hours(text)) require(hour >= 0 && hour <= 24);
  } catch (const InputError& error) {
    require(!error.diagnostics().empty() && error.diagnostics()[0].path == "hours");
  }
  return 0;
}
