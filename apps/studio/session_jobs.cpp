// SPDX-License-Identifier: Apache-2.0
// Handles requests with a later answer, which comes from a job or from the thread that grows.
#include <filesystem>
#include <new>
#include <type_traits>
#include <utility>

#include "clock_values.h"
#include "cloud_value.h"
#include "curve_values.h"
#include "export_job.h"
#include "film_job.h"
#include "grammar_job.h"
#include "instance_value.h"
#include "job_messages.h"
#include "job_watch.h"
#include "meristem/base/large_memory.h"
#include "meristem/base/visible_text.h"
#include "meristem/document/json.h"
#include "operation_values.h"
#include "overlays_value.h"
#include "refusal.h"
#include "studio_session.h"
#include "thumbnail.h"
#include "written_values.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

std::string refused_text(double id, const std::string& message, const Value::Object& members) {
  Value::Object refusal{{"is", "refused"}, {"re", id}, {"message", visible_lines(message)}};
  for (const auto& member : members) refusal.push_back(member);
  return write_json_line(refusal);
}

/// The member of an answer that is sent as a packet, with its arrays.
struct PackedMember {
  Value::Member member;
  PacketArrays arrays;
};

void send_done(Outbox& outbox, Value::Object done, Value::Member member) {
  done.push_back(std::move(member));
  outbox.send_text(write_json_line(done));
}

void send_done(Outbox& outbox, Value::Object done, PackedMember packed) {
  done.push_back(std::move(packed.member));
  outbox.send_packet(packet_bytes("MSA1", done, packed.arrays));
}

/// Answers a request with the result of `work`, or with the reason for its failure. Work with many parts, such as a
/// film or a sweep, gets the JobMessages; other work gets its progress.
template <class Work>
void answer_by(Host& host, const std::shared_ptr<Outbox>& outbox, AskedJobs& jobs, const AskedJobs::Job& asked,
               const Job& job, Work& work) {
  constexpr bool kHasParts = std::is_invocable_v<Work&, Host&, JobMessages&>;
  const double id = asked->request;
  JobMessages messages(outbox, job.name, id);
  if (!jobs.begin(asked, messages.progress())) return;
  JobWatch watch(messages.progress(), host.limits, job.time);
  try {
    Value::Object done{{"is", "done"}, {"re", id}};
    if constexpr (kHasParts) {
      send_done(*outbox, std::move(done), work(host, messages));
    } else {
      send_done(*outbox, std::move(done), work(host, messages.progress()));
    }
  } catch (const Cancelled&) {
    const std::optional<Refusal> limit = watch.reached();
    outbox->send_text(limit ? refused_text(id, limit->what(), limit->members())
                            : refused_text(id, "cancelled", {{"cancelled", true}}));
  } catch (const InputError& error) {
    outbox->send_text(refused_text(id, error.what(), {{"faults", errors_value(error.diagnostics(), {}, "")}}));
  } catch (const std::bad_alloc&) {
    outbox->send_text(refused_text(id, "there is not enough memory (memory_bytes)", {{"limit", "memory_bytes"}}));
  } catch (const std::exception& error) {
    outbox->send_text(refused_text(id, error.what(), {}));
  }
  jobs.end(asked);
}

}  // namespace

/// Answers the request by a job.
template <class Work>
void StudioSession::run_later(double id, const Job& job, Worker& worker, Work work) {
  worker.post([&host = host_, outbox = outbox_, jobs = jobs_, asked = jobs_->ask(id), job,
               work = std::move(work)]() mutable { answer_by(host, outbox, *jobs, asked, job, work); });
}

/// Answers the request by a job, unless a newer request of its kind replaces it.
template <class Work>
void StudioSession::run_newest(double id, const Job& job, const std::shared_ptr<AskedJobs>& jobs, Worker& worker,
                               Work work) {
  refuse_cancelled(jobs->cancel());
  worker.post([&host = host_, outbox = outbox_, jobs, asked = jobs->ask(id), job, work = std::move(work)]() mutable {
    answer_by(host, outbox, *jobs, asked, job, work);
  });
}

