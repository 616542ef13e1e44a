// SPDX-License-Identifier: Apache-2.0
// Operations on self-organizing trees as documents write them: when, on which shoots, what.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "meristem/components/parts/crown_table.h"
#include "meristem/graph/table/kinds.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/selection.h"
#include "meristem/grow/prune/operation.h"

namespace meristem {

/// What all kinds have.
struct OperationParameters {
  std::optional<int> at;
  int from = 1;
  int every = 1;
  std::optional<int> to;
  std::optional<Condition> when;
  bool once = false;
  enum class Season { winter, summer };
  Season season = Season::winter;
  std::string shoots;
  std::optional<int> tree;
  bool off = false;
  ShootChoice chosen;  ///< what `shoots` says
  std::string path;    ///< in the document
};

struct BudParameters {
  Cut::Toward toward = Cut::Toward::down;
  Vec3 direction{0, 1, 0};
  int window = 0;
};

struct CutParameters : OperationParameters {
  std::optional<int> above;
  std::optional<Formula> above_lateral;
  std::optional<BudParameters> to_bud;
  std::optional<CrownParameters> outside;
  bool leader = true;
};

struct SpurParameters : OperationParameters {
  int metamers = 2;
  SpurParameters() { shoots = "rank >= 2"; }
};

struct LimitParameters : OperationParameters {
  int metamers = 12;
  LimitParameters() { shoots = "rank == 1"; }
};

struct LayersParameters : OperationParameters {
  int count = 3;
  int metamers = 6;
  double azimuth = kPi / 2;
  double angle = 0;
  std::optional<double> angle_last;
  double weight = 6;
  double wires = 0;  ///< metres to each side that are seen
  LayersParameters() { shoots = "leader"; }
};

struct SupportParameters : OperationParameters {
  std::vector<Vec3> line;
  std::string named;
  double weight = 6;
  double thickness = 0;  ///< metres, of what is seen
  SupportParameters() { shoots = "leader"; }
};

struct MarkParameters : OperationParameters {
  double chance = 1;
  std::string state = "marked";
  std::uint32_t number = 0;  ///< of the state in the list of operations
};

struct GirdleParameters : OperationParameters {
  int below = 0;
  double share = 1;
  int iterations = 1;
};

struct BendParameters : OperationParameters {
  int below = 0;
  int metamers = 3;
  double inclination = 0;
  int iterations = 1;
};

struct TieParameters : OperationParameters {
  std::optional<int> below;
  std::string anchor = "ground";
  double length = 0;
  int iterations = 1;
  std::optional<ShootChoice> anchor_shoots;  ///< what `anchor` says, unless it is the ground
};

using AnyOperation = std::variant<CutParameters, SpurParameters, LimitParameters, LayersParameters, SupportParameters,
                                  MarkParameters, GirdleParameters, BendParameters, TieParameters>;

const ParameterTable& operation_table();  ///< of every kind of operation
const Kinds& operation_kinds();           ///< of the alternatives of AnyOperation

/// What all kinds have, of one.
const OperationParameters& common_of(const AnyOperation& operation);
OperationParameters& common_of(AnyOperation& operation);

/// The words of the marks of a list that its conditions may name, by their numbers.
std::vector<std::string> mark_words(const std::vector<AnyOperation>& operations);
/// Compiles what operations of a list say of shoots. `words` are those of the component's marks; `path` is the list's.
void prepare_operations(std::vector<AnyOperation>& operations, const std::vector<std::string>& words,
                        const DocumentPath& path, ParameterReader& reader);

/// The operation that a checked form means, for trees whose component's frame has these axes.
Operation build_operation(const AnyOperation& form, const Mat3& axes);

/// A pole or wire of an operation that is seen.
struct SeenLine {
  std::vector<Vec3> points;  ///< metres from the root, in the component's frame
  double radius = 0.005;
};
/// The lines of an operation that are seen; `length` is the length of a metamer.
std::vector<SeenLine> seen_lines(const AnyOperation& form, double length);

/// Whether a text has the form of a shoot's name: `main`, `main.4.2`.
bool is_shoot_name(std::string_view text);

}  // namespace meristem
