// SPDX-License-Identifier: Apache-2.0
// Exports a film or numbered pictures. The last frame is grown first, to place the camera. Frames are then drawn in
// order into a scratch folder, and ffmpeg joins the pictures of a film.
#include "film_job.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "apps/film/film.h"
#include "apps/film/frames.h"
#include "meristem/document/grow.h"
#include "meristem/export/picture/picture.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/write/picture_file.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

film::FrameTimes times_of(const ExportOptions& options, const Document& document) {
  if (options.frames) return *options.frames;
  if (!document.graph.animation)
    throw Refusal("the document has no animation, which would say how long a film of it is");
  const Animation& animation = *document.graph.animation;
  return film::frame_times(animation.length, animation.fps);
}

/// Draws pictures of a document at several times. Results that do not depend on time are made once.
class FrameTaker {
 public:
  FrameTaker(const ExportSource& source, const ExportOptions& options, Progress& progress)
      : document_(*source.document), options_(options), progress_(progress), still_(still_of(options, document_)) {}

  const StillOptions& still() const { return still_; }

  /// Moves the camera until it shows the whole plant at that time.
  void place_camera(double time) {
    grow_at(time);
    last_ = std::move(grown_.meshes);
    view_ = placed_view(last_, view_of(options_, now()), aspect());
  }

  void take(double time, const std::string& path) {
    grow_at(time);
    const bool may_move = document_.at_time != nullptr && !options_.camera;
    const CameraView view = may_move ? placed_view(last_, view_of(options_, now()), aspect()) : view_;
    write_picture(take_picture(grown_, now().graph.limits, now().scene, {.still = still_, .view = view}, progress_),
                  path, {});
  }

 private:
  double aspect() const { return static_cast<double>(still_.width) / still_.height; }
  const Document& now() const { return other_ ? *other_ : document_; }

  void grow_at(double time) {
    other_.reset();
    const Document& document = document_at(document_, time, other_, &progress_);
    grown_ = grow_document(document, progress_, {.time = time, .cache = &cache_});
  }

  const Document& document_;
  const ExportOptions& options_;
  Progress& progress_;
  StillOptions still_;
  CameraView view_;
  MeshScene last_;  // the plant that the camera shows as a whole
  GrowthCache cache_;
  std::optional<Document> other_;
  GrownDocument grown_;
};

}  // namespace

Value export_frames(const ExportSource& source, const ExportOptions& options, Downloads& downloads,
                    JobMessages& messages) {
  const film::FrameTimes times = times_of(options, *source.document);
  const std::size_t count = times.count();
  FrameTaker taker(source, options, messages.progress());
  const bool is_film = film::is_film(options.format);
  if (is_film) film::check_film(source.name + options.format, taker.still().width, taker.still().height);
  const std::unique_ptr<Downloads::Draft> draft = downloads.begin();
  const std::string path = (fs::path(draft->path()) / (source.name + options.format)).string();

  std::vector<std::string> paths;
  const std::string pictures = (fs::path(draft->path()) / "frames").string();
  if (is_film) {
    fs::create_directories(pictures);
    for (std::size_t k = 0; k < count; ++k) paths.push_back(film::frame_path(pictures, k));
  } else {
    paths = film::frame_paths(path, static_cast<int>(count));
  }
  messages.begin_part("frame", 0, count);
  taker.place_camera(times.at(count - 1));
  for (std::size_t k = 0; k < count; ++k) {
    messages.begin_part("frame", k, count);
    taker.take(times.at(k), paths[k]);
  }
  if (is_film) film::make_film(pictures, count, 1 / times.step, path, messages.progress());
  return made_file(downloads, *draft,
                   is_film ? fs::path(path).filename().string() : fs::path(paths[0]).filename().string(), source.name,
                   messages.progress());
}

}  // namespace meristem::studio
