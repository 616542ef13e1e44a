// SPDX-License-Identifier: Apache-2.0
// Grows the newest state of a document while the user edits it, and sends packets to the page.
//
// The newest request is grown next, but a growth that has begun is completed and shown first, so that the view keeps
// changing. At most one packet is on its way. The next packet is made from the newest state once the page has shown the
// previous one. While inputs follow each other, packets are drafts: coarser levels of detail of the grown plant. The
// first packet of a large document is a draft, too.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "host.h"
#include "meristem/document/grow.h"
#include "meristem/export/packet/scene_packet.h"
#include "shown_pictures.h"

namespace meristem::studio {

class JobMessages;

/// A state of the document to grow.
struct GrowthRequest {
  std::shared_ptr<const Document> document;
  std::string hash;         ///< hash of its text
  bool is_dragged = false;  ///< true: with values of a drag
};

/// The grown plant of a state.
struct GrownPlant {
  GrowthRequest request;
  double time = 0;                           ///< seconds, of the document
  std::shared_ptr<const Document> document;  ///< the state's document at that time, which has grown
  GrowthView view{};
  Plant plant{};  ///< plant with painted textures
  GrowthTraces traces{};
  std::uint64_t about_triangles = 0;  ///< estimate of the number of all triangles
  /// Number of instances of each component in the document's graph. Empty if nobody will ask for them, as during a
  /// drag.
  std::vector<std::uint64_t> placed{};
};

/// The last grown plant, as a question receives it.
struct LastGrown {
  const GrownPlant& grown;
  const MeshScene* meshes;  ///< meshes of the whole plant; null if they have not been made, as during a drag
  GrowthCache& cache;       ///< cache of that growth
};

/// The parts and the detail of a plant that the page shows.
struct ShownParts {
  std::uint64_t drag_triangles = 60'000;   ///< approximate maximum number of triangles while inputs follow each other
  std::uint64_t rest_triangles = 250'000;  ///< approximate maximum number of triangles afterwards
  bool surface = true;
  bool skeleton = false;
  double time = 0;           ///< time of the document, seconds
  std::optional<int> step;   ///< growth step; unset: the last one
  std::string of{};          ///< id of the component whose plants the step is for; empty: all
  bool is_recorded = false;  ///< whether growth is recorded with everything that overlays show

  /// Returns the growth view for these parts.
  GrowthView view() const;
  bool operator==(const ShownParts&) const = default;
};

/// Grows and shows one page's document. May be called from any thread.
class Grower : public std::enable_shared_from_this<Grower> {
 public:
  /// `host` must outlive this object.
  Grower(Host& host, std::shared_ptr<Outbox> outbox) : host_(host), outbox_(std::move(outbox)) {}

  /// Prepares for another document: stops the running growth, and sends nothing more of the present document.
  void leave();
  /// Begins with another document. The page must already know that it has another document.
  void open(GrowthRequest request);
  /// Sets the state to grow. If `at_once`, as at the end of a drag, a running growth is stopped.
  void want(GrowthRequest request, bool at_once = false);
  /// Sets the parts to show. Inputs that do not change the growth prolong the drafts.
  void set_parts(const ShownParts& parts);
  ShownParts parts() const;
  void acknowledge(std::uint64_t packet);
  /// Makes the next packet a whole scene.
  void send_all();
  /// Stops the running growth. The next request grows again.
  void cancel();
  /// Continues the work that reached the time limit, with the limit once more. Results that were finished before are
  /// reused. Does nothing if no work was stopped, or if another state was requested since.
  void go_on();
  /// Pauses or resumes growth. While paused, no growth begins.
  void pause(bool is_paused);
  /// Sends nothing more and drops all requests. Running work may end later.
  void close();
  /// Calls a question with the last grown plant, on the thread that grows. The argument is null before the first
  /// growth.
  void ask(std::function<void(const LastGrown* last)> question);
  /// Returns the last grown plant, or null before the first growth.
  std::shared_ptr<const GrownPlant> grown() const;

 private:
  using Clock = Worker::Clock;

  /// The content of a packet.
  struct Sight {
    std::shared_ptr<const GrownPlant> grown;
    ShownParts parts;
    bool is_draft = false;

    /// Returns the maximum number of triangles that the page draws.
    std::uint64_t budget() const { return is_draft ? parts.drag_triangles : parts.rest_triangles; }
  };
  /// A content that the page must show, with what else its packet does.
  struct NextView {
    Sight sight;
    bool fits = false;     ///< true: the packet is the first of a document
    bool forgets = false;  ///< true: the packet is a whole scene
  };
  /// The kind of work that reached the time limit.
  enum class Stopped { nothing, growth, meshing };

  void schedule();
  void work();
  void grow();
  void show();
  std::optional<NextView> next_view();
  bool is_shown(const Sight& sight) const;
  template <class Work>
  void run(const std::string& hash, Stopped if_stopped, Work&& work);
  void send_failure(const std::string& hash, const std::string& message, Value::Object members);

  // Used only by the worker's thread.
  std::string packet_of(const NextView& view, JobMessages& messages);
  Value::Object grown_message(const GrownPlant& grown, JobMessages& messages);
  void make_meshes(const Sight& sight, Progress& progress);
  std::shared_ptr<const MeshScene> with_shown_pictures(const GrownPlant& grown);
  const MeshScene& obstacles_of(const GrownPlant& grown, Progress& progress);
  const MeshScene* whole_meshes(const GrownPlant& grown) const;
  Value::Object counts_value(const GrownPlant& grown) const;

  Host& host_;
  const std::shared_ptr<Outbox> outbox_;

  mutable std::mutex mutex_;  // guards the members below
  GrowthRequest request_;
  ShownParts parts_;
  std::uint64_t requested_ = 0;  // number of the newest request
  std::uint64_t done_ = 0;       // number of the last request that has grown or failed
  Clock::time_point last_input_{};
  Clock::time_point last_seen_{};  // time when the page last showed a draft
  std::shared_ptr<const GrownPlant> grown_;
  Sight shown_;
  std::uint64_t awaited_ = 0;  // number of the packet on its way; 0: no packet
  Progress* running_ = nullptr;
  Stopped stopped_ = Stopped::nothing;
  bool is_scheduled_ = false;
  bool is_paused_ = false;
  bool is_closed_ = false;
  bool fits_ = false;      // the next packet is the first of a document
  bool forgets_ = false;   // the next packet must be a whole scene
  bool is_other_ = false;  // another document has come since the last growth

  // Used only by the worker's thread.
  GrowthCache cache_;
  std::array<GrowthCache, 2> mesh_caches_;       // caches of the meshes at rest and of drafts
  std::shared_ptr<const GrownPlant> meshes_of_;  // the plant whose meshes were made last
  std::shared_ptr<const ViewMeshes> meshes_;
  std::vector<std::pair<std::string, double>> stages_;
  std::vector<ReuseCount> grown_reuse_;    // reuse of the last growth, until it is reported
  std::vector<ReuseCount> clothed_reuse_;  // reuse of its last meshes
  Obstacles obstacles_;                    // bodies of the meshes below
  MeshScene obstacle_meshes_;
  ShownPictures pictures_;
  PacketMaker packets_;
};

}  // namespace meristem::studio
