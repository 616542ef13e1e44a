// SPDX-License-Identifier: Apache-2.0
// The web server of the studio: pages and sockets for this machine only.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "host.h"

namespace meristem::studio {

/// The port that is tried first. Browsers keep a page's storage by port.
inline constexpr std::uint16_t kUsualPort = 8413;

struct ServeOptions {
  std::optional<std::uint16_t> port{};  ///< the only port to try, 0: any; unset: the usual port or one of the next
                                        ///< seven
  std::string token{};                  ///< 32 hexadecimal digits; empty: random
  /// Called once when the program is asked to stop, before the sockets close. The program may end without a return from
  /// `serve`, so this function must remove whatever must not outlive the program.
  std::function<void()> on_end{};
};

/// Serves until the program is asked to stop (SIGINT, SIGTERM), and then stops all work. Calls `ready` with the address
/// once the server listens. Throws MachineError if it cannot listen.
void serve(Host& host, const ServeOptions& options, const std::function<void(const std::string& address)>& ready);

}  // namespace meristem::studio
