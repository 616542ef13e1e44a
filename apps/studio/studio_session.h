// SPDX-License-Identifier: Apache-2.0
// One page's document: messages in and out, as protocol.md defines them. It uses no sockets.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asked_jobs.h"
#include "grower.h"
#include "host.h"
#include "job_watch.h"
#include "measure_job.h"
#include "meristem/document/edit/session.h"
#include "open_files.h"
#include "readings.h"
#include "request.h"
#include "still_maker.h"

namespace meristem::studio {

/// The name of a job in messages, and its time limit; unset: `job_seconds`.
struct Job {
  const char* name = "";
  std::optional<TimeLimit> time{};
};

/// Only one call at a time is allowed.
class StudioSession {
 public:
  /// Sends `hello`. `host` must outlive this object and all jobs that it has begun. `readings` knows which messages
  /// have arrived but are not handled yet. Null: messages are handled when they arrive.
  StudioSession(Host& host, std::shared_ptr<Outbox> outbox, std::shared_ptr<Readings> readings = nullptr);
  ~StudioSession();
  StudioSession(const StudioSession&) = delete;
  StudioSession& operator=(const StudioSession&) = delete;

  /// Handles one message and sends the reply. Invalid messages produce an error reply, never an exception.
  void receive(std::string_view message);

 private:
  using Answer = Value::Object;
  struct Opened {
    std::string text;
    std::string file;  // absolute path
    std::string root;
    std::optional<std::string> path;  // path below the root
    std::string name;
    std::optional<std::string> saved;
  };

  /// A drag whose reading was stopped because of a newer message.
  struct UnreadDrag {
    double request = 0;
    std::vector<ValueOverride> values;
  };

  void require_rate();
  void refuse(std::optional<double> id, const std::string& message, const Value::Object& members);
  void answer(double id, Answer answer);

  std::optional<Answer> act(double id, const OpenRequest& request);
  std::optional<Answer> act(double id, const SpliceRequest& request);
  std::optional<Answer> act(double id, const TextRequest& request);
  std::optional<Answer> act(double id, const EditRequest& request);
  std::optional<Answer> act(double id, const DragRequest& request);
  std::optional<Answer> act(double id, const ViewRequest& request);
  std::optional<Answer> act(double id, const ShownRequest& request);
  std::optional<Answer> act(double id, const AllRequest& request);
  std::optional<Answer> act(double id, const CancelRequest& request);
  std::optional<Answer> act(double id, const ContinueRequest& request);
  std::optional<Answer> act(double id, const PauseRequest& request);
  std::optional<Answer> act(double id, const FilesRequest& request);
  std::optional<Answer> act(double id, const SaveRequest& request);
  std::optional<Answer> act(double id, const ModelsRequest& request);
  std::optional<Answer> act(double id, const MeasuresRequest& request);
  std::optional<Answer> act(double id, const MeasureRowsRequest& request);
  std::optional<Answer> act(double id, const SweepRequest& request);
  std::optional<Answer> act(double id, const InstanceRequest& request);
  std::optional<Answer> act(double id, const ShootRequest& request);
  std::optional<Answer> act(double id, const StandRequest& request);
  std::optional<Answer> act(double id, const WorkedOutRequest& request);
  std::optional<Answer> act(double id, const CurvesRequest& request);
  std::optional<Answer> act(double id, const CloudRequest& request);
  std::optional<Answer> act(double id, const OperationsRequest& request);
  std::optional<Answer> act(double id, const PartsRequest& request);
  std::optional<Answer> act(double id, const PartRequest& request);
  std::optional<Answer> act(double id, const ExportRequest& request);
  std::optional<Answer> act(double id, const CommandRequest& request);
  std::optional<Answer> act(double id, const StillsRequest& request);
  std::optional<Answer> act(double id, const GrammarRequest& request);
  std::optional<Answer> act(double id, const ClocksRequest& request);
  std::optional<Answer> act(double id, const PictureRequest& request);
  std::optional<Answer> act(double id, const OverlaysRequest& request);

  Opened opened(const OpenRequest& request) const;
  std::string model_text(const std::string& model) const;
  Session& session();
  void require_base(const std::string& base);
  void begin_session(std::string text, std::string file);
  bool read_text(double id, MessageKind kind, Answer& answer);
  void read_now(double id);
  void take_unread_drag();
  void show(bool at_once);
  void watch_file();
  void add_reading(Answer& answer, const Session& read, const std::string& name, const Progress& progress) const;
  template <class Question>
  void ask_grown(double id, Question question);
  template <class Work>
  void run_later(double id, const Job& job, Worker& worker, Work work);
  template <class Work>
  void run_newest(double id, const Job& job, const std::shared_ptr<AskedJobs>& jobs, Worker& worker, Work work);
  void cancel_jobs(std::optional<double> request = {});
  void refuse_cancelled(const std::vector<double>& requests);
  std::shared_ptr<const Document> document_for(double id, const ExportOptions& options);
  std::shared_ptr<const GrownPlant> grown_for(const ExportOptions& options) const;
  std::string name_for(const ExportOptions& options);

  Host& host_;
  const std::shared_ptr<Outbox> outbox_;
  const std::shared_ptr<Grower> grower_;
  const std::shared_ptr<Readings> readings_;
  const std::shared_ptr<AskedJobs> jobs_ = std::make_shared<AskedJobs>();
  // A page waits only for the newest job of each of these kinds.
  const std::shared_ptr<AskedJobs> stills_ = std::make_shared<AskedJobs>();
  const std::shared_ptr<AskedJobs> derivations_ = std::make_shared<AskedJobs>();
  const std::shared_ptr<AskedJobs> sweeps_ = std::make_shared<AskedJobs>();
  const std::shared_ptr<AskedJobs> measures_ = std::make_shared<AskedJobs>();
  std::shared_ptr<StillMaker> still_maker_;  // for the document; only the worker's thread calls it
  std::shared_ptr<SweepMaker> sweep_maker_;  // for the document; only the worker's thread calls it
  std::shared_ptr<OpenFileWatch> watch_;     // watch of the file; null for models and new texts
  std::optional<std::string> watched_;       // path of the watched file
  std::unique_ptr<Session> session_;
  std::string root_;                  // folder that limits the session's files
  std::optional<std::string> path_;   // path below the host's root; unset for models and new texts
  std::optional<std::string> model_;  // the shipped model that was opened
  std::string title_;                 // name of the file or the model
  std::string hash_;                  // hash of the session's text
  std::optional<UnreadDrag> unread_drag_;
  // True: a document was opened, and its growth has not begun
  bool is_opened_ = false;
  std::shared_ptr<const Document> document_;                    // the document that was shown last
  std::deque<std::chrono::steady_clock::time_point> received_;  // times of messages within the last second
};

}  // namespace meristem::studio
