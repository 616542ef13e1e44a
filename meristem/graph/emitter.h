// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/graph/emitted.h"
#include "meristem/graph/instance_context.h"
#include "meristem/graph/organ_sink.h"
#include "meristem/graph/site_sink.h"
#include "meristem/graph/stem_sink.h"

namespace meristem {

struct ComponentBase;
struct EmitterContext;

/// Expands the instances of one block, and collects their parts in a sink for each kind of part. One thread uses one
/// emitter; blocks are merged in their order.
///
/// An instance whose frame has shrunk to nothing emits nothing, and neither do its children. Throws InputError for
/// frames that are not finite.
class Emitter {
 public:
  /// `context` must outlive the emitter.
  explicit Emitter(EmitterContext& context);
  ~Emitter();
  Emitter(const Emitter&) = delete;
  Emitter& operator=(const Emitter&) = delete;

  const InstanceContext& context() const { return instance_; }  ///< questions about the present instance
  OrganSink& organs() { return organs_; }                       ///< organs of the present instance
  StemSink& stems() { return stems_; }                          ///< stems of the present instance
  SiteSink& sites() { return sites_; }                          ///< sites of its children
  /// Returns the sink of this type, or the context, or the emitter itself.
  template <class Sink>
  Sink& get() {
    if constexpr (std::is_same_v<Sink, const InstanceContext>) {
      return instance_;
    } else if constexpr (std::is_same_v<Sink, OrganSink>) {
      return organs_;
    } else if constexpr (std::is_same_v<Sink, StemSink>) {
      return stems_;
    } else if constexpr (std::is_same_v<Sink, SiteSink>) {
      return sites_;
    } else {
      static_assert(std::is_same_v<Sink, Emitter>, "expand takes const InstanceContext& or a sink");
      return *this;
    }
  }

  /// Returns the time of the document, seconds.
  double document_time() const;
  /// Calls `expand` for one instance, unless it is omitted; `index` counts within the block.
  void instance(const ComponentBase& base, const Site& site, std::size_t index, FunctionRef<void(const Site&)> expand);
  /// Sets the skeletons of the block's instances, which StemSink::take_grown() returns in turn.
  void set_grown(std::vector<Skeleton> skeletons);
  /// Sets the growth that InstanceContext::watched_growth() returns.
  void set_watched(std::shared_ptr<const GrowthTrace> watched);
  /// Returns everything that was emitted. Must be called once per emitter.
  Emitted take();

 private:
  void begin_instance(const ComponentBase& base, const Site& site);

  std::unique_ptr<PresentInstance> present_;
  InstanceContext instance_;
  OrganSink organs_;
  StemSink stems_;
  SiteSink sites_;
};

}  // namespace meristem
