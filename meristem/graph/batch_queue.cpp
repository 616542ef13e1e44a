// SPDX-License-Identifier: Apache-2.0
// The order of expansion. Whole batches expand breadth-first. In slices, the children of a slice come before all other
// batches, and each result is stored under its way from the root; results are gathered by way, in the order of whole
// batches.
#include "meristem/graph/batch_queue.h"

#include <algorithm>
#include <iterator>

namespace meristem {

namespace {

constexpr std::size_t kSitesTogether = 65'536;  // maximum number of sites that one slice of a batch may emit

}  // namespace

void BatchQueue::begin(Batch root, bool in_slices) {
  in_slices_ = in_slices;
  if (in_slices_) root.way = roots_.emplace_back(new_way(root.component));
  ready_.push_back(std::move(root));
}

Batch BatchQueue::next() {
  Batch batch = std::move(ready_.front());
  ready_.pop_front();
  if (batch.way == nullptr) return batch;
  const Way& way = *batch.way;
  const bool is_last = graph_.structure.outgoing[batch.component].empty();
  std::size_t max = is_last ? kSitesTogether : kBlock;
  if (!is_last && way.sites > 0) max = kSitesTogether * way.sites / std::max<std::size_t>(way.offered, 1);
  max = std::clamp(max / kBlock * kBlock, kBlock, kSitesTogether);
  if (batch.end - batch.begin > max) {
    Batch rest = batch;
    rest.begin = batch.end = batch.begin + max;
    ready_.push_front(std::move(rest));
  }
  return batch;
}

std::vector<Batch> BatchQueue::take_growing() {
  gather_ways();
  std::vector<Batch> growing = std::exchange(growing_, {});
  std::ranges::stable_sort(growing, {}, &Batch::component);
  return growing;
}

Batch BatchQueue::children(const Batch& parent, LinkIndex link, std::shared_ptr<const Sites> places) {
  Batch children{.component = graph_.links[link].to, .places = std::move(places), .way = way_onward(parent, link)};
  if (parent.way != nullptr) parent.way->offered += children.count();
  return children;
}

void BatchQueue::add(Batch children) {
  if (children.count() == 0) return;
  const bool grows = static_cast<bool>(graph_.components[children.component].type->grow);
  if (grows && children.way != nullptr) {
    children.read([&](const Site& site) { children.way->waiting.add(site); });
  } else if (grows) {
    growing_.push_back(std::move(children));
  } else if (in_slices_) {
    added_.push_back(std::move(children));
  } else {
    ready_.push_back(std::move(children));
  }
}

void BatchQueue::finish(const Batch& batch, std::shared_ptr<const BatchResult> result, BatchResult* own) {
  ready_.insert(ready_.begin(), std::move_iterator(added_.begin()), std::move_iterator(added_.end()));
  added_.clear();
  std::vector<FinishedBatch>& results = batch.way != nullptr ? batch.way->made : results_;
  results.push_back({batch.component, std::move(result), own});
  if (batch.way != nullptr) batch.way->sites += batch.count();
}

std::vector<FinishedBatch> BatchQueue::take_results() { return std::exchange(results_, {}); }

Way* BatchQueue::new_way(ComponentIndex component) { return &ways_.emplace_back(Way{component}); }

/// Returns the way by a link from the parent's own way. The children of a grown batch begin a new way, unless they grow
/// themselves.
Way* BatchQueue::way_onward(const Batch& parent, LinkIndex link) {
  const ComponentIndex to = graph_.links[link].to;
  if (!in_slices_) return nullptr;
  if (parent.way == nullptr) return graph_.components[to].type->grow ? nullptr : roots_.emplace_back(new_way(to));
  std::vector<std::pair<LinkIndex, Way*>>& onward = parent.way->onward;
  const auto place = std::ranges::lower_bound(onward, link, {}, &std::pair<LinkIndex, Way*>::first);
  if (place != onward.end() && place->first == link) return place->second;
  return onward.emplace(place, link, new_way(to))->second;
}

/// Passes on the results of all ways since the last growth in the order of whole batches: shorter ways come first.
/// Components that grow wait.
void BatchQueue::gather_ways() {
  std::deque<Way*> ahead(roots_.begin(), roots_.end());
  for (; !ahead.empty(); ahead.pop_front()) {
    Way& way = *ahead.front();
    results_.insert(results_.end(), std::move_iterator(way.made.begin()), std::move_iterator(way.made.end()));
    for (const auto& [link, onward] : way.onward) {
      if (onward->waiting.empty()) {
        ahead.push_back(onward);
      } else {
        onward->waiting.pack();
        growing_.push_back({onward->component, std::make_shared<Sites>(Sites{std::move(onward->waiting)})});
      }
    }
  }
  roots_.clear();
  ways_.clear();
}

}  // namespace meristem
