// SPDX-License-Identifier: Apache-2.0
// Fuzzes messages of the studio's page. In a text, the bytes before the end of the first line are the document, so that
// splices are applied to all kinds of texts.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "refusal.h"
#include "request.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meristem;
  using namespace meristem::studio;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t line = all.find('\n');
  const std::string_view message = all.substr(line == std::string_view::npos ? 0 : line + 1);
  const std::string text(all.substr(0, line == std::string_view::npos ? 0 : line));
  try {
    const NumberedRequest read = read_request(message);
    require(request_id(message) == read.id);
    if (const auto* splice = std::get_if<SpliceRequest>(&read.request)) {
      const TextPatch patch = in_bytes(text, splice->patch);
      require(is_sound(patch, text.size()));
      const std::string edited = apply_patch(text, patch);
      require(apply_patch(edited, inverse_patch(text, patch)) == text);
      require(in_bytes(text, in_units(text, patch)) == patch);
    }
  } catch (const Refusal& refusal) {
    require(refusal.what()[0] != '\0');
  } catch (const std::invalid_argument&) {
  }
  text_hash(text);
  return 0;
}
