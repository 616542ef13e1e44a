// SPDX-License-Identifier: Apache-2.0
// The functions whose last bit differs between C libraries and processors (with and without fused multiply-add), in
// forms that use only operations IEEE 754 rounds exactly: add, subtract, multiply, divide, square root. Growth uses
// these, never the ones in <cmath>, so that a plant has the same bytes everywhere.
// Errors are below 4 units in the last place (measured: 1.1 for sin, cos, exp, log and pow, 3.4 for the others). Angles
// beyond 1.6e6 lose digits, as one turn is taken for a double then.
#pragma once

namespace meristem::math {

/// Sine of an angle in radians.
double sin(double radians);
/// Cosine of an angle in radians.
double cos(double radians);
/// Tangent of an angle in radians.
double tan(double radians);
/// Angle in [-pi/2, pi/2]; arguments outside [-1, 1] count as the nearer end.
double asin(double sine);
/// Angle in [0, pi]; arguments outside [-1, 1] count as the nearer end.
double acos(double cosine);
/// Angle in (-pi, pi]; 0 where both are 0.
double atan2(double y, double x);
/// e to the power x.
double exp(double x);
/// Natural logarithm; -infinity for 0, NaN below.
double log(double x);
/// x to the power y. For negative x only whole y are defined, else NaN.
double pow(double x, double y);

}  // namespace meristem::math
