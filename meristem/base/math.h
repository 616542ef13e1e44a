// SPDX-License-Identifier: Apache-2.0
// Mathematical functions with equal bits on all machines. The functions in <cmath> differ in the last bit between C
// libraries and processors (with and without fused multiply-add). The functions here use only operations that IEEE 754
// rounds exactly: add, subtract, multiply, divide, square root. Growth must use these functions, so that a plant has
// equal bytes everywhere. Errors are below 4 units in the last place (measured: 1.1 for sin, cos, exp, log and pow, 3.4
// for the others). Angles beyond 1.6e6 lose digits, because one turn is then rounded to a double.
#pragma once

namespace meristem::math {

/// Returns the sine of an angle in radians.
double sin(double radians);
/// Returns the cosine of an angle in radians.
double cos(double radians);
/// Returns the tangent of an angle in radians.
double tan(double radians);
/// Returns an angle in [-pi/2, pi/2]. Arguments outside [-1, 1] are clamped.
double asin(double sine);
/// Returns an angle in [0, pi]. Arguments outside [-1, 1] are clamped.
double acos(double cosine);
/// Returns an angle in (-pi, pi]. Returns 0 if both arguments are 0.
double atan2(double y, double x);
/// Returns e to the power x.
double exp(double x);
/// Returns the natural logarithm: -infinity for 0, NaN for negative numbers.
double log(double x);
/// Returns x to the power y. Negative x need a whole y, else the result is NaN.
double pow(double x, double y);

}  // namespace meristem::math
