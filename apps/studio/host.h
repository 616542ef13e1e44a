// SPDX-License-Identifier: Apache-2.0
// What all connections to a studio share.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "downloads.h"
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

/// Takes what goes to the page; called from any thread. After the page has gone, calls do nothing.
class Outbox {
 public:
  Outbox() = default;
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  virtual ~Outbox() = default;

  virtual void send_text(std::string message) = 0;
  virtual void send_packet(std::string packet) = 0;
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
