// SPDX-License-Identifier: Apache-2.0
// Places the children of branch links along the axes of a skeleton. Each axis is cut into straight pieces that may
// carry children, weighted by the relative density. Sites then stand at equal steps of weighted length, and a radial
// direction is carried along without twist as the zero of their rolls.
#include "meristem/graph/placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/placement_parts.h"
#include "meristem/graph/table/node_condition.h"
#include "meristem/graph/table/table.h"

namespace meristem {

const ParameterTable& placement_table() {
  static const ParameterTable table =
      Table<BranchPlacement>("a branch link", "Positions of children along stems.")
          .number("density", &BranchPlacement::density,
                  {.unit = Unit::per_metre, .min = 0, .max = 1e9, .usual = {0, 200}},
                  "Density of the sites along the stem; 40 where neither density nor count is given.")
          .count("count", &BranchPlacement::count, {.min = 0, .max = 2e9, .usual = {0, 500}},
                 "Number of sites on each skeleton, divided among its axes by their length; of 3.4 sites the last one "
                 "has 0.4 of its size.")
          .condition("where", &BranchPlacement::where, node_variables(),
                     "Condition for the parts of stems that bear children; by default, twigs (\"tip_distance < 0.4\") "
                     "of grown plants, and all of other stems.")
          .integer("whorl", &BranchPlacement::whorl, {.min = 1, .max = 1000, .usual = {1, 8}},
                   "Number of children per site, evenly around the axis; raised above 1, whorls.")
          .number("divergence", &BranchPlacement::divergence,
                  {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 180}},
                  "Divergence angle, the turn about the axis from site to site: 137.508 for a spiral, 180 for two "
                  "rows, 90 with whorls of 2 for crossed pairs.")
          .number("roll", &BranchPlacement::roll, {.unit = Unit::degree, .min = -360, .max = 360},
                  "Angle of the first child around the axis, from the upper side of the stem toward its right; by "
                  "default, random.")
          .per_site("angle", &BranchPlacement::angle, {.unit = Unit::degree, .min = 0, .max = 180},
                    "Angle between the axis and each child; raised, children stand off more. A link may give a range, "
                    "an expression or a sample, for one angle per child.")
          .number("angle_tip", &BranchPlacement::angle_tip, {.unit = Unit::degree, .min = 0, .max = 180},
                  "Angle between the axis and each child at the axis's tip; by default, the one given by 'angle'.")
          .number("angle_spread", &BranchPlacement::angle_spread,
                  {.unit = Unit::degree, .min = 0, .max = 180, .usual = {0, 45}},
                  "Largest random deviation of the angle between axis and child, to both sides.")
          .curve("size", &BranchPlacement::size,
                 "Scale of the children over u, from base (0) to tip (1) of each axis; where it is 0 or less, there "
                 "are no children.")
          .curve("spread", &BranchPlacement::spread,
                 "Relative density of the sites over u, from base (0) to tip (1) of each axis; [[0, 0], [1, 1]] crowds "
                 "the tip.")
          .number("droop", &BranchPlacement::droop, {.min = -1, .max = 1},
                  "Share of the turn of the children's heading straight down: 1 lets them hang, 0 leaves them as they "
                  "are, -1 turns them straight up.")
          .facing("face", &BranchPlacement::face,
                  "Direction that the children's upper faces turn to, whatever the light; \"surface\" turns them away "
                  "from the nearest surface of an obstacle, as leaves on a wall.")
          .number("face_share", &BranchPlacement::face_share, {.min = 0, .max = 1},
                  "Share of the turn of the children's upper faces to the direction of 'face': 0 leaves them as they "
                  "are, 1 turns them fully.")
          .number("face_light", &BranchPlacement::face_light, {.min = 0, .max = 1},
                  "Share of the turn of the children's upper faces to the light: 0 leaves them as they are, 1 turns "
                  "them fully.")
          .number("start", &BranchPlacement::start, {.min = 0, .max = 1},
                  "Share of each axis that is left free at its base.")
          .number("end", &BranchPlacement::end, {.min = 0, .max = 1},
                  "Position along each axis at which the sites end, as a share of its length.")
          .only_with("face", {"face_share"})
          .elsewhere({"from", "to", "kind"})
          .check(check_placement);
  return table;
}

void check_placement(const BranchPlacement& placement, const DocumentPath& path, ParameterReader& reader) {
  if (placement.density && placement.count) {
    reader.add_error(DocumentPath(path, "count"), "there is both a density and a count", "one of them");
  }
  if (placement.start > placement.end) {
    reader.add_error(DocumentPath(path, "start"), "'start' lies beyond 'end'", "a 'start' of at most 'end'");
  }
}

