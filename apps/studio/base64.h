// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace meristem::studio {

/// Bytes as letters of the base 64, filled up with = to fours, as JSON can hold them (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace meristem::studio
