// SPDX-License-Identifier: Apache-2.0
#include "addresses.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>
#include <sys/random.h>

#include "meristem/base/diagnostic.h"

namespace meristem::studio {

namespace {

constexpr std::array<std::string_view, 3> kOwnNames{"127.0.0.1", "localhost", "[::1]"};

bool is_file_name(std::string_view name) {
  char before = '/';
  for (const char letter : name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '_';
    const bool follows_slash = before == '/';
    if (!is_plain && (follows_slash || (letter != '.' && letter != '/'))) return false;
    before = letter;
  }
  return true;
}

}  // namespace

std::string secret_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw MachineError("the system gives no random numbers");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool is_same_secret(std::string_view given, std::string_view secret) {
  if (given.size() != secret.size()) return false;
  unsigned differs = 0;
  for (std::size_t k = 0; k < secret.size(); ++k)
    differs |= static_cast<unsigned>(static_cast<unsigned char>(given[k]) ^ static_cast<unsigned char>(secret[k]));
  return differs == 0;
}

bool is_own_host(std::string_view host, std::uint16_t port) {
  return std::any_of(kOwnNames.begin(), kOwnNames.end(),
                     [&](std::string_view name) { return host == fmt::format("{}:{}", name, port); });
}

bool is_own_origin(std::string_view origin, std::uint16_t port) {
  constexpr std::string_view kScheme = "http://";
  return origin.substr(0, kScheme.size()) == kScheme && is_own_host(origin.substr(kScheme.size()), port);
}

std::optional<std::string> name_below_token(std::string_view target, std::string_view token) {
  target = target.substr(0, target.find('?'));
  if (target.size() < token.size() + 2 || target[0] != '/' || target[token.size() + 1] != '/') return std::nullopt;
  if (!is_same_secret(target.substr(1, token.size()), token)) return std::nullopt;
  const std::string_view name = target.substr(token.size() + 2);
  if (!is_file_name(name)) return std::nullopt;
  return std::string(name);
}

std::string_view media_type(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kTypes{
      {{".html", "text/html; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".mjs", "text/javascript; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".json", "application/json"},
       {".map", "application/json"},
       {".svg", "image/svg+xml"},
       {".txt", "text/plain; charset=utf-8"},
       {".png", "image/png"},
       {".jpg", "image/jpeg"},
       {".ico", "image/x-icon"},
       {".woff2", "font/woff2"},
       {".wasm", "application/wasm"}}};
  for (const auto& [ending, type] : kTypes) {
    if (name.ends_with(ending)) return type;
  }
  return "application/octet-stream";
}

std::string security_policy(std::string_view host) {
  return fmt::format(
      "default-src 'none'; script-src 'self'; worker-src 'self'; style-src 'self' 'unsafe-inline'; "
      "img-src 'self' blob: data:; font-src 'self'; connect-src 'self' ws://{}; base-uri 'none'; "
      "form-action 'none'; frame-ancestors 'none'",
      host);
}

}  // namespace meristem::studio