BranchPlacement overridden(BranchPlacement own, const BranchPlacement& link, const GivenRows& given) {
  if (given.contains("density") || given.contains("count")) {
    own.density.reset();
    own.count.reset();
  }
  if (given.contains("angle")) own.angle_tip.reset();
  given.copy(&link, &own);
  return own;
}

namespace {

constexpr double kDefaultDensity = 40;
constexpr std::uint64_t kSitesInPart = 65'536;  // sites of one part of a placement
constexpr float kDefaultTwig = 0.4F;            // metres from the tip that carry children by default

/// A straight piece of an axis that may carry children.
struct Piece {
  NodeIndex from = 0;
  NodeIndex to = 0;
  float begin = 0;  // share of the segment before the piece
  float end = 1;
  float arc = 0;       // arc length at `from` along the axis, metres
  float length = 0;    // length of the whole segment, metres
  double weight = 1;   // relative density
  double carried = 0;  // eligible length of the axis before this piece, weighted by density

  double eligible() const { return weight * length * (end - begin); }
};

struct AxisSites {
  std::vector<Piece> pieces;
  double eligible = 0;  // length that may carry children, weighted by the relative density
  float length = 0;     // length of the whole axis, metres
  std::uint64_t places = 0;
  double last = 1;  // size of the last place: its share of the full size
  std::uint64_t first_site = 0;
};

/// Returns for every node whether the segment that ends in the node may carry children.
std::vector<std::uint8_t> eligible_nodes(const Skeleton& skeleton, const SkeletonAxes& axes,
                                         const BranchPlacement& placement, const PlacementContext& context) {
  if (context.everywhere) return std::vector<std::uint8_t>(skeleton.node_count(), 1);
  if (placement.where) {
    return nodes_where(skeleton, axes, *placement.where, context.key_of_places().child("where"), context.scene);
  }
  if (!context.has_twigs) return std::vector<std::uint8_t>(skeleton.node_count(), 1);
  std::vector<std::uint8_t> eligible;
  for (const float distance : tip_distance(skeleton)) eligible.push_back(distance < kDefaultTwig ? 1 : 0);
  return eligible;
}

/// Returns the eligible pieces of one axis between `start` and `end`. The pieces of a lateral begin at its parent's
/// bark. `root_bark` is the depth of the bark over the skeleton's root, metres.
AxisSites measure_axis(const Skeleton& skeleton, std::span<const NodeIndex> nodes, const BranchPlacement& placement,
                       const std::vector<std::uint8_t>& eligible, float root_bark) {
  AxisSites places;
  places.length = axis_length(skeleton, nodes);
  const NodeIndex parent = nodes.empty() ? kNoNode : skeleton.parent[nodes.front()];
  const double bark = parent == kNoNode ? root_bark : skeleton.radius[parent];
  const double low = std::max(bark, placement.start * places.length);
  const double high = placement.end * places.length;
  float arc = 0;
  for (const NodeIndex node : nodes) {
    if (skeleton.is_root(node)) continue;
    const NodeIndex from = skeleton.parent[node];
    Piece piece{.from = from, .to = node, .arc = arc};
    piece.length = segment_length(skeleton, node);
    arc += piece.length;
    if (eligible[node] == 0 || piece.length <= 0) continue;
    piece.begin = static_cast<float>(std::clamp((low - piece.arc) / piece.length, 0.0, 1.0));
    piece.end = static_cast<float>(std::clamp((high - piece.arc) / piece.length, 0.0, 1.0));
    if (piece.end <= piece.begin) continue;
    const double middle = piece.arc + 0.5 * (piece.begin + piece.end) * piece.length;
    piece.weight = std::max(0.0, placement.spread(middle / places.length));
    if (!(piece.weight > 0)) continue;
    piece.carried = places.eligible;
    places.eligible += piece.eligible();
    places.pieces.push_back(piece);
  }
  return places;
}

/// Shares an exact count out over the axes by cumulated length. Returns the number of places, including places that are
/// still growing.
double share_count(std::vector<AxisSites>& axes, double count) {
  double whole = 0;
  for (const AxisSites& axis : axes) whole += axis.eligible;
  if (!(whole > 0)) return 0;
  const double below = std::floor(count), above = std::ceil(count);
  double before = 0, given_below = 0, given_above = 0, total = 0;
  for (AxisSites& axis : axes) {
    before += axis.eligible;
    const double due_below = std::floor(below * (before / whole) + 0.5);
    const double due_above = std::floor(above * (before / whole) + 0.5);
    const double of_below = due_below - given_below, of_above = due_above - given_above;
    const PartCount places(of_below + (count - below) * (of_above - of_below));
    axis.places = places.parts();
    axis.last = places.last();
    total += places.parts();
    given_below = due_below;
    given_above = due_above;
  }
  return total;
}

/// Shares sites out over the axes by density, or by an exact count. By density, the fraction of a site is decided at
/// random, so that short twigs get their share on average. Returns the number of sites, as a double so that nothing
/// overflows.
double count_places(std::vector<AxisSites>& axes, const BranchPlacement& placement, RandomKey key) {
  if (placement.count) return share_count(axes, placement.count->value) * placement.whorl;
  double total = 0;
  const double density = placement.density.value_or(kDefaultDensity);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const double expected = std::floor(axes[a].eligible * density + key.child(a).uniform(0));
    total += expected;
    axes[a].places = static_cast<std::uint64_t>(std::min(expected, 1e18));
  }
  return total * placement.whorl;
}

