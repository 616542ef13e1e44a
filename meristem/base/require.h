// SPDX-License-Identifier: Apache-2.0
/// Checks of the arguments of library functions.
#pragma once

#include <stdexcept>

namespace meristem {

/// Throws std::invalid_argument with `message` unless `holds`: the mistake of a program that calls the library. Faults
/// of what a user has written are an InputError with their path.
inline void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

}  // namespace meristem