/// Cancels the job of a request, or all jobs.
void StudioSession::cancel_jobs(std::optional<double> request) {
  for (const auto& jobs : {jobs_, stills_, derivations_, sweeps_, measures_}) refuse_cancelled(jobs->cancel(request));
}

void StudioSession::refuse_cancelled(const std::vector<double>& requests) {
  for (const double request : requests) outbox_->send_text(refused_text(request, "cancelled", {{"cancelled", true}}));
}

/// Returns the document of the present text at the requested time and with the requested seed. Throws the text's
/// faults.
std::shared_ptr<const Document> StudioSession::document_for(double id, const ExportOptions& options) {
  const Readings::Reading reading(*readings_, id, MessageKind::other);
  const ReadOptions how{.seed = options.seed,
                        .time = options.time,
                        .root = root_,
                        .models = host_.models_folder,
                        .progress = &reading.progress()};
  auto document = read_document(session().text(), session().file(), host_.registry, how);
  return std::make_shared<const Document>(std::move(document));
}

/// Returns the grown plant if it fits the options and is fully grown, not at an earlier step. Returns null otherwise.
std::shared_ptr<const GrownPlant> StudioSession::grown_for(const ExportOptions& options) const {
  std::shared_ptr<const GrownPlant> grown = grower_->grown();
  const bool fits = grown != nullptr && grown->request.hash == hash_ && !grown->request.is_dragged && !options.seed &&
                    grown->time == options.time && !grown->view.step;
  return fits ? grown : nullptr;
}

std::string StudioSession::name_for(const ExportOptions& options) {
  if (options.name) return file_name_of(*options.name);
  return file_name_of(fs::path(title_).stem().string());
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const MeasuresRequest& request) {
  const ExportOptions options{.time = grower_->parts().time};
  run_newest(id, {"measure"}, measures_, host_.exports,
             [source = MeasureSource{document_for(id, options), grown_for(options), options.time}, request](
                 Host&, Progress& progress) -> Value::Member {
               return {"measures", measured(source, request, progress)};
             });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double, const MeasureRowsRequest&) {
  return Answer{{"rows", measure_rows_value()}};
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const SweepRequest& request) {
  const SweepSource source{.text = session().text(),
                           .file = session().file(),
                           .root = root_,
                           .models = host_.models_folder,
                           .time = grower_->parts().time};
  // Each plant of the sweep has the time of one measurement.
  const TimeLimit time{host_.limits.job_seconds * static_cast<double>(request.values.size()), "job_seconds"};
  run_newest(id, {"sweep", time}, sweeps_, host_.exports,
             [source, request, maker = sweep_maker_](Host& host, JobMessages& messages) -> Value::Member {
               return {"sweep", maker->make(source, request, host.registry, messages)};
             });
  return std::nullopt;
}