/// Returns the order of a skeleton's main axis. A stem that stands on another stem is a lateral of that stem.
int first_order(const Site& parent) { return parent.stem == kOnNoStem ? 0 : parent.order + 1; }

/// Computes the sites of one axis, from base to tip.
class AxisWriter {
 public:
  AxisWriter(const Skeleton& skeleton, const BranchPlacement& placement, const PlacementContext& context,
             AxisIndex axis, const AxisSites& sites)
      : skeleton_(skeleton),
        placement_(placement),
        context_(context),
        axis_(sites),
        key_(context.parent.key.child(axis)),
        places_(context.key_of_places().child(axis)) {
    if (axis_.places == 0) return;
    roll_ = placement_.roll.value_or(2 * kPi * places_.uniform(1));
    spacing_ = axis_.eligible / (static_cast<double>(axis_.places) - 1 + axis_.last);
    tangent_ = piece_tangent(axis_.pieces[0]);
    radial_ = first_radial(tangent_);
  }

  /// Writes the sites of the next `count` places.
  void write(std::uint64_t count, Site* out) {
    const auto whorl = static_cast<std::uint64_t>(placement_.whorl);
    for (const std::uint64_t end = next_ + count; next_ < end; ++next_) {
      // Walk to the piece with the next site, carrying the radial direction without twist.
      const double at = std::min((static_cast<double>(next_) + 0.5) * spacing_, axis_.eligible);
      while (piece_ + 1 < axis_.pieces.size() && at >= axis_.pieces[piece_ + 1].carried) {
        const Vec3 next = piece_tangent(axis_.pieces[++piece_]);
        radial_ = rotation_between(tangent_, next) * radial_;
        tangent_ = next;
      }
      const Piece& piece = axis_.pieces[piece_];
      const auto along = static_cast<float>(piece.begin + (at - piece.carried) / (piece.weight * piece.length));
      for (std::uint64_t w = 0; w < whorl; ++w) {
        const double azimuth = roll_ + static_cast<double>(next_) * placement_.divergence +
                               2 * kPi * static_cast<double>(w) / static_cast<double>(whorl);
        Site& site = *out++;
        site = context_.parent;
        site.i = static_cast<std::uint32_t>(next_ * whorl + w);
        site.n = static_cast<std::uint32_t>(axis_.places * whorl);
        site.part = static_cast<float>(1 - placement_.whorl * (1 - axis_.last));
        site.key = key_.child(site.i);
        fill(site, axis_, piece, std::clamp(along, 0.0F, 1.0F), rotation(tangent_, azimuth) * radial_, tangent_);
        if (next_ + 1 == axis_.places && axis_.last < 1) site.frame.axes *= static_cast<float>(axis_.last);
      }
    }
  }

 private:
  /// Returns the direction, perpendicular to the axis, from which rolls are measured.
  Vec3 first_radial(Vec3 tangent) const {
    if (!placement_.roll) return any_perpendicular(tangent);
    const Vec3 upper = context_.parent.frame.upper();
    return normalized_or(upper - glm::dot(upper, tangent) * tangent, any_perpendicular(tangent));
  }

  Vec3 piece_tangent(const Piece& piece) const {
    return normalized_or(skeleton_.position[piece.to] - skeleton_.position[piece.from], kUp);
  }

