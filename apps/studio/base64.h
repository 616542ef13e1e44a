// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace meristem::studio {

/// Returns bytes in base 64, padded with = (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace meristem::studio
