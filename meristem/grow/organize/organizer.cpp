// SPDX-License-Identifier: Apache-2.0
// One iteration computes the light of the buds and the resource that this light makes, and divides the resource among
// the buds. Then new metamers grow, shoots are shed, and operations are performed. All plants of a stand use the light
// at the beginning of the round. After the last iteration, one more round counts light and resource for the skeleton's
// columns.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/base/require.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/grow/organize/organize_trace.h"
#include "meristem/grow/organize/organized_tree.h"
#include "meristem/plant/join_skeletons.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxTreeBlocks = 256;  // blocks of trees per parallel loop, at most

void check_parameters(const OrganizeParameters& parameters) {
  require(parameters.iterations >= 0 && parameters.iterations < 65536, "organize: iterations must be 0 to 65535");
  require(parameters.every >= 1 && parameters.longest_shoot >= 1 && parameters.maturity >= 1,
          "organize: every, longest_shoot and maturity must be at least 1");
  require(parameters.length > 0 && std::isfinite(parameters.length), "organize: length must be above 0");
  for (const TreeOperation& operation : parameters.operations) {
    require(operation.when.from >= 1 && operation.when.every >= 1, "organize: operations must act from iteration 1 on");
    const CutOperation* const cut = std::get_if<CutOperation>(&operation.what);
    require(cut == nullptr || cut->above >= 0, "organize: a cut has negative numbers");
    require(cut == nullptr || cut->place != CutOperation::Place::outside || cut->outside,
            "organize: a cut has no body");
    const LayersOperation* const layers = std::get_if<LayersOperation>(&operation.what);
    require(layers == nullptr || (layers->metamers >= 3 && layers->count >= 1), "organize: layers are too short");
    const TrainingSupport* const support = std::get_if<TrainingSupport>(&operation.what);
    require(support == nullptr || !support->named.empty() || support->line.size() >= 2,
            "organize: a support has no length");
    const GirdleOperation* const girdle = std::get_if<GirdleOperation>(&operation.what);
    require(girdle == nullptr ||
                (girdle->below >= 0 && girdle->iterations >= 1 && girdle->share >= 0 && girdle->share <= 1),
            "organize: a ring is out of its ranges");
    const BendOperation* const bend = std::get_if<BendOperation>(&operation.what);
    require(bend == nullptr || (bend->below >= 0 && bend->iterations >= 1 && bend->metamers >= 1),
            "organize: a bend is out of its ranges");
    const TieOperation* const tie = std::get_if<TieOperation>(&operation.what);
    require(tie == nullptr || (tie->below.value_or(1) >= 1 && tie->iterations >= 1 && tie->length >= 0),
            "organize: a tie is out of its ranges");
    const MarkOperation* const mark = std::get_if<MarkOperation>(&operation.what);
    require(mark == nullptr || mark->state < kMaxMarks, "organize: a mark has no such number");
  }
  require(parameters.callus >= 0, "organize: callus must not be negative");
  require(parameters.summer > 0 && parameters.summer < 1, "organize: summer is between 0 and 1");
  require(parameters.marks.size() <= kMaxMarks, "organize: there are too many marks");
  require(parameters.light.voxel >= 0 && parameters.light.full >= 0,
          "organize: the numbers of light must not be negative");
}

