// SPDX-License-Identifier: Apache-2.0
// Draws a word in one pass with a state machine, the turtle. A stack holds the states of open branches. See turtle.h.
#include "meristem/grow/lsystem/turtle.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "meristem/base/degrees.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/math.h"
#include "meristem/grow/lsystem/apical_axes.h"
#include "meristem/grow/lsystem/turtle_letters.h"
#include "meristem/plant/further_columns.h"

namespace meristem {

namespace {

constexpr std::size_t kBlock = 65'536;       // modules between two checks of progress
constexpr double kParallel = 1e-9;           // sine of an angle below which directions count as parallel
constexpr double kStraightUp = 1e-6;         // sine of the angle to the vertical below which `$` has no effect
constexpr double kFarthest = 1e9;            // metres; limit for the precision of squared floats
constexpr std::size_t kDeepest = 1'000'000;  // nested brackets
constexpr double kShortest = 1e-9;           // metres; shorter segments make no node
constexpr std::size_t kMaxCorners = 2000;
constexpr std::size_t kFewestCorners = 3;  // of a polygon

/// Rotates a and b in their plane, a toward b.
void turn(DVec3& a, DVec3& b, double cosine, double sine) {
  const DVec3 turned = cosine * a + sine * b;
  b = cosine * b - sine * a;
  a = turned;
}

struct State {
  DVec3 position{0};
  DVec3 heading{0}, left{0}, up{0};  // unit vectors, right-handed
  double elevation = 0, azimuth = 0;
  double width = 0;
  NodeIndex node = kNoNode;
  std::uint32_t gap = 0;  // number of preceding moves without a segment
  std::uint32_t colour = 0;
  bool begins_branch = false;  // true if the next segment is the first after a [
};

class Turtle {
 public:
  Turtle(const Word& word, const Alphabet& alphabet, const TurtleParameters& parameters, const Frame& start,
         const std::string& path)
      : word_(word),
        parameters_(parameters),
        path_(path),
        is_polar_(parameters.reading == TurtleParameters::Reading::polar) {
    for (std::size_t k = 0; k < alphabet.size(); ++k) {
      meanings_.push_back(meaning_of(alphabet[static_cast<LetterIndex>(k)]));
    }
    const DVec3 heading(start.heading());
    scale_ = glm::length(heading);
    state_.position = DVec3(start.origin);
    state_.heading = heading / scale_;
    const DVec3 right(normalized_or(start.right(), any_perpendicular(Vec3(state_.heading))));
    state_.left = -glm::normalize(right - glm::dot(right, state_.heading) * state_.heading);
    state_.up = glm::cross(state_.heading, state_.left);
    base_ = glm::dmat3(-state_.left, state_.heading, state_.up);
    state_.width = parameters.width;
    count_modules();
    if (is_polar_) aim();
  }

  std::uint64_t segments() const { return segments_; }
  std::uint64_t instances() const { return instances_; }

  WordDrawing run(Progress& progress) {
    make_room(segments_ + 1);
    const std::size_t count = word_.module_count();
    progress.begin("drawing", count);
    const double* parameter = word_.parameters.data();
    for (std::size_t begin = 0; begin < count; begin = at_) {
      const std::size_t end = std::min(begin + kBlock, count);
      for (at_ = begin; at_ < end; ++at_) {
        LetterMeaning& meaning = meanings_[word_.letters[at_]];
        act(meaning, parameter);
        parameter += meaning.arity;
      }
      progress.advance(at_ - begin);
    }
    if (!open_.empty()) throw_error("the word leaves a polygon open", "a } for each {");
    make_room(nodes_);
    assign_apical_axes(drawing_.skeleton, begins_branch_);
    drawing_.skeleton.extra.emplace(kEndColumn, std::move(ends_));
    return std::move(drawing_);
  }

 private:
  /// Counts the modules for the limits before drawing anything. Few letters matter, and searching a word for a letter
  /// is fast.
  void count_modules() {
    for (std::size_t k = 0; k < meanings_.size(); ++k) {
      const auto letter = static_cast<LetterIndex>(k);
      const auto count = [&] {
        return static_cast<std::uint64_t>(std::count(word_.letters.begin(), word_.letters.end(), letter));
      };
      const TurtleAction action = meanings_[k].action;
      if (action == TurtleAction::draw) segments_ += count();
      if (action == TurtleAction::place || action == TurtleAction::begin_polygon) instances_ += count();
      if (action == TurtleAction::width && std::ranges::find(word_.letters, letter) != word_.letters.end()) {
        decays_ = false;
      }
    }
  }

