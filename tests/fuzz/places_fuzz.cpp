// SPDX-License-Identifier: Apache-2.0
// Fuzzes tables: each is either rejected with a place, or has a cell for every row and column.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "meristem/base/diagnostic.h"
#include "meristem/components/parts/place_table.h"
#include "require.h"

namespace meristem {

static void read(const std::string& text) {
  ParameterReader reader({}, SizeLimits{});
  std::vector<Diagnostic> warnings;
  try {
    const PlaceTable places = read_place_table(text, "fuzz.csv", reader, warnings);
    for (const TextTable::Column& column : places.table.columns) {
      const std::size_t cells = column.has_numbers() ? column.numbers.size() : column.texts.size();
      require(cells == places.table.row_count());
      for (const std::uint32_t text_number : column.texts) {
        require(text_number < column.distinct.size());
      }
    }
    for (std::size_t row = 0; row < places.table.row_count(); ++row) {
      const Vec3 position = places.position(row, places.middle);
      require(!std::isnan(position.x) && !std::isnan(position.y) && !std::isnan(position.z));
    }
  } catch (const InputError& error) {
    require(!error.diagnostics().empty());
  }
}

}  // namespace meristem

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  meristem::read(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