class Organizer : public Grower {
 public:
  Organizer(Stand& stand, std::vector<OrganizeSeed> seeds, const OrganizeParameters& parameters, RandomKey key,
            const Scene& scene, const SizeLimits& limits, std::string component)
      : species_{parameters, scene, limits, std::move(component), parameters.directions.value_or(scene.directions())},
        space_(stand.commons<StandSpace>()),
        has_summer_(species_.has_summer()),
        rounds_(species_.rounds()) {
    require_wood(seeds);
    const bool seeks_room = parameters.light.kind == BudLightModel::Kind::markers;
    if (parameters.request.any()) trace_ = std::make_unique<OrganizeTrace>(seeks_room);
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      require_open(seeds[k].frame.origin);
      OrganizedTree& tree = trees_.emplace_back(species_, space_, seeds[k], key.child(k), static_cast<int>(k));
      if (seeds[k].wood == nullptr) continue;
      tree.stand(*seeds[k].wood);
      tree.tell();  // existing wood affects the first round
    }
  }

  int step_limit() const override {
    const std::int64_t rounds = std::int64_t{species_.parameters.iterations} * rounds_ + 1;
    return static_cast<int>(std::min<std::int64_t>(rounds, std::numeric_limits<int>::max()));
  }

  bool step(Progress& progress) override {
    progress.check();
    const int round = round_++;
    const int iteration = round / rounds_ + 1;
    const bool has_summer = has_summer_ && species_.has_summer(iteration);
    const bool is_rest = round % rounds_ != 0;
    if (is_rest && !(has_summer && round % rounds_ == rounds_ / 2)) return true;
    const bool is_last = iteration > species_.parameters.iterations;
    const bool is_recorded = species_.parameters.request.any() && !is_rest;
    const Flush flush = !has_summer ? Flush::whole : (is_rest ? Flush::rest : Flush::first);
    std::vector<std::uint64_t> planned(trees_.size());
    for_each_tree([&](std::size_t k) {
      trees_[k].sense(iteration, progress);
      if (!is_last) planned[k] = trees_[k].plan(flush);
    });
    if (is_recorded) record(progress);
    if (is_last) {
      require_growth();
      return false;
    }
    require_nodes(planned, iteration);
    for_each_tree([&](std::size_t k) { trees_[k].iterate(iteration, flush, progress); });
    require_shoots();
    return true;
  }

  void tell() override {
    for (OrganizedTree& tree : trees_) tree.tell();
  }

  bool do_plan(Progress& progress) override {
    if (trees_.empty() || !trees_.front().has_outcome()) return false;
    end_record();
    planned_ = skeleton_of_trees(progress);
    for (OrganizedTree& tree : trees_) tree.do_plan();
    return true;
  }

  void see_outcome(Progress& progress) override {
    for_each_tree([&](std::size_t k) { trees_[k].sense(species_.parameters.iterations + 1, progress); });
    trace_->plan(skeleton_of_trees(progress));
  }

  std::unique_ptr<GrowthTrace> take_trace() override {
    if (!species_.parameters.request.any()) return nullptr;
    if (!planned_) end_record();
    return std::move(trace_);
  }

  Skeleton take_skeleton(Progress& progress) override {
    return planned_ ? std::move(*planned_) : skeleton_of_trees(progress);
  }

 private:
  /// Calls `visit` for all trees in parallel. Trees affect each other only through the stand.
  template <class Visit>
  void for_each_tree(Visit visit) {
    parallel_for(trees_.size(), 1 + trees_.size() / kMaxTreeBlocks, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) visit(k);
    });
  }

  Skeleton skeleton_of_trees(Progress& progress) {
    std::vector<Skeleton> skeletons(trees_.size());
    for_each_tree([&](std::size_t k) { skeletons[k] = trees_[k].take_skeleton(progress); });
    return join_skeletons(std::move(skeletons));
  }

  /// Adds the losses and the space of all trees to the trace.
  void end_record() {
    std::vector<TracedLoss> losses;
    for (const OrganizedTree& tree : trees_) losses.insert(losses.end(), tree.losses().begin(), tree.losses().end());
    trace_->lose(std::move(losses));
    if (species_.parameters.request.has(TracePart::markers)) show_room();
  }

  /// Records the trees after the previous iteration, and the directions that they follow in this one.
  void record(Progress& progress) {
    OrganizeTrace::Step step;
    if (species_.parameters.request.has(TracePart::steps)) {
      std::vector<Skeleton> skeletons(trees_.size());
      for_each_tree([&](std::size_t k) { skeletons[k] = trees_[k].skeleton(progress); });
      step.skeleton = join_skeletons(std::move(skeletons));
    }
    for (const OrganizedTree& tree : trees_) {
      step.ways.insert(step.ways.end(), tree.ways().begin(), tree.ways().end());
    }
    recorded_bytes_ += step.skeleton.bytes() + step.ways.capacity() * sizeof(TracedWay);
    trace_->add(std::move(step));
    if (recorded_bytes_ <= species_.limits.mesh_bytes) return;
    throw_limit("bytes of trees that are recorded step by step", static_cast<double>(recorded_bytes_),
                species_.limits.mesh_bytes, "mesh_bytes", species_.path("iterations"));
  }

  /// Adds the space of the trees to the trace. All trees share one field.
  void show_room() {
    const MarkerField* const field = trees_.empty() ? nullptr : trees_.front().room().field;
    if (field == nullptr) return;
    TracedRoom room{.vacant = field->vacant(),
                    .perception = species_.parameters.light.perception * species_.parameters.length,
                    .max_markers = species_.limits.points,
                    .path = species_.path("light.spacing")};
    for (const OrganizedTree& tree : trees_) room.volumes.push_back(tree.room().volume);
    trace_->show_room(std::move(room));
  }

  /// Checks that an operation for all trees finds its shoot in at least one of them.
  void require_shoots() const {
    std::vector<std::size_t> misses(species_.parameters.operations.size(), 0);
    for (const OrganizedTree& tree : trees_) {
      for (const OrganizedTree::Miss& miss : tree.misses()) {
        const bool is_for_one = species_.parameters.operations[miss.operation].tree.has_value();
        if (++misses[miss.operation] == (is_for_one ? 1 : trees_.size())) throw InputError(miss.error);
      }
    }
  }

  /// Checks the limit of nodes before growing.
  void require_nodes(const std::vector<std::uint64_t>& planned, int iteration) const {
    std::uint64_t metamers = 0;
    for (std::size_t k = 0; k < trees_.size(); ++k) metamers += trees_[k].metamers().count() + planned[k];
    if (metamers <= species_.limits.nodes) return;
    throw_limit(fmt::format("metamers in iteration {}", iteration), static_cast<double>(metamers),
                species_.limits.nodes, "nodes", species_.path("resource.alpha"));
  }

  /// Checks the limit of nodes before converting existing wood.
  void require_wood(const std::vector<OrganizeSeed>& seeds) const {
    double metamers = 0;
    for (const OrganizeSeed& seed : seeds) {
      if (seed.wood) metamers += max_metamers_of_wood(*seed.wood, species_.parameters.length);
    }
    if (metamers <= static_cast<double>(species_.limits.nodes)) return;
    throw_limit("metamers of the trees that stand there", metamers, species_.limits.nodes, "nodes",
                species_.path("length"));
  }

  void require_open(Vec3 root) const {
    if (!species_.scene.obstacles.contain(root)) return;
    species_.refuse(
        "roots", fmt::format("a root stands inside an obstacle, at ({:.4g}, {:.4g}, {:.4g})", root.x, root.y, root.z),
        "a position outside all of scene.obstacles");
  }

  /// Throws an error if no tree has ever grown a metamer.
  void require_growth() const {
    double max = 0;
    double light = 0;
    for (const OrganizedTree& tree : trees_) {
      if (tree.has_grown()) return;
      max = std::max(max, tree.flow().resource[0]);
      light = std::max(light, tree.flow().light[0]);
    }
    if (trees_.empty() || species_.parameters.iterations == 0) return;
    if (!(light > 0)) {
      species_.refuse("light", "nothing grows: the seed's bud has no light", "more light or room at the roots");
    }
    if (max >= species_.parameters.terminal_threshold) {
      species_.refuse("roots",
                      "nothing grows: obstacles, the ground or the end of the room stand in the way of every stem",
                      "roots with room above them, or shorter metamers");
    }
    species_.refuse("resource.alpha",
                    fmt::format("nothing grows: the light of the seed's bud makes a resource of {:.4g} at most, and it "
                                "opens at {:.4g}",
                                max, species_.parameters.terminal_threshold),
                    "a larger 'alpha', more light or room, or a lower 'terminal_threshold'");
  }

  OrganizedSpecies species_;
  StandSpace& space_;
  bool has_summer_;
  int rounds_;                       // per iteration
  std::deque<OrganizedTree> trees_;  // a deque, because the space keeps pointers to the trees
  int round_ = 0;
  std::unique_ptr<OrganizeTrace> trace_;  // the record, if requested
  std::uint64_t recorded_bytes_ = 0;
  std::optional<Skeleton> planned_;  // the trees before their planned operations, if these were performed
};

}  // namespace

std::unique_ptr<Grower> make_organizer(Stand& stand, std::vector<OrganizeSeed> seeds,
                                       const OrganizeParameters& parameters, RandomKey key, const Scene& scene,
                                       const SizeLimits& limits, std::string component) {
  check_parameters(parameters);
  return std::make_unique<Organizer>(stand, std::move(seeds), parameters, key, scene, limits, std::move(component));
}

}  // namespace meristem
