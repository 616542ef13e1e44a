// SPDX-License-Identifier: Apache-2.0
// Who may ask for what: decided by names alone, without a socket.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace meristem::studio {

/// 128 bits from the system's source of secrets as 32 hexadecimal digits. Throws MachineError.
std::string secret_token();

/// Whether they are equal, in a time that does not tell where they differ.
bool is_same_secret(std::string_view given, std::string_view secret);

/// Whether a Host header is this machine's own at that port: 127.0.0.1, localhost or [::1].
bool is_own_host(std::string_view host, std::uint16_t port);
/// Whether an Origin header is one of a page from there.
bool is_own_origin(std::string_view origin, std::uint16_t port);

/// What is asked for below the token: "" for "/TOKEN/", without a query. Nothing where the token is not the one, or the
/// name has other characters than letters, digits, '.', '-', '_' and '/', or a dot before a name.
std::optional<std::string> name_below_token(std::string_view target, std::string_view token);

/// The media type of a file by its ending.
std::string_view media_type(std::string_view name);

/// The Content-Security-Policy of all answers, for a page of that host.
std::string security_policy(std::string_view host);

}  // namespace meristem::studio
