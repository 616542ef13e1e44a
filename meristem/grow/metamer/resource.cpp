// SPDX-License-Identifier: Apache-2.0
// Both models are first reduced to one number per metamer: the share of its incoming resource for the lateral side. One
// pass from the root to the tips then divides the resource by either model, or by different models on different axes.
// The resource that damaged terminal buds pass back is proportional to the resource of the axis, so it is also a share.
#include "meristem/grow/metamer/resource.h"

#include <algorithm>

namespace meristem {

namespace {

constexpr double kNoLight = -1;  // special value: neither side of this fork has light

/// The light of both sides of a fork, with which they compete for resource.
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
  // If the side with all of the weight has no light, the other side gets the whole resource.
  return terminal > 0 ? 0 : (lateral > 0 ? 1 : kNoLight);
}

/// Computes the shares along one axis by the priority model.
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
    // From the tip down: the share of each lateral in the sum of all claims from there to the tip.
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

/// Gives the terminal bud's claim to the laterals of an axis whose terminal bud is damaged, from the top down. Returns
/// the rest that no lateral takes, as a share of the axis's resource. A ring blocks this: `kept` is the resource kept
/// above a ring, by metamer, and the terminal's claim on it is used above the ring or lost.
double pass_back(const Metamers& metamers, const Metamers::Axis& axis, double share, const std::vector<double>& kept,
                 ResourceFlow& flow) {
  double claim = 1 - flow.to_lateral[axis.last];  // as a share of the metamer's resource
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

/// Returns the resource that rings keep above them, by metamer. Metamer 0 has the sum of all rings.
std::vector<double> keep_above_rings(const Metamers& metamers, const ResourceModel& model, const ResourceFlow& flow,
                                     std::span<const float> ringed) {
  if (ringed.empty()) return {};
  std::vector<double> kept(metamers.count(), 0);
  std::vector<double> above(metamers.count(), 0);  // resource kept by rings at the metamer and beyond
  for (auto metamer = static_cast<MetamerIndex>(metamers.count()); metamer-- > 1;) {
    // Rounding must not make the value negative.
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

  // Resource cannot be divided at forks without light.
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
