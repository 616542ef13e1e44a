// SPDX-License-Identifier: Apache-2.0
// Objects that all connections to a studio share.
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

/// The limits of a studio. Each refusal names its limit by the member's name.
struct StudioLimits {
  std::uint64_t message_bytes = 17'000'000;  ///< maximum size of one message of the page
  int messages_per_second = 200;
  double job_seconds = 60;     ///< time for one growth, export or measurement; a sweep has this time for each of its
                               ///< plants
  double film_seconds = 7200;  ///< time for one film, or for pictures of many times
  std::uint64_t memory_bytes = 6'000'000'000;  ///< memory of the whole program while a job runs
  int connections = 8;
};

/// Sends messages to the page. May be called from any thread. Calls after the page has closed do nothing.
class Outbox {
 public:
  Outbox() = default;
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  virtual ~Outbox() = default;

  /// Sends a text. Bytes that are not UTF-8 become U+FFFD, because browsers close a connection that sends such a byte.
  void send_text(std::string message) { deliver_text(with_valid_utf8(std::move(message))); }
  void send_packet(std::string packet) { deliver_packet(std::move(packet)); }

 private:
  /// `message` is UTF-8.
  virtual void deliver_text(std::string message) = 0;
  virtual void deliver_packet(std::string packet) = 0;
};

/// Objects that exist once for all connections, and outlive them.
struct Host {
  const Registry& registry;
  RootFolder root;
  std::string models_folder;
  std::optional<std::string> document{};  ///< path, below the root, of the document that pages open first
  std::optional<std::string> model{};     ///< name of the shipped model that pages open first instead
  std::string command = "meristem";       ///< name of the program in its command line
  StudioLimits limits{};
  std::chrono::milliseconds still_after{120};               ///< time after the last input until full detail is shown
  bool (*has_picture)(const std::string& model) = nullptr;  ///< returns true if a model has a picture; null: no model
                                                            ///< has one
  Downloads downloads{};
  Worker growth{};
  Worker exports{};
  Worker films{};   ///< films, which take minutes, while everything else continues
  Worker stills{};  ///< stills, and all other requests while a plant grows
};

}  // namespace meristem::studio
