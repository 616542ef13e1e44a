// SPDX-License-Identifier: Apache-2.0
#include "asked_jobs.h"

namespace meristem::studio {

AskedJobs::Job AskedJobs::ask(double request) {
  const std::lock_guard lock(mutex_);
  auto job = std::make_shared<AskedJob>(AskedJob{.request = request});
  if (is_closed_) job->is_over = true;
  if (!is_closed_) jobs_.emplace(request, job);
  return job;
}

bool AskedJobs::begin(const Job& job, Progress& progress) {
  const std::lock_guard lock(mutex_);
  if (!job->is_over) job->running = &progress;
  return !job->is_over;
}

void AskedJobs::end(const Job& job) {
  const std::lock_guard lock(mutex_);
  job->running = nullptr;
  job->is_over = true;
  for (auto at = jobs_.lower_bound(job->request); at != jobs_.end() && at->first == job->request; ++at) {
    if (at->second != job) continue;
    jobs_.erase(at);
    return;
  }
}

std::vector<double> AskedJobs::cancel(std::optional<double> request) {
  const std::lock_guard lock(mutex_);
  std::vector<double> waited;
  for (auto at = jobs_.begin(); at != jobs_.end();) {
    AskedJob& job = *at->second;
    const bool is_meant = !request || *request == job.request;
    if (is_meant && job.running != nullptr) job.running->cancel();
    if (is_meant && job.running == nullptr) {
      job.is_over = true;
      waited.push_back(job.request);
      at = jobs_.erase(at);
    } else {
      ++at;
    }
  }
  return waited;
}

void AskedJobs::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  cancel();
}

}  // namespace meristem::studio