  void fill(Site& site, const AxisSites& axis, const Piece& piece, float along, Vec3 outward, Vec3 tangent) const {
    const bool lateral_base = skeleton_.axis[piece.from] != skeleton_.axis[piece.to];
    const float from_radius = lateral_base ? skeleton_.radius[piece.to] : skeleton_.radius[piece.from];
    site.radius = glm::mix(from_radius, skeleton_.radius[piece.to], along);
    site.length = axis.length;
    site.u = std::min(1.0F, (piece.arc + along * piece.length) / std::max(axis.length, 1e-20F));
    site.birth = skeleton_.birth[piece.to];
    site.order = static_cast<std::uint16_t>(first_order(context_.parent) + skeleton_.order[piece.to]);

    const Vec3 foot = glm::mix(skeleton_.position[piece.from], skeleton_.position[piece.to], along);
    site.frame.origin = foot;
    const double base = angle_of(site);
    const double tip = placement_.angle_tip.value_or(base);
    const double angle = context_.stance == BranchStance::along_axis
                             ? 0
                             : base + (tip - base) * site.u +
                                   placement_.angle_spread * places_.child(site.i).child("angle").uniform(0, -1, 1);
    const auto sine = static_cast<float>(math::sin(angle));
    const auto cosine = static_cast<float>(math::cos(angle));
    const Vec3 heading = cosine * tangent + sine * outward;
    const Vec3 upper = sine * tangent - cosine * outward;
    site.frame =
        frame_along(context_.stance == BranchStance::on_bark ? foot + site.radius * outward : foot, heading, upper);
    site.stem = context_.stem;
    site.node = piece.to;
    site.along = along;
    site.frame.axes = drooped(site.frame.axes, placement_.droop, context_.directions.gravity(site.frame.origin));
    Mat3& axes = site.frame.axes;
    if (placement_.face) {
      if (const auto way = faced(site.frame.origin)) {
        axes = rotation_toward(axes[2], *way, placement_.face_share, axes[1]) * axes;
      }
    }
    if (placement_.face_light > 0) {
      const FieldPull light = context_.directions.light(site.frame.origin);
      const double share = share_pulled(placement_.face_light, light.strength);
      axes = rotation_toward(axes[2], light.toward, share, axes[1]) * axes;
    }
    site.frame.axes *= static_cast<float>(std::max(0.0, placement_.size(site.u)));
  }

  /// Returns the angle between the axis at its base and the child at a site. Its expression sees the whole site except
  /// its orientation.
  double angle_of(const Site& site) const {
    const std::optional<Varying>& varying = placement_.angle.varying;
    if (!varying) return placement_.angle.plain;
    return VaryingValues(std::span(&*varying, 1), std::span(&site, 1), context_.time).value(0, 0);
  }

  /// Returns the direction to which an upper face at this position turns.
  std::optional<Vec3> faced(Vec3 position) const {
    if (!placement_.face->is_from_surface) return placement_.face->direction;
    return context_.obstacles->away_from_surface(position);
  }

  const Skeleton& skeleton_;
  const BranchPlacement& placement_;
  const PlacementContext& context_;
  const AxisSites& axis_;
  RandomKey key_;           // key of the children
  RandomKey places_;        // key of their positions
  double roll_ = 0;         // of the first site
  double spacing_ = 0;      // weighted length from place to place
  std::uint64_t next_ = 0;  // the next place
  std::size_t piece_ = 0;   // index of the piece with the last place
  Vec3 tangent_{0};         // direction of this piece
  Vec3 radial_{0};          // zero of the rolls on this piece
};

/// The sites of a whole skeleton, before they are computed.
struct PlannedSites {
  std::vector<AxisSites> axes;
  std::uint64_t count = 0;
};

}  // namespace

Mat3 drooped(const Mat3& axes, double droop, const FieldPull& gravity) {
  if (droop == 0) return axes;
  return rotation_toward(axes[1], gravity.toward, share_pulled(droop, gravity.strength), axes[0]) * axes;
}

std::vector<std::uint8_t> bearing_nodes(const Skeleton& skeleton, const BranchPlacement& placement,
                                        const PlacementContext& context) {
  return eligible_nodes(skeleton, SkeletonAxes(skeleton), placement, context);
}

namespace {

/// Shares the sites out over the axes. Throws InputError past the limit of instances.
PlannedSites plan_along(const Skeleton& skeleton, const BranchPlacement& placement, const PlacementContext& context) {
  if (placement.face && placement.face->is_from_surface &&
      (context.obstacles == nullptr || context.obstacles->empty())) {
    throw InputError(Diagnostic{.message = "there is no obstacle whose surface the children could face away from",
                                .expected = "an obstacle in the scene, or a direction [x, y, z]",
                                .path = context.path + ".face"});
  }
  const SkeletonAxes axes(skeleton);
  const std::vector<std::uint8_t> eligible = eligible_nodes(skeleton, axes, placement, context);
  const float root_bark = context.parent.stem == kOnNoStem ? 0 : context.parent.radius;
  std::vector<AxisSites> places(axes.count());
  parallel_for(axes.count(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a) {
      places[a] = measure_axis(skeleton, axes.of(static_cast<AxisIndex>(a)), placement, eligible, root_bark);
    }
  });

