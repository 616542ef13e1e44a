// SPDX-License-Identifier: Apache-2.0
// Operations on self-organizing trees as parameters of documents: when, on which shoots, and what.
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

/// The common parameters of all kinds of operations.
struct OperationParameters {
  std::optional<int> at;
  int from = 1;
  int every = 1;
  std::optional<int> to;
  std::optional<SiteCondition> when;
  bool once = false;
  enum class Season { winter, summer };
  Season season = Season::winter;
  std::string shoots;
  std::optional<int> tree;
  bool off = false;
  ShootChoice chosen;  ///< parsed from `shoots`
  std::string path;    ///< in the document
};

struct BudParameters {
  CutOperation::Toward toward = CutOperation::Toward::down;
  Vec3 direction{0, 1, 0};
  int window = 0;
};

struct CutParameters : OperationParameters {
  std::optional<int> above;
  std::optional<ParameterFormula> above_lateral;
  std::optional<BudParameters> to_bud;
  std::optional<CrownParameters> outside;
  bool leader = true;
  double stub = 0;
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
  double wires = 0;  ///< visible length of the wires on each side, metres
  LayersParameters() { shoots = "leader"; }
};

struct SupportParameters : OperationParameters {
  std::vector<Vec3> line;
  std::string named;
  double weight = 6;
  double thickness = 0;  ///< visible thickness, metres
  SupportParameters() { shoots = "leader"; }
};

struct MarkParameters : OperationParameters {
  double chance = 1;
  std::string state = "marked";
  std::uint32_t number = 0;  ///< number of the mark in the list of operations
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
  std::optional<ShootChoice> anchor_shoots;  ///< parsed from `anchor`, unless it is the ground
};

using AnyOperation = std::variant<CutParameters, SpurParameters, LimitParameters, LayersParameters, SupportParameters,
                                  MarkParameters, GirdleParameters, BendParameters, TieParameters>;

const ParameterTable& operation_table();  ///< table for every kind of operation
const ElementKinds& operation_kinds();    ///< names of the alternatives of AnyOperation

/// Returns the common parameters of an operation.
const OperationParameters& common_of(const AnyOperation& operation);
OperationParameters& common_of(AnyOperation& operation);

/// Returns the names of the marks of a list, by number. Conditions may use them.
std::vector<std::string> mark_words(const std::vector<AnyOperation>& operations);
/// Compiles the expressions over shoots of a list of operations. `words` are the marks of the component; `path` is the
/// list's path.
void prepare_operations(std::vector<AnyOperation>& operations, const std::vector<std::string>& words,
                        const DocumentPath& path, ParameterReader& reader);

/// Returns the operation of checked parameters. `axes` are the axes of the component's frame.
TreeOperation build_operation(const AnyOperation& form, const Mat3& axes);

/// A visible pole or wire of an operation.
struct SeenLine {
  std::vector<Vec3> points;  ///< metres from the root, in the component's frame
  double radius = 0.005;
};
/// Returns the visible lines of an operation; `length` is the length of a metamer.
std::vector<SeenLine> seen_lines(const AnyOperation& form, double length);

/// Returns true if a text has the form of a shoot's name: `main`, `main.4.2`.
bool is_shoot_name(std::string_view text);

}  // namespace meristem
