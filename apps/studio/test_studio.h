// SPDX-License-Identifier: Apache-2.0
// A studio with one page, for tests of their messages.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/json.h"
#include "protocol/conversation.h"
#include "refusal.h"
#include "studio_session.h"
#include "tests/support/shown_scene.h"
#include "tests/support/temporary_folder.h"

namespace meristem::studio {

namespace fs = std::filesystem;

inline const std::string kBush = R"json({
  "meristem": 1,
  "variables": {"size": {"value": 0.1, "min": 0, "max": 1}},  // "\u00e9\ud83c\udf33"
  "components": {
    "stem": {"type": "tree", "length": 1.5, "radius": 0.01},
    "leaf": {"type": "leaf", "length": "size", "width": 0.03, "colour": "#337722"}
  },
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 40}]
}
)json";

/// Collects the messages to the page, in order. Each message must be as the protocol describes it.
class Mailbox : public Outbox {
 public:
  /// Records the name of a request, whose answer is compared with its description.
  void expect_answer(double id, const std::string& name) {
    const std::lock_guard lock(mutex_);
    conversation_.take(Value::Object{{"do", name}, {"id", id}});
  }
  /// Returns the names of the requests that were answered and not refused.
  std::set<std::string> answered() {
    const std::lock_guard lock(mutex_);
    return conversation_.answered();
  }
  /// Returns the first message for which `holds` is true. Waits for it if necessary.
  template <class Holds>
  Value wait_for(Holds holds) {
    std::unique_lock lock(mutex_);
    for (std::size_t k = 0;; ++k) {
      while (k >= texts_.size()) {
        if (arrived_.wait_for(lock, std::chrono::seconds(60)) == std::cv_status::timeout)
          throw std::runtime_error("silence");
      }
      if (holds(texts_[k])) return texts_[k];
    }
  }
  Value answer(double id) {
    return wait_for([id](const Value& message) {
      const Value* re = message.find("re");
      return re != nullptr && re->number() != nullptr && *re->number() == id &&
             *message.find("is")->text() != "working";
    });
  }
  /// Returns the packet of an answer that came as a packet.
  std::string packed_answer(double id) {
    const std::lock_guard lock(mutex_);
    return packed_answers_.at(id);
  }
  std::string packet(std::size_t k) {
    std::unique_lock lock(mutex_);
    while (k >= packets_.size()) {
      if (arrived_.wait_for(lock, std::chrono::seconds(60)) == std::cv_status::timeout)
        throw std::runtime_error("no packet");
    }
    return packets_[k];
  }
  std::size_t packet_count() {
    const std::lock_guard lock(mutex_);
    return packets_.size();
  }

 private:
  void deliver_text(std::string message) override {
    const std::lock_guard lock(mutex_);
    texts_.push_back(parse_json(message));
    check(texts_.back());
    arrived_.notify_all();
  }
  void deliver_packet(std::string packet) override {
    const std::lock_guard lock(mutex_);
    if (packet.starts_with("MSA1")) {
      texts_.push_back(ReadPacket(packet, "MSA1").head);
      check(texts_.back());
      packed_answers_[*texts_.back().find("re")->number()] = std::move(packet);
    } else {
      check(ReadPacket(packet).head);
      packets_.push_back(std::move(packet));
    }
    arrived_.notify_all();
  }

  /// Answers to requests that were not recorded cannot be compared.
  void check(const Value& message) {
    const Value* re = message.find("re");
    const Value* is = message.find("is");
    if (is != nullptr && *is == Value("done") && !conversation_.knows(*re->number())) return;
    try {
      conversation_.take(message);
    } catch (const Refusal& refusal) {
      ADD_FAILURE() << refusal.what() << " in " << write_json_line(message).substr(0, 1000);
    }
  }

  std::mutex mutex_;
  std::condition_variable arrived_;
  Conversation conversation_;
  std::vector<Value> texts_;
  std::vector<std::string> packets_;
  std::map<double, std::string> packed_answers_;  // by the number of the request
};

/// A studio with one page, which takes over packets as the page does.
class Studio {
 public:
  explicit Studio(std::chrono::milliseconds still = std::chrono::milliseconds(0)) {
    std::ofstream(folder_ / "bush.json") << kBush;
    host_.still_after = still;
    host_.limits.messages_per_second = 100'000;
  }

