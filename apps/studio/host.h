// SPDX-License-Identifier: Apache-2.0
// What all connections to a studio share.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "downloads.h"
#include "meristem/base/utf8.h"
#include "meristem/graph/component.h"
#include "root_folder.h"
#include "worker.h"

namespace meristem::studio {

/// What a studio bears; each refusal names its limit as it is called here.
struct StudioLimits {
  std::uint64_t message_bytes = 17'000'000;  ///< of one message of the page
  int messages_per_second = 200;
  double job_seconds = 60;     ///< for one growth, export or measurement; a sweep has them for each of its plants
  double film_seconds = 7200;  ///< for one film, or pictures of many times
  std::uint64_t memory_bytes = 6'000'000'000;  ///< of the whole program, while a job runs
  int connections = 8;
};

/// Sends messages to the page. Called from any thread; after the page has gone, calls do nothing.
class Outbox {
 public:
  Outbox() = default;
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  virtual ~Outbox() = default;

  /// Sends a text. A byte that is not UTF-8 becomes U+FFFD: browsers close a connection that sends such a byte.
  void send_text(std::string message) { deliver_text(with_valid_utf8(std::move(message))); }
  void send_packet(std::string packet) { deliver_packet(std::move(packet)); }

 private:
  /// `message` is UTF-8.
  virtual void deliver_text(std::string message) = 0;
  virtual void deliver_packet(std::string packet) = 0;
};

/// What there is once for all connections. It outlives them.
struct Host {
  const Registry& registry;
  RootFolder root;
  std::string models_folder;
  std::optional<std::string> document{};  ///< below the root: what pages open first
  std::optional<std::string> model{};     ///< or the shipped model
  std::string command = "meristem";       ///< how the program is called
  StudioLimits limits{};
  std::chrono::milliseconds still_after{120};               ///< after the last input there is full detail
  bool (*has_picture)(const std::string& model) = nullptr;  ///< null: no model has one
  Downloads downloads{};
  Worker growth{};
  Worker exports{};
  Worker films{};   ///< which take minutes, while everything else goes on
  Worker stills{};  ///< and all else that a page asks for while a plant grows
};

}  // namespace meristem::studio