  /// Resizes all columns, so that nodes can be written by index instead of being appended column by column.
  void make_room(std::size_t nodes) {
    Skeleton& skeleton = drawing_.skeleton;
    skeleton.parent.resize(nodes);
    skeleton.position.resize(nodes);
    skeleton.radius.resize(nodes);
    skeleton.axis.resize(nodes);
    skeleton.order.resize(nodes);
    skeleton.birth.resize(nodes);
    drawing_.module_of_node.resize(nodes);
    begins_branch_.resize(nodes);
    ends_.resize(nodes);
  }

  /// Executes a module. `parameter` points to its first parameter, and moves on if the next module is also consumed.
  void act(LetterMeaning& meaning, const double*& parameter) {
    const auto value = [&](double otherwise) { return meaning.arity > 0 ? parameter[0] : otherwise; };
    switch (meaning.action) {
      case TurtleAction::none:
        break;
      case TurtleAction::draw:
        segment(value(parameters_.length));
        if (meaning.records) corner();
        break;
      case TurtleAction::move:
        go(value(parameters_.length));
        state_.node = kNoNode;
        state_.gap = static_cast<std::uint32_t>(root_after_gap_.size());
        root_after_gap_.push_back(kNoNode);
        if (meaning.records) corner();
        break;
      case TurtleAction::yaw:
        yaw(meaning, value(is_polar_ ? parameters_.azimuth : parameters_.angle));
        break;
      case TurtleAction::pitch:
        pitch(meaning, value(parameters_.angle));
        break;
      case TurtleAction::roll:
        if (is_polar_) break;
        look_up(meaning, value(parameters_.angle));
        turn(state_.left, state_.up, meaning.cosine, meaning.sine);
        break;
      case TurtleAction::about:
        turn_about(value(180));
        break;
      case TurtleAction::level:
        if (!is_polar_) level();
        break;
      case TurtleAction::width:
        if (meaning.arity > 0) {
          state_.width = std::abs(parameter[0]);
        } else {
          state_.width *= meaning.sign > 0 ? parameters_.thinner : 1 / parameters_.thinner;
        }
        break;
      case TurtleAction::colour:
        state_.colour =
            meaning.arity > 0 ? static_cast<std::uint32_t>(std::clamp(parameter[0], 0.0, 1e9)) : state_.colour + 1;
        break;
      case TurtleAction::push:
        if (stack_.size() == kDeepest) {
          fail("opens too many brackets", fmt::format("at most {} in one another", kDeepest));
        }
        stack_.push_back(state_);
        state_.begins_branch = true;
        break;
      case TurtleAction::pop:
        pop();
        break;
      case TurtleAction::begin_polygon:
        begin_polygon();
        break;
      case TurtleAction::end_polygon:
        if (open_.empty()) fail("closes a polygon where none is open", "a { before each }");
        end_polygon();
        break;
      case TurtleAction::corner:
        corner();
        break;
      case TurtleAction::place:
        parameter += place(parameter);
        break;
    }
  }

  [[noreturn]] void fail(std::string_view what, std::string expected) const {
    throw_error(fmt::format("module {} of the word {}", at_ + 1, what), std::move(expected));
  }

  [[noreturn]] void throw_error(std::string message, std::string expected) const {
    throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .path = path_});
  }

  // --- Rotation

  /// Updates the letter's sine and cosine for its sign times `degrees`.
  static void look_up(LetterMeaning& meaning, double degrees) {
    if (degrees == meaning.angle) return;
    meaning.angle = degrees;
    meaning.sine = math::sin_deg(meaning.sign * degrees);
    meaning.cosine = math::cos_deg(degrees);
  }

  void yaw(LetterMeaning& meaning, double degrees) {
    if (is_polar_) {
      state_.azimuth += meaning.sign * degrees;
      return aim();
    }
    look_up(meaning, degrees);
    turn(state_.heading, state_.left, meaning.cosine, meaning.sine);
  }

  void pitch(LetterMeaning& meaning, double degrees) {
    if (is_polar_) {
      state_.elevation -= meaning.sign * degrees;
      return aim();
    }
    look_up(meaning, degrees);
    turn(state_.up, state_.heading, meaning.cosine, meaning.sine);
  }

