// SPDX-License-Identifier: Apache-2.0
// Fields that need no formula. Lengths are metres. Where a field has no direction, as in the point that it leads to, it
// is 0, and grows from there within a thousandth of a metre, or as its own form says.
//
// Based on: the world component of O. Deussen, Computergenerierte Pflanzen, 2003, sections 6.2 and 6.5, which names the
// cylinder field, the wind and the field that keeps plants out of a region; their forms are our own.
#pragma once

#include "meristem/base/frame.h"
#include "meristem/base/random.h"
#include "meristem/scene/field/vector_field.h"

namespace meristem {

/// The same everywhere.
class UniformField : public VectorField {
 public:
  explicit UniformField(Vec3 pull) : pull_(pull) {}
  Vec3 at(Vec3) const override { return pull_; }
  bool is_uniform() const override { return true; }

 private:
  Vec3 pull_;
};

/// Toward a point, of length 1; with a finite `reach` it falls with the distance and is half as long at `reach`.
class PointField : public VectorField {
 public:
  PointField(Vec3 point, double reach) : point_(point), reach_(reach) {}
  Vec3 at(Vec3 position) const override;

 private:
  DVec3 point_;
  double reach_;  // may be infinite
};

/// A line in space: a point and a unit vector.
struct FieldAxis {
  Vec3 point{0};
  Vec3 direction = kUp;
};

/// Toward the surface of an endless cylinder: inward outside it and outward inside, of length 1, which falls evenly to
/// 0 over the last `edge` metres on both sides of the surface. So what follows the field comes to rest on the cylinder.
class CylinderField : public VectorField {
 public:
  /// `axis.direction` is a unit vector, `radius` at least 0 and `edge` above 0.
  CylinderField(FieldAxis axis, double radius, double edge) : axis_(axis), radius_(radius), edge_(edge) {}
  Vec3 at(Vec3 position) const override;

 private:
  FieldAxis axis_;
  double radius_;
  double edge_;
};

/// Around an axis, counter-clockwise seen against its direction: of length 1 outside of the core, and rising evenly
/// from the axis to there.
class VortexField : public VectorField {
 public:
  VortexField(FieldAxis axis, double core) : axis_(axis), core_(core) {}
  Vec3 at(Vec3 position) const override;

 private:
  FieldAxis axis_;
  double core_;  // metres, above 0
};

/// A wind: uniform but for gusts, which noise makes, of which one is about `size` metres long, and which drift with the
/// wind by `drift` metres from where they were.
struct Gusts {
  double share = 0;  ///< by how much of its length the wind changes in each direction
  double size = 1;   ///< metres, above 0
  double drift = 0;  ///< metres
  RandomKey key = RandomKey();
};

class WindField : public VectorField {
 public:
  WindField(Vec3 wind, const Gusts& gusts) : wind_(wind), gusts_(gusts) {}
  Vec3 at(Vec3 position) const override;
  bool is_uniform() const override { return gusts_.share == 0; }

 private:
  Vec3 wind_;
  Gusts gusts_;
};

/// A field of another frame, times `strength`. The frame turns and moves it; what the frame scales are the field's
/// places, not its lengths.
class PlacedField : public VectorField {
 public:
  /// The frame's axes are independent.
  PlacedField(FieldPointer field, const Frame& frame, double strength);
  Vec3 at(Vec3 position) const override;
  bool is_uniform() const override { return field_->is_uniform(); }

 private:
  FieldPointer field_;
  Vec3 origin_;
  Mat3 back_;  // from the world's directions to the field's
  Mat3 turn_;  // and forth, with the strength
};

/// Two fields together.
class SumField : public VectorField {
 public:
  SumField(FieldPointer one, FieldPointer other) : one_(std::move(one)), other_(std::move(other)) {}
  Vec3 at(Vec3 position) const override { return one_->at(position) + other_->at(position); }
  bool is_uniform() const override { return one_->is_uniform() && other_->is_uniform(); }

 private:
  FieldPointer one_;
  FieldPointer other_;
};

}  // namespace meristem
