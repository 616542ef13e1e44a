// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace meristem::studio {

/// The line of protocol.md behind which the page is made from the description of the protocol.
inline constexpr const char* kReferenceBegin =
    "<!-- `meristem_studio_protocol` writes the rest of this page from the tables in apps/studio/protocol. -->\n";

/// Returns the reference of all messages, which follows kReferenceBegin.
std::string protocol_reference();

}  // namespace meristem::studio
