// SPDX-License-Identifier: Apache-2.0
// Both models are first reduced to one number per metamer: the share of its incoming resource that goes to the lateral
// side. One pass from the root up then divides the resource by either model, or by different models on different axes.
// The resource that damaged terminal buds pass back is proportional to that which the axis receives, so it is a share
// too.
#include "meristem/grow/metamer/resource.h"

#include <algorithm>

namespace meristem {

namespace {

constexpr double kNoLight = -1;  // in place of a share: nobody at this fork has light

/// Light of the sides of a fork, as they compete for resource.
class Claims {
 public:
  Claims(const Metamers& metamers, const BudLight& light, const ResourceFlow& flow)
      : metamers_(metamers), light_(light), flow_(flow) {}

  double terminal(MetamerIndex metamer) const {
    const Bud bud = metamers_.terminal[metamer];
    return bud.is_grown() ? flow_.light[bud.metamer()] : light_.terminal[metamer];
  }
  double lateral(MetamerIndex metamer) const {
    const Bud bud = metamers_.lateral[metamer];
    if (bud.is_grown()) return flow_.light[bud.metamer()];
    return bud.is_open() ? light_.lateral[metamer] : 0;
  }
  double mean_lateral(MetamerIndex metamer) const {
    const Bud bud = metamers_.lateral[metamer];
    if (!bud.is_grown()) return lateral(metamer);
    const std::uint32_t buds = flow_.buds[bud.metamer()];
    return buds == 0 ? 0 : flow_.light[bud.metamer()] / buds;
  }

 private:
  const Metamers& metamers_;
  const BudLight& light_;
  const ResourceFlow& flow_;
};

double borchert_honda_share(double terminal, double lateral, double lambda) {
  const double weighted = (1 - lambda) * lateral;
  const double sum = lambda * terminal + weighted;
  if (sum > 0) return weighted / sum;
  // With all weight on a side without light, the other one gets what comes.
  return terminal > 0 ? 0 : (lateral > 0 ? 1 : kNoLight);
}

/// Sets the shares along one axis.
class PriorityAxis {
 public:
  PriorityAxis(const Metamers& metamers, const Claims& claims, const ResourceModel& model)
      : metamers_(metamers), claims_(claims), model_(model) {}

  void divide(const Metamers::Axis& axis, std::vector<double>& to_lateral) {
    ranked_.clear();
    for (MetamerIndex metamer = axis.last;; metamer = metamers_.parent[metamer]) {
      if (claims_.lateral(metamer) > 0) ranked_.push_back({metamer, claims_.mean_lateral(metamer)});
      if (metamer == axis.first) break;
    }
    std::ranges::sort(ranked_, [](const Ranked& a, const Ranked& b) {
      return a.mean != b.mean ? a.mean > b.mean : a.metamer < b.metamer;
    });
    const std::size_t count = ranked_.size() + 1;
    for (std::size_t k = 0; k < ranked_.size(); ++k) {
      to_lateral[ranked_[k].metamer] = claims_.lateral(ranked_[k].metamer) * model_.weights(k + 1, count);
    }
    // From the tip down: what each lateral claims of all that is claimed from there on.
    double sum = claims_.terminal(axis.last) * model_.weights(0, count);
    for (MetamerIndex metamer = axis.last;; metamer = metamers_.parent[metamer]) {
      const double own = claims_.lateral(metamer) > 0 ? to_lateral[metamer] : 0;
      sum += own;
      to_lateral[metamer] = sum > 0 ? own / sum : kNoLight;
      if (metamer == axis.first) break;
    }
  }