/// Answers the request later, on the thread that grows, with the result of `question(last growth, progress)`.
template <class Question>
void StudioSession::ask_grown(double id, Question question) {
  grower_->ask(
      [&host = host_, outbox = outbox_, jobs = jobs_, asked = jobs_->ask(id), question](const LastGrown* last) {
        const auto work = [&](Host&, Progress& progress) {
          if (last == nullptr) throw Refusal("nothing has grown yet");
          return question(*last, progress);
        };
        answer_by(host, outbox, *jobs, asked, {"question"}, work);
      });
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const InstanceRequest& request) {
  ask_grown(id, [request](const LastGrown& last, Progress& progress) -> Value::Member {
    return {"instance", instance_value(last.grown, request, progress, last.cache)};
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const ShootRequest& request) {
  ask_grown(id, [request](const LastGrown& last, Progress& progress) -> Value::Member {
    return {"instance", shoot_instance_value(last.grown, request, progress, last.cache)};
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const StandRequest& request) {
  ask_grown(id, [component = request.component](const LastGrown& last, Progress& progress) -> Value::Member {
    return {"stand", stand_value(last.grown, component, progress, last.cache)};
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const WorkedOutRequest& request) {
  ask_grown(id, [request](const LastGrown& last, Progress& progress) -> Value::Member {
    return {"numbers", worked_out_value(last.grown, request, progress, last.cache)};
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const CurvesRequest& request) {
  ask_grown(id, [request](const LastGrown& last, Progress&) -> Value::Member {
    return {"curves", curves_value(last.grown, request)};
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const CloudRequest& request) {
  ask_grown(id, [component = request.component](const LastGrown& last, Progress& progress) {
    PackedMember packed;
    packed.member = {"cloud", cloud_value(last, component, progress, packed.arrays)};
    return packed;
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const OperationsRequest& request) {
  ask_grown(id, [request](const LastGrown& last, Progress& progress) -> Value::Member {
    return {"operations", operations_value(last.grown, request, progress)};
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const ClocksRequest& request) {
  ask_grown(id, [request](const LastGrown& last, Progress& progress) -> Value::Member {
    return {"clocks", clocks_value(last.grown, request.up_to, progress, last.cache)};
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const OverlaysRequest& request) {
  ask_grown(id, [request](const LastGrown& last, Progress& progress) {
    PackedMember packed;
    packed.member = {"overlays", overlays_value(last, request, progress, packed.arrays)};
    return packed;
  });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const ExportRequest& request) {
  check_export(request.options);
  ExportSource source{.document = nullptr, .text = session().text(), .name = name_for(request.options), .grown = {}};
  if (request.options.format != ".json") {  // a faulty document may be downloaded, too
    source.document = document_for(id, request.options);
    source.grown = grown_for(request.options);
  }
  if (has_frames(request.options)) {
    run_later(
        id, {"export", TimeLimit{host_.limits.film_seconds, "film_seconds"}}, host_.films,
        [source = std::move(source), options = request.options](Host& host, JobMessages& messages) -> Value::Member {
          Value file = export_frames(source, options, host.downloads, messages);
          give_back_memory();
          return {"file", std::move(file)};
        });
    return std::nullopt;
  }
  run_later(id, {"export"}, host_.exports,
            [source = std::move(source), options = request.options](Host& host, Progress& progress) -> Value::Member {
              Value file = export_file(source, options, host.downloads, progress);
              give_back_memory();
              return {"file", std::move(file)};
            });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double, const CommandRequest& request) {
  check_export(request.options);
  const std::string own = fs::path(session().file()).filename().string();
  const std::string file = model_ ? *model_ : path_ ? host_.root.absolute(*path_) : own;
  return Answer{{"command", export_command(host_.command, file, request.options, name_for(request.options))}};
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const StillsRequest& request) {
  const StillSource source{.text = session().text(),
                           .file = session().file(),
                           .root = root_,
                           .models = host_.models_folder,
                           .time = grower_->parts().time,
                           .grown = grower_->grown()};
  run_newest(id, {"stills"}, stills_, host_.stills,
             [source, request, maker = still_maker_](Host& host, Progress& progress) -> Value::Member {
               return {"stills", maker->make(source, request, host.registry, progress)};
             });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const GrammarRequest& request) {
  // The text's own grammar is derived, even while a drag shows other values.
  read_now(id);
  const bool is_plain = session().overrides().empty();
  if (is_plain && !session().is_good()) throw Refusal("the document has faults");
  run_newest(id, {"grammar"}, derivations_, host_.stills,
             [document = is_plain ? session().shared_document() : document_for(id, {}), request,
              time = grower_->parts().time](Host&, Progress& progress) -> Value::Member {
               return {"derivation", derivation(*document, request, time, progress)};
             });
  return std::nullopt;
}

std::optional<StudioSession::Answer> StudioSession::act(double id, const PictureRequest& request) {
  run_later(id, {"picture"}, host_.stills,
            [request, document = session().file(), root = root_](Host&, Progress&) -> Value::Member {
              return {"thumbnail", thumbnail(request.file, request.size, document, root, SizeLimits())};
            });
  return std::nullopt;
}

}  // namespace meristem::studio
