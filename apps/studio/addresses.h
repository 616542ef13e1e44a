// SPDX-License-Identifier: Apache-2.0
// Checks of the addresses in requests. The checks use names alone and need no socket.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace meristem::studio {

/// Returns 128 secret random bits of the system as 32 hexadecimal digits. Throws MachineError.
std::string secret_token();

/// Returns true if both texts are equal. The time does not depend on where they differ.
bool is_same_secret(std::string_view given, std::string_view secret);

/// Returns true if a Host header names this machine at that port: 127.0.0.1, localhost or [::1].
bool is_own_host(std::string_view host, std::uint16_t port);
/// Returns true if an Origin header names a page of this machine at that port.
bool is_own_origin(std::string_view origin, std::uint16_t port);

/// Returns the part of the target below the token, without a query: "" for "/TOKEN/". Returns nothing if the token is
/// wrong, or if the name has characters other than letters, digits, '.', '-', '_' and '/', or a dot before a name.
std::optional<std::string> name_below_token(std::string_view target, std::string_view token);

/// Returns the media type of a file by its ending.
std::string_view media_type(std::string_view name);

/// Returns the Content-Security-Policy of all answers for pages of that host.
std::string security_policy(std::string_view host);

}  // namespace meristem::studio
