// SPDX-License-Identifier: Apache-2.0
/// Checks of the arguments of library functions.
#pragma once

#include <stdexcept>

namespace meristem {

/// Throws std::invalid_argument with `message` if `holds` is false. For mistakes of programs that call the library.
/// Errors in what a user has written are an InputError with a path.
inline void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

}  // namespace meristem