  void turn_about(double degrees) {
    if (is_polar_) {
      state_.azimuth += degrees;
      return aim();
    }
    turn(state_.heading, state_.left, math::cos_deg(degrees), math::sin_deg(degrees));
  }

  /// Computes the frame from elevation and azimuth.
  void aim() {
    const double sine = math::sin_deg(state_.elevation);
    const double cosine = math::cos_deg(state_.elevation);
    const double east = math::cos_deg(state_.azimuth);
    const double north = math::sin_deg(state_.azimuth);
    state_.heading = base_ * DVec3(cosine * east, sine, -cosine * north);
    state_.left = base_ * DVec3(-north, 0, -east);
    state_.up = glm::cross(state_.heading, state_.left);
  }

  DVec3 down() const { return DVec3(parameters_.directions.down(Vec3(state_.position))); }

  /// Rolls until the left vector is horizontal. A vertical heading does not change, because every left vector is
  /// horizontal.
  void level() {
    const DVec3 left = glm::cross(-down(), state_.heading);
    const double length = glm::length(left);
    if (length < kStraightUp) return;
    state_.left = left / length;
    state_.up = glm::cross(state_.heading, state_.left);
  }

  void bend() {
    // Adding avoids negative zeros, so that gravity bends exactly like an equal tropism.
    const Vec3 position(state_.position);
    DVec3 pull = DVec3(parameters_.directions.light_sense().given_at(position));
    pull +=
        parameters_.tropism ? DVec3(*parameters_.tropism) : DVec3(parameters_.directions.gravity(position).vector());
    const DVec3 torque = glm::cross(state_.heading, pull);
    const double length = glm::length(torque);
    if (length < kParallel) return;
    const double angle = parameters_.elasticity * length;
    const double sine = math::sin(angle);
    const double cosine = math::cos(angle);
    const DVec3 axis = torque / length;
    const auto rotated = [&](DVec3 v) {
      return cosine * v + sine * glm::cross(axis, v) + (1 - cosine) * glm::dot(axis, v) * axis;
    };
    state_.heading = glm::normalize(rotated(state_.heading));
    const DVec3 left = rotated(state_.left);
    state_.left = glm::normalize(left - glm::dot(left, state_.heading) * state_.heading);
    state_.up = glm::cross(state_.heading, state_.left);
  }

  // --- Movement

  void go(double length) {
    state_.position += scale_ * length * state_.heading;
    const DVec3 far = glm::abs(state_.position);
    if (far.x <= kFarthest && far.y <= kFarthest && far.z <= kFarthest) return;
    fail("leads out of the world", fmt::format("positions within {:.0f} m of the origin", kFarthest));
  }

  void segment(double length) {
    const double begin_width = state_.width;
    if (decays_) state_.width *= stack_.empty() ? parameters_.trunk_decay : parameters_.branch_decay;
    if (std::abs(length) * scale_ < kShortest) return;
    if (state_.node == kNoNode) state_.node = root(begin_width);
    go(length);
    state_.node = add_node(state_.node, state_.width);
    begins_branch_[state_.node] = state_.begins_branch ? 1 : 0;
    state_.begins_branch = false;
    if (!is_polar_ && parameters_.elasticity != 0) bend();
  }

  /// Returns the root node at this position. All branches that start at a position without a node share it.
  NodeIndex root(double width) {
    NodeIndex& root = root_after_gap_[state_.gap];
    if (root == kNoNode) root = add_node(kNoNode, width);
    return root;
  }

  NodeIndex add_node(NodeIndex parent, double width) {
    if (!(scale_ * width <= kFarthest)) {
      fail("is wider than the world", fmt::format("a radius of at most {:.0f} m", kFarthest));
    }
    // Reserve more nodes, because roots are not counted as segments.
    if (nodes_ == begins_branch_.size()) make_room(nodes_ + nodes_ / 4 + 16);
    const NodeIndex node = nodes_++;
    drawing_.skeleton.parent[node] = parent;
    drawing_.skeleton.position[node] = Vec3(state_.position);
    drawing_.skeleton.radius[node] = static_cast<float>(scale_ * width);
    drawing_.module_of_node[node] = static_cast<std::uint32_t>(at_);
    if (!word_.births.empty()) drawing_.skeleton.birth[node] = static_cast<float>(word_.births[at_]);
    return node;
  }

