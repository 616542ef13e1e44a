// SPDX-License-Identifier: Apache-2.0
#include "job_messages.h"

#include "meristem/document/json.h"

namespace meristem::studio {

namespace {

constexpr std::chrono::milliseconds kBetweenMessages{100};

}  // namespace

JobMessages::JobMessages(std::shared_ptr<Outbox> outbox, std::string job, std::optional<double> request)
    : outbox_(std::move(outbox)),
      job_(std::move(job)),
      request_(request),
      progress_([this](std::string_view stage, double share) { look(stage, share); }) {}

JobMessages::~JobMessages() {
  if (has_sent_) send(std::nullopt, 1);
}

void JobMessages::begin_part(std::string what, std::size_t part, std::size_t parts) {
  part_share_ = static_cast<double>(part) / static_cast<double>(parts);
  part_ = std::move(what) + " " + std::to_string(part + 1) + " of " + std::to_string(parts);
}

void JobMessages::look(std::string_view stage, double share) {
  const Clock::time_point now = Clock::now();
  if (begins_.empty() || begins_.back().first != stage) begins_.emplace_back(stage, now);
  if (now - sent_ < kBetweenMessages) return;
  sent_ = now;
  has_sent_ = true;
  send(part_.empty() ? stage : std::string_view(part_), part_.empty() ? share : part_share_);
}

void JobMessages::send(std::optional<std::string_view> stage, double share) {
  Value::Object message{{"is", "working"}, {"job", job_}};
  if (request_) message.emplace_back("re", *request_);
  message.emplace_back("stage", stage ? Value(std::string(*stage)) : Value());
  message.emplace_back("share", share);
  outbox_->send_text(write_json_line(message));
}

std::vector<std::pair<std::string, double>> JobMessages::stages() const {
  std::vector<std::pair<std::string, double>> stages;
  for (std::size_t k = 0; k < begins_.size(); ++k) {
    const Clock::time_point end = k + 1 < begins_.size() ? begins_[k + 1].second : Clock::now();
    stages.emplace_back(begins_[k].first, std::chrono::duration<double, std::milli>(end - begins_[k].second).count());
  }
  return stages;
}

}  // namespace meristem::studio