  Host& host() { return host_; }
  const fs::path& folder() const { return folder_.path(); }
  Mailbox& mailbox() { return *mailbox_; }
  StudioSession& page() {
    if (!page_) page_.emplace(host_, mailbox_);
    return *page_;
  }

  /// Sends a request and returns its answer. `members` are the request's members in JSON.
  Value ask(const std::string& what, const std::string& members = "") { return mailbox_->answer(send(what, members)); }
  /// Sends a request and returns its number.
  double send(const std::string& what, const std::string& members = "") {
    page().receive(request(what, members));
    return id_;
  }
  std::string request(const std::string& what, const std::string& members) {
    mailbox_->expect_answer(++id_, what);
    return "{\"do\": \"" + what + "\", \"id\": " + std::to_string(id_) + (members.empty() ? "" : ", ") + members + "}";
  }
  Value open_bush() { return open(R"("path": "bush.json")"); }
  /// Opens a document. `members` are the members of the request.
  Value open(const std::string& members) {
    const Value answer = ask("open", members);
    hash_ = text_of(answer, "hash");
    return answer;
  }
  /// Inserts a text, as a user types it.
  Value type(std::size_t offset, const std::string& text) {
    const Value answer = ask("splice", "\"base\": \"" + hash_ + "\", \"patch\": [[" + std::to_string(offset) + ", 0, " +
                                           write_json_line(Value(text)) + "]]");
    if (answer.find("hash") != nullptr) hash_ = text_of(answer, "hash");
    return answer;
  }
  /// Saves the document. `saved` is the hash of the existing file; empty if no file exists.
  Value save(const std::string& path, const std::string& saved) {
    return ask("save", "\"path\": " + write_json_line(Value(path)) + ", \"hash\": \"" + hash_ +
                           "\", \"saved\": " + (saved.empty() ? "null" : "\"" + saved + "\""));
  }
  /// Returns the bytes of a file in the folder.
  std::string content(const std::string& path) const {
    std::ifstream file(folder() / path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Opens a bush with about 400,000 triangles. Returns the hash of its text.
  std::string open_large_bush() {
    std::string text = kBush;
    text.replace(text.find("\"count\": 40"), 11, "\"count\": 20000");
    std::ofstream(folder_ / "large.json") << text;
    return text_of(ask("open", R"("path": "large.json")"), "hash");
  }
  Value edit(const std::string& edits) {
    const Value answer = ask("edit", "\"base\": \"" + hash_ + "\", \"edits\": " + edits);
    if (answer.find("hash") != nullptr) hash_ = text_of(answer, "hash");
    return answer;
  }
  /// Takes over packets until one at rest shows the text with this hash.
  ReadPacket show(const std::string& hash) {
    for (;;) {
      last_ = mailbox_->packet(taken_++);
      scene_.apply(last_);
      const ReadPacket packet(last_);
      ask("shown", "\"packet\": " + std::to_string(static_cast<int>(packet.number("packet"))));
      if (!packet.flag("draft") && *packet.head.find("hash")->text() == hash) return packet;
    }
  }
  ReadPacket show() { return show(hash_); }
  const ShownScene& scene() const { return scene_; }
  std::size_t taken() const { return taken_; }
  const std::string& last_packet() const { return last_; }
  const std::string& hash() const { return hash_; }

  static std::string text_of(const Value& message, const char* name) {
    const Value* member = message.find(name);
    return member != nullptr && member->text() != nullptr ? *member->text() : "";
  }

 private:
  TemporaryFolder folder_;
  Host host_{.registry = builtin_components(),
             .root = RootFolder(folder_.path().string()),
             .models_folder = MERISTEM_SOURCE_DIR "/models"};
  std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
  std::optional<StudioSession> page_;
  ShownScene scene_;
  std::string hash_;
  std::string last_;
  std::size_t taken_ = 0;
  int id_ = 0;
};

inline bool is_refused(const Value& answer) { return Studio::text_of(answer, "is") == "refused"; }

}  // namespace meristem::studio
