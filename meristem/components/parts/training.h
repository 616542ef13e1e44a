// SPDX-License-Identifier: Apache-2.0
// Training systems: lists of operations, made from a few parameters.
#pragma once

#include <optional>
#include <vector>

#include "meristem/components/parts/operation_table.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"

namespace meristem {

struct Training {
  enum class Form { espalier, cordon, fan, spindle, open_vase, standard, half_standard, hedge };
  Form form = Form::espalier;
  int layers = 3;
  int spacing = 6;  ///< metamers
  int reach = 12;   ///< metamers
  int spurs = 2;    ///< metamers
  double azimuth = kPi / 2;
  double angle = radians(45);
  double weight = 6;
  std::optional<double> stem;  ///< metres; unset: the default of the form
  double height = 1.5;         ///< metres
  double width = 1;            ///< metres
  double depth = 0.6;          ///< metres
  int from = 1;                ///< iteration
  bool shown = true;

  std::vector<AnyOperation> operations{};  ///< the resulting operations
};

const ParameterTable& training_table();

/// Returns the operations of a training in the form of a document. `length` is the length of a metamer in metres.
Value::List training_operations(const Training& training, double length);

/// Sets the operations of a training.
void prepare_training(Training& training, double length, const DocumentPath& path, ParameterReader& reader);

}  // namespace meristem