  /// Every ] has its [: the reader checks brackets, and % cuts only up to the branch's end.
  void pop() {
    if (stack_.empty()) return;
    const NodeIndex end = node_here();
    if (end != kNoNode) ends_[end] = 1;
    const double elevation = state_.elevation;
    const double azimuth = state_.azimuth;
    state_ = stack_.back();
    stack_.pop_back();
    if (is_polar_ && !parameters_.stack_angles) {
      state_.elevation = elevation;
      state_.azimuth = azimuth;
      aim();
    }
  }

  // --- Polygons and placed components

  Frame frame() const { return {Mat3(glm::dmat3(-state_.left, state_.heading, state_.up)), Vec3(state_.position)}; }

  /// Returns the node at the turtle's position, or kNoNode if nothing has been drawn there.
  NodeIndex node_here() const { return state_.node == kNoNode ? root_after_gap_[state_.gap] : state_.node; }

  void begin_polygon() {
    open_.push_back(
        {.frame = frame(), .colour = state_.colour, .node = node_here(), .module = static_cast<std::uint32_t>(at_)});
  }

  void corner() {
    if (open_.empty()) return;
    if (open_.back().corners.size() == kMaxCorners) {
      fail("is one corner too many of a polygon", fmt::format("at most {}, and a }} for each {{", kMaxCorners));
    }
    open_.back().corners.emplace_back(state_.position);
  }

  void end_polygon() {
    const OpenPolygon& open = open_.back();
    if (open.corners.size() >= kFewestCorners) {
      drawing_.polygons.push_back({.first = static_cast<std::uint32_t>(drawing_.corners.size()),
                                   .count = static_cast<std::uint32_t>(open.corners.size()),
                                   .frame = open.frame,
                                   .colour = open.colour,
                                   .node = open.node,
                                   .module = open.module});
      drawing_.corners.insert(drawing_.corners.end(), open.corners.begin(), open.corners.end());
    }
    open_.pop_back();
  }

  /// Places a component. Skips the name module and returns its number of parameters.
  std::uint16_t place(const double* parameter) {
    // The parameters of the name follow the parameters of ~.
    const std::size_t next = at_ + 1;
    if (next == word_.module_count()) fail("is a ~ without a name", "the name of a component behind it");
    const LetterIndex letter = word_.letters[next];
    const double size = meanings_[letter].arity > 0 ? parameter[meanings_[word_.letters[at_]].arity] : 1;
    TurtleSite& position = drawing_.places.emplace_back();
    position.letter = letter;
    position.frame = frame();
    position.frame.axes *= static_cast<float>(scale_ * size);
    position.radius = static_cast<float>(scale_ * state_.width);
    position.node = node_here();
    position.module = static_cast<std::uint32_t>(next);
    at_ = next;
    return meanings_[letter].arity;
  }

  struct OpenPolygon {
    Frame frame;
    std::uint32_t colour = 0;
    NodeIndex node = kNoNode;
    std::uint32_t module = 0;
    std::vector<Vec3> corners{};
  };

  const Word& word_;
  const TurtleParameters& parameters_;
  const std::string& path_;
  bool is_polar_;
  bool decays_ = true;  // true if the word sets no widths
  std::uint64_t segments_ = 0;
  std::uint64_t instances_ = 0;  // number of polygons and placed components
  double scale_ = 1;
  glm::dmat3 base_{1};  // for the polar reading: right, heading and upper vectors at the start
  std::vector<LetterMeaning> meanings_;
  State state_;
  std::vector<State> stack_;
  std::vector<OpenPolygon> open_;
  std::vector<NodeIndex> root_after_gap_{kNoNode};  // by gap; the first is the start
  NodeIndex nodes_ = 0;                             // number of nodes drawn so far
  std::vector<std::uint8_t> begins_branch_;         // by node
  std::vector<float> ends_;                         // by node: 1 where a branch ends
  std::size_t at_ = 0;                              // position of the current module
  WordDrawing drawing_;
};

}  // namespace

WordDrawing draw(const Word& word, const Alphabet& alphabet, const TurtleParameters& parameters, const Frame& start,
                 const SizeLimits& limits, const std::string& path, Progress& progress) {
  Turtle turtle(word, alphabet, parameters, start, path);
  if (turtle.segments() > limits.nodes) {
    throw_limit("nodes", static_cast<double>(turtle.segments()), limits.nodes, "nodes", path);
  }
  if (turtle.instances() > limits.instances) {
    throw_limit("polygons and components", static_cast<double>(turtle.instances()), limits.instances, "instances",
                path);
  }
  return turtle.run(progress);
}

}  // namespace meristem
