// SPDX-License-Identifier: Apache-2.0
// Fields that need no formula. Lengths are in metres. At positions without a defined direction, such as the target
// point, a field is 0. From there it grows to its full value within a thousandth of a metre, or as its own formula
// says.
//
// Based on: the world component of O. Deussen, Computergenerierte Pflanzen, 2003, sections 6.2 and 6.5, which names the
// cylinder field, the wind and the field that keeps plants out of a region; the formulas are our own.
#pragma once

#include "meristem/base/frame.h"
#include "meristem/base/random.h"
#include "meristem/scene/field/vector_field.h"

namespace meristem {

/// A field that is equal at all positions.
class UniformField : public VectorField {
 public:
  /// `pull` has the strength of the field as its length.
  explicit UniformField(Vec3 pull) : pull_(pull) {}
  Vec3 at(Vec3) const override { return pull_; }
  bool is_uniform() const override { return true; }

 private:
  Vec3 pull_;
};

/// A field of length 1 toward a point. With a finite `reach`, its length falls with the distance and is 1/2 at `reach`.
class PointField : public VectorField {
 public:
  /// `point` in metres; an infinite `reach` gives equal strength at all distances.
  PointField(Vec3 point, double reach) : point_(point), reach_(reach) {}
  Vec3 at(Vec3 position) const override;

 private:
  DVec3 point_;
  double reach_;  // may be infinite
};

/// A line in space: a point and a unit vector.
struct FieldAxis {
  Vec3 point{0};         ///< metres
  Vec3 direction = kUp;  ///< unit vector
};

/// A field toward the surface of an infinite cylinder, inward outside and outward inside. Its length is 1 and falls
/// linearly to 0 over the last `edge` metres on both sides of the surface. Stems that follow the field come to rest on
/// the cylinder.
class CylinderField : public VectorField {
 public:
  /// `axis.direction` is a unit vector, `radius` is at least 0 and `edge` is above 0.
  CylinderField(FieldAxis axis, double radius, double edge) : axis_(axis), radius_(radius), edge_(edge) {}
  Vec3 at(Vec3 position) const override;

 private:
  FieldAxis axis_;
  double radius_;
  double edge_;
};

/// A field around an axis, counter-clockwise when seen against the axis's direction. Its length is 1 outside the core
/// and rises linearly from 0 at the axis.
class VortexField : public VectorField {
 public:
  /// `axis.direction` is a unit vector; `core` is the radius of the core in metres, above 0.
  VortexField(FieldAxis axis, double core) : axis_(axis), core_(core) {}
  Vec3 at(Vec3 position) const override;

 private:
  FieldAxis axis_;
  double core_;  // metres, above 0
};

/// Variation of a wind by noise. A gust is about `size` metres long. The noise is shifted along the wind by `drift`
/// metres.
struct WindGusts {
  double share = 0;             ///< largest change of the wind in each direction, as a share of its length
  double size = 1;              ///< metres, above 0
  double drift = 0;             ///< metres
  RandomKey key = RandomKey();  ///< selects the pattern of the gusts
};

/// A field along a wind, whose strength and direction vary by gusts.
class WindField : public VectorField {
 public:
  /// `wind` has the strength of the wind as its length.
  WindField(Vec3 wind, const WindGusts& gusts) : wind_(wind), gusts_(gusts) {}
  Vec3 at(Vec3 position) const override;
  bool is_uniform() const override { return gusts_.share == 0; }

 private:
  Vec3 wind_;
  WindGusts gusts_;
};

/// A field in another frame, times `strength`. The frame rotates and moves the field. Scaling changes positions, but
/// not the lengths of vectors.
class PlacedField : public VectorField {
 public:
  /// The frame's axes must be linearly independent.
  PlacedField(FieldPointer field, const Frame& frame, double strength);
  Vec3 at(Vec3 position) const override;
  bool is_uniform() const override { return field_->is_uniform(); }

 private:
  FieldPointer field_;
  Vec3 origin_;
  Mat3 back_;  // maps the world's directions to the field's
  Mat3 turn_;  // maps the field's directions to the world's and applies the strength
};

/// The sum of two fields.
class SumField : public VectorField {
 public:
  /// The fields must not be null.
  SumField(FieldPointer one, FieldPointer other) : one_(std::move(one)), other_(std::move(other)) {}
  Vec3 at(Vec3 position) const override { return one_->at(position) + other_->at(position); }
  bool is_uniform() const override { return one_->is_uniform() && other_->is_uniform(); }

 private:
  FieldPointer one_;
  FieldPointer other_;
};

}  // namespace meristem