  const double total = count_places(places, placement, context.key_of_places());
  if (total > static_cast<double>(context.limits->instances)) {
    throw_limit("children", total, context.limits->instances, "instances",
                context.path + (placement.count ? ".count" : ".density"));
  }
  PlannedSites planned{.axes = std::move(places)};
  for (AxisSites& axis : planned.axes) {
    axis.first_site = planned.count;
    planned.count += axis.places * static_cast<std::uint64_t>(placement.whorl);
  }
  return planned;
}

/// Returns the sites of the axes from `begin` to before `end`.
std::vector<Site> sites_of_axes(const Skeleton& skeleton, const BranchPlacement& placement,
                                const PlacementContext& context, const PlannedSites& planned, std::size_t begin,
                                std::size_t end) {
  const auto first_of = [&](std::size_t axis) {
    return axis < planned.axes.size() ? planned.axes[axis].first_site : planned.count;
  };
  std::vector<Site> out(first_of(end) - first_of(begin));
  parallel_for(end - begin, 16, [&](std::size_t from, std::size_t to) {
    for (std::size_t a = begin + from; a < begin + to; ++a) {
      const AxisSites& axis = planned.axes[a];
      AxisWriter(skeleton, placement, context, static_cast<AxisIndex>(a), axis)
          .write(axis.places, out.data() + (axis.first_site - first_of(begin)));
    }
  });
  return out;
}

}  // namespace

std::vector<Site> place_along(const Skeleton& skeleton, const BranchPlacement& placement,
                              const PlacementContext& context) {
  const PlannedSites planned = plan_along(skeleton, placement, context);
  return sites_of_axes(skeleton, placement, context, planned, 0, planned.axes.size());
}

void place_in_parts(const Skeleton& skeleton, const BranchPlacement& placement, const PlacementContext& context,
                    FunctionRef<void(std::vector<Site>)> receive) {
  const PlannedSites planned = plan_along(skeleton, placement, context);
  const auto whorl = static_cast<std::uint64_t>(placement.whorl);
  for (std::size_t begin = 0, end = 0; begin < planned.axes.size(); begin = end) {
    // Compute short axes together.
    std::uint64_t count = 0;
    for (; end < planned.axes.size() && count + planned.axes[end].places * whorl <= kSitesInPart; ++end) {
      count += planned.axes[end].places * whorl;
    }
    if (end > begin) {
      receive(sites_of_axes(skeleton, placement, context, planned, begin, end));
      continue;
    }
    // Compute a long axis in parts.
    const AxisSites& axis = planned.axes[end++];
    AxisWriter writer(skeleton, placement, context, static_cast<AxisIndex>(begin), axis);
    for (std::uint64_t place = 0; place < axis.places; place += kSitesInPart / whorl) {
      const std::uint64_t places = std::min(kSitesInPart / whorl, axis.places - place);
      std::vector<Site> out(places * whorl);
      writer.write(places, out.data());
      receive(std::move(out));
    }
  }
}

std::vector<Site> tip_sites(const Skeleton& skeleton, std::uint64_t stem, const Site& parent) {
  const SkeletonAxes axes(skeleton);
  std::vector<Site> sites;
  for (AxisIndex a = 0; a < axes.count(); ++a) {
    const auto nodes = axes.of(a);
    const NodeIndex tip = nodes.back();
    const Vec3 from = skeleton.is_root(tip) ? skeleton.position[tip] : skeleton.position[skeleton.parent[tip]];
    const Vec3 heading = normalized_or(skeleton.position[tip] - from, normalized_or(parent.frame.heading(), kUp));
    Site& site = sites.emplace_back(parent);
    site.frame = frame_along(skeleton.position[tip], heading, any_perpendicular(heading));
    site.u = 1;
    site.length = axis_length(skeleton, nodes);
    site.radius = skeleton.radius[tip];
    site.birth = skeleton.birth[tip];
    site.order = static_cast<std::uint16_t>(first_order(parent) + skeleton.order[tip]);
    site.stem = stem;
    site.node = tip;
    site.along = 1;
  }
  for (std::size_t k = 0; k < sites.size(); ++k) {
    sites[k].i = static_cast<std::uint32_t>(k);
    sites[k].n = static_cast<std::uint32_t>(sites.size());
  }
  return sites;
}

}  // namespace meristem
