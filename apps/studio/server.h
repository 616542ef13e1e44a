// SPDX-License-Identifier: Apache-2.0
// The studio's door to a browser: pages and sockets on this machine alone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "host.h"

namespace meristem::studio {

/// The port that is tried first; browsers keep a page's storage by it.
inline constexpr std::uint16_t kUsualPort = 8413;

struct ServeOptions {
  std::optional<std::uint16_t> port{};  ///< this one alone, 0: any; unset: the usual one or one of the next seven
  std::string token{};                  ///< 32 hexadecimal digits; empty: drawn anew
  /// Called once when the program is asked to stop, before the sockets close. The program may end without a return from
  /// `serve`, so this must remove what must not outlive the program.
  std::function<void()> on_end{};
};

/// Serves until the program is asked to stop (SIGINT, SIGTERM), and then ends what was begun. `ready` is told the
/// address once it listens. Throws MachineError where it cannot listen.
void serve(Host& host, const ServeOptions& options, const std::function<void(const std::string& address)>& ready);

}  // namespace meristem::studio