 private:
  struct Ranked {
    MetamerIndex metamer;
    double mean;
  };
  const Metamers& metamers_;
  const Claims& claims_;
  const ResourceModel& model_;
  std::vector<Ranked> ranked_;
};

bool has_priority(const Metamers& metamers, const ResourceModel& model, const Metamers::Axis& axis) {
  if (model.laterals == 0) return true;
  int laterals = 0;
  for (MetamerIndex metamer = axis.last; laterals <= model.laterals; metamer = metamers.parent[metamer]) {
    laterals += metamers.lateral[metamer].is_grown() ? 1 : 0;
    if (metamer == axis.first) return laterals <= model.laterals;
  }
  return false;
}

/// Lets the laterals of an axis whose terminal bud is damaged take their shares of what it claims, from the top down.
/// Returns what of it nobody takes, as a share of what comes to the axis.
/// Nothing passes a ring: what the terminal claims of the resource that is kept above one, `kept` by metamer, is taken
/// above it or lost.
double pass_back(const Metamers& metamers, const Metamers::Axis& axis, double share, const std::vector<double>& kept,
                 ResourceFlow& flow) {
  double claim = 1 - flow.to_lateral[axis.last];  // as a share of what comes to the metamer
  double rest = 1;
  for (MetamerIndex metamer = axis.last;; metamer = metamers.parent[metamer]) {
    const Bud bud = metamers.lateral[metamer];
    if (bud.is_open() || bud.is_grown()) {
      flow.passed_back[metamer] = share * rest * claim;
      rest -= share * rest;
    }
    if (metamer == axis.first) return rest * claim;
    if (!kept.empty()) flow.lost += rest * claim * kept[metamer];
    claim *= 1 - flow.to_lateral[metamers.parent[metamer]];
  }
}

/// What the rings keep above them, by metamer, and at metamer 0 what all of them do.
std::vector<double> keep_above_rings(const Metamers& metamers, const ResourceModel& model, const ResourceFlow& flow,
                                     std::span<const float> ringed) {
  if (ringed.empty()) return {};
  std::vector<double> kept(metamers.count(), 0);
  std::vector<double> above(metamers.count(), 0);  // what rings keep there and beyond
  for (auto metamer = static_cast<MetamerIndex>(metamers.count()); metamer-- > 1;) {
    // Rounding must not make it negative.
    kept[metamer] = ringed[metamer] * std::max(0.0, model.alpha * flow.light[metamer] - above[metamer]);
    above[metamers.parent[metamer]] += above[metamer] + kept[metamer];
  }
  kept[0] = above[0];
  return kept;
}

}  // namespace

double PriorityWeights::operator()(std::size_t rank, std::size_t count) const {
  const double place = static_cast<double>(rank) / static_cast<double>(count);
  return place >= reach ? (rank == 0 ? highest : lowest) : highest + (lowest - highest) * place / reach;
}

void BudLight::resize(std::size_t metamers) {
  terminal.assign(metamers, 0);
  lateral.assign(metamers, 0);
}

void gather_light(const Metamers& metamers, const BudLight& light, ResourceFlow& flow) {
  const std::size_t count = metamers.count();
  flow.light.assign(count, 0);
  flow.buds.assign(count, 0);
  for (auto metamer = static_cast<MetamerIndex>(count); metamer-- > 0;) {
    if (metamers.terminal[metamer].is_open()) {
      flow.light[metamer] += light.terminal[metamer];
      ++flow.buds[metamer];
    }
    if (metamers.lateral[metamer].is_open()) {
      flow.light[metamer] += light.lateral[metamer];
      ++flow.buds[metamer];
    }
    if (metamer == 0) break;
    const MetamerIndex parent = metamers.parent[metamer];
    flow.light[parent] += flow.light[metamer];
    flow.buds[parent] += flow.buds[metamer];
  }
}

void divide_resource(const Metamers& metamers, const BudLight& light, const ResourceModel& model, int iteration,
                     double age, ResourceFlow& flow, std::span<const float> ringed) {
  const std::size_t count = metamers.count();
  flow.resource.assign(count, 0);
  flow.to_lateral.assign(count, 0);
  flow.passed_back.assign(count, 0);
  flow.lost = 0;
  const Claims claims(metamers, light, flow);
  const double lambda = std::clamp(model.lambda * model.lambda_curve(age), 0.0, 1.0);
  for (MetamerIndex metamer = 0; metamer < count; ++metamer) {
    flow.to_lateral[metamer] = borchert_honda_share(claims.terminal(metamer), claims.lateral(metamer), lambda);
  }
  if (model.division == ResourceModel::Division::priority && (model.until == 0 || iteration <= model.until)) {
    PriorityAxis priority(metamers, claims, model);
    for (const Metamers::Axis& axis : metamers.axes) {
      if (has_priority(metamers, model, axis)) priority.divide(axis, flow.to_lateral);
    }
  }

  // Where nobody has light, nothing can be divided.
  const std::vector<double> kept = keep_above_rings(metamers, model, flow, ringed);
  double root = model.alpha0 + model.alpha * flow.light[0];
  if (!kept.empty()) root = std::max(model.alpha0, root - kept[0]);
  std::vector<std::pair<MetamerIndex, double>> lost_shares;
  for (MetamerIndex metamer = 0; metamer < count; ++metamer) {
    if (flow.to_lateral[metamer] != kNoLight) continue;
    flow.to_lateral[metamer] = 0;
    const Bud terminal = metamers.terminal[metamer];
    if (!terminal.is_grown() && !terminal.is_damaged()) lost_shares.emplace_back(metamer, 1);
  }
  for (const Metamers::Axis& axis : metamers.axes) {
    if (!metamers.terminal[axis.last].is_damaged()) continue;
    lost_shares.emplace_back(axis.first, pass_back(metamers, axis, model.pass_back, kept, flow));
  }
  flow.resource[0] = root;
  for (MetamerIndex metamer = 0; metamer < count; ++metamer) {
    if (metamer != 0 && !kept.empty()) flow.resource[metamer] += kept[metamer];
    if (metamers.terminal[metamer].is_grown()) {
      flow.resource[metamers.terminal[metamer].metamer()] = flow.terminal(metamer);
    }
    if (metamers.lateral[metamer].is_grown()) {
      flow.resource[metamers.lateral[metamer].metamer()] = flow.lateral(metamer);
    }
  }
  for (const auto& [metamer, share] : lost_shares) flow.lost += share * flow.resource[metamer];
}

}  // namespace meristem
