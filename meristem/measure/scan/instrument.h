// SPDX-License-Identifier: Apache-2.0
// Scanners as data: how they sweep, how wide their beams are, what they make of several surfaces in one beam.
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// Classes of scanners. The first two turn about the vertical and sweep up and down; a drone sweeps across the line
/// that it flies; a depth camera sees a raster of pixels at once.
enum class ScannerClass {
  terrestrial,   ///< time of flight with several returns
  phase,         ///< phase shift: one return, all surfaces in the beam mixed
  drone,         ///< time of flight from above, in lines
  depth_camera,  ///< structured light or time of flight over a picture
};

/// The numbers of a scanner. Angles in radians.
struct Instrument {
  ScannerClass kind = ScannerClass::terrestrial;  ///< class of the scanner

  // Which ways it looks.
  double step = radians(0.04);   ///< between pulses, both ways; of a drone, across its line
  double lowest = radians(-40);  ///< altitude at which its upward sweeps begin; terrestrial and phase alone
  double highest = radians(60);  ///< altitude at which they end
  double field = radians(80);    ///< across, of a drone's line and a camera's picture
  int columns = 640;             ///< pixels of a camera
  int rows = 480;                ///< pixels of a camera
  double altitude = 50;          ///< of a drone's flight above y = 0, metres
  double line_spacing = 15;      ///< between its lines, metres
  double advance = 0.04;         ///< that it flies from one sweep to the next, metres
  double heading = 0;            ///< azimuth of its lines, from north over east

  // What a pulse is.
  double divergence = 0.35;      ///< full angle of the beam at 1/e² of its strength, milliradians
  double exit_diameter = 0.007;  ///< of the beam where it leaves, at 1/e², metres
  int rays = 19;                 ///< that stand for the beam: raised, edges and returns are finer and slower

  // What comes back.
  int returns = 4;          ///< most returns of a pulse; the nearest are kept
  double resolution = 0.8;  ///< metres: surfaces nearer to each other along the beam make one return
  double threshold = 0.05;  ///< least share of the beam that makes a return
  double noise = 0.005;     ///< deviation of ranges, metres
  double noise_growth = 0;  ///< what this grows by with the square of the range, metres per square metre
  double nearest = 1.5;     ///< least range, metres
  double farthest = 350;    ///< greatest range, metres

  bool operator==(const Instrument&) const = default;

  /// Metres across the beam at a distance: 4 times the deviation of its strength, both ways from its axis, which of a
  /// Gaussian beam is the diameter at 1/e².
  double footprint(double distance) const { return exit_diameter + 1e-3 * divergence * distance; }
};

/// Numbers of a well-known scanner of each class, as its maker or others have published them:
///
/// | class | after |
/// | --- | --- |
/// | terrestrial | RIEGL VZ-400, data sheet |
/// | phase | FARO Focus3D X 130, data sheet; a quarter of the full resolution |
/// | drone | RIEGL VUX-1UAV, data sheet; the exit diameter is not published |
/// | depth_camera | Microsoft Kinect: C. Nguyen, S. Izadi, D. Lovell, 2012 (noise), without their offset of 0.4 m |
Instrument instrument_of(ScannerClass kind);

}  // namespace meristem
