// SPDX-License-Identifier: Apache-2.0
// Grows the newest state of a document beside the editing of it, and sends what is to be shown.
//
// The newest wish wins without starving: a growth in hand ends, is shown, and then the newest wish is taken. At most
// one packet is on its way; the next is made, of the newest state alone, once the page says that it shows the one
// before. While inputs follow each other, packets are drafts, coarser levels of detail of what has grown. The first
// packet of a large document is a draft, too.
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
#include "meristem/output/packet/scene_packet.h"
#include "shown_pictures.h"

namespace meristem::studio {

class JobNews;

/// A state of the document.
struct Wish {
  std::shared_ptr<const Document> document;
  std::string hash;         ///< of its text
  bool is_dragged = false;  ///< with values of a drag
};

/// What has grown of it.
struct GrownWish {
  Wish wish;
  double time = 0;                           ///< seconds, of the document
  std::shared_ptr<const Document> document;  ///< the wish's as it stands at that time: it is what has grown
  GrowthView view{};
  Plant plant{};  ///< painted
  GrowthTraces traces{};
  std::uint64_t about_triangles = 0;  ///< estimate for all there is
  /// Instances of each component of the document's graph; empty where nobody will ask, as in a drag.
  std::vector<std::uint64_t> placed{};
};

/// What has grown last, as a question finds it.
struct LastGrown {
  const GrownWish& grown;
  const MeshScene* meshes;  ///< all of its meshes; null where they have not been made, as in a drag
  GrowthCache& cache;       ///< of that growth
};

/// What of a plant the page wants to see.
struct ShownParts {
  std::uint64_t drag_triangles = 60'000;   ///< about the most triangles while inputs follow each other
  std::uint64_t rest_triangles = 250'000;  ///< about the most triangles afterwards
  bool surface = true;
  bool skeleton = false;
  double time = 0;           ///< seconds, of the document
  std::optional<int> step;   ///< of growth; unset: the last
  std::string of{};          ///< id of the component whose plants the step is for; empty: all
  bool is_recorded = false;  ///< growth is recorded, with all that overlays show of it

  /// What grows for these parts.
  GrowthView view() const;
  bool operator==(const ShownParts&) const = default;
};

/// Calls from any thread.
class Grower : public std::enable_shared_from_this<Grower> {
 public:
  /// `host` outlives it.
  Grower(Host& host, std::shared_ptr<Outbox> outbox) : host_(host), outbox_(std::move(outbox)) {}

  /// Another document will be opened: what is in hand is dropped, and nothing of this one is sent any more.
  void leave();
  /// The other document; the page has been told of it, and forgets what it shows.
  void open(Wish wish);
  /// `at_once` where the hand has let go: what is in hand is dropped.
  void want(Wish wish, bool at_once = false);
  /// An input that does not change what grows keeps drafts going.
  void set_parts(const ShownParts& parts);
  ShownParts parts() const;
  void acknowledge(std::uint64_t packet);
  /// Has the next packet be a whole scene.
  void send_all();
  /// Drops the growth in hand; the next wish grows again.
  void cancel();
  /// Goes on with the work that reached the time limit, with another such time. Finds what was finished before. Does
  /// nothing if no work was stopped, or if something else was wanted since.
  void go_on();
  /// While paused nothing begins to grow.
  void pause(bool is_paused);
  /// Sends nothing any more and drops all. What is in hand may end later.
  void close();
  /// Has the thread that grows look at what has grown last; null before anything has.
  void ask(std::function<void(const LastGrown* last)> question);
  /// The last that has grown; null before.
  std::shared_ptr<const GrownWish> grown() const;

 private:
  using Clock = Worker::Clock;

  /// What a packet showed.
  struct Sight {
    std::shared_ptr<const GrownWish> grown;
    ShownParts parts;
    bool is_draft = false;

    /// Triangles that the page draws.
    std::uint64_t budget() const { return is_draft ? parts.drag_triangles : parts.rest_triangles; }
  };
  /// What reached the time limit.
  enum class Stopped { nothing, growth, meshing };

  void schedule();
  void work();
  void grow();
  void show();
  bool is_shown(const Sight& sight) const;
  template <class Work>
  void run(const std::string& hash, Stopped if_stopped, Work&& work);
  void send_failure(const std::string& hash, const std::string& message, Value::Object members);

  // What the worker's thread alone reads and writes.
  void make_meshes(const Sight& sight, Progress& progress);
  std::shared_ptr<const MeshScene> with_shown_pictures(const GrownWish& grown);
  const MeshScene& obstacles_of(const GrownWish& grown, Progress& progress);
  const MeshScene* whole_meshes(const GrownWish& grown) const;
  Value::Object counts_value(const GrownWish& grown) const;

  Host& host_;
  const std::shared_ptr<Outbox> outbox_;

  mutable std::mutex mutex_;  // of these
  Wish wish_;
  ShownParts parts_;
  std::uint64_t wished_ = 0;  // number of the wish
  std::uint64_t done_ = 0;    // of the last that has grown, or will not
  Clock::time_point last_input_{};
  Clock::time_point last_seen_{};  // when a draft was last seen
  std::shared_ptr<const GrownWish> grown_;
  Sight shown_;
  std::uint64_t awaited_ = 0;  // the packet on its way; 0: none
  Progress* running_ = nullptr;
  Stopped stopped_ = Stopped::nothing;
  bool is_scheduled_ = false;
  bool is_paused_ = false;
  bool is_closed_ = false;
  bool fits_ = false;      // the next packet is the first of a document
  bool forgets_ = false;   // the next packet is a whole scene
  bool is_other_ = false;  // another document has come since the last growth

  // What the worker's thread alone reads and writes.
  GrowthCache cache_;
  std::array<GrowthCache, 2> mesh_caches_;      // of what is shown at rest and of drafts
  std::shared_ptr<const GrownWish> meshes_of_;  // whose meshes were made last
  std::shared_ptr<const ViewMeshes> meshes_;
  std::vector<std::pair<std::string, double>> stages_;
  std::vector<ReuseCount> grown_reuse_;    // of the last growth, until it is told
  std::vector<ReuseCount> clothed_reuse_;  // of its last meshes
  Obstacles obstacles_;                    // whose meshes these are
  MeshScene obstacle_meshes_;
  ShownPictures pictures_;
  PacketMaker packets_;
};

}  // namespace meristem::studio
