// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/version.h"

namespace meristem {

std::string_view version() { return MERISTEM_VERSION; }

}  // namespace meristem
