// SPDX-License-Identifier: Apache-2.0
// Scanners as data: how they sweep, how wide their beams are, and how they treat several surfaces in one beam.
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// Classes of scanners. Terrestrial and phase scanners turn about the vertical and sweep up and down. A drone sweeps
/// across its flight line. A depth camera records a raster of pixels at once.
enum class ScannerClass {
  terrestrial,   ///< time of flight with several returns
  phase,         ///< phase shift: one return, all surfaces in the beam mixed
  drone,         ///< time of flight from above, in lines
  depth_camera,  ///< structured light or time of flight over a picture
};

/// The properties of a scanner. Angles are in radians.
struct ScanInstrument {
  ScannerClass kind = ScannerClass::terrestrial;  ///< class of the scanner

  // The directions of the pulses.
  double step = radians(0.04);   ///< angle between pulses in both directions; for a drone, across its line
  double lowest = radians(-40);  ///< altitude at which upward sweeps begin; used only by terrestrial and phase scanners
  double highest = radians(60);  ///< altitude at which upward sweeps end
  double field = radians(80);    ///< angle across a drone's line or a camera's picture
  int columns = 640;             ///< pixels of a camera
  int rows = 480;                ///< pixels of a camera
  double altitude = 50;          ///< height of a drone's flight above y = 0, metres
  double line_spacing = 15;      ///< distance between the lines of a drone, metres
  double advance = 0.04;         ///< distance that a drone flies from one sweep to the next, metres
  double heading = 0;            ///< azimuth of the lines of a drone, from north over east

  // The beam of a pulse.
  double divergence = 0.35;      ///< full angle of the beam at 1/e² of its strength, milliradians
  double exit_diameter = 0.007;  ///< diameter of the beam at the aperture, at 1/e², metres
  int rays = 19;                 ///< rays per beam; a larger number gives finer edges and returns, and takes longer

  // The returns of a pulse.
  int returns = 4;          ///< maximum number of returns of a pulse; the nearest are kept
  double resolution = 0.8;  ///< metres; surfaces that are nearer to each other along the beam give one return
  double threshold = 0.05;  ///< minimum share of the beam that gives a return
  double noise = 0.005;     ///< standard deviation of ranges, metres
  double noise_growth = 0;  ///< growth of the standard deviation with the square of the range, metres per square metre
  double nearest = 1.5;     ///< minimum range, metres
  double farthest = 350;    ///< maximum range, metres

  bool operator==(const ScanInstrument&) const = default;

  /// Returns the width of the beam at a distance, in metres: 4 times the standard deviation of its strength across. For
  /// a Gaussian beam this is the diameter at 1/e².
  double footprint(double distance) const { return exit_diameter + 1e-3 * divergence * distance; }
};

/// Returns the properties of a well-known scanner of each class, as its maker or others have published them:
///
/// | class | source |
/// | --- | --- |
/// | terrestrial | RIEGL VZ-400, data sheet |
/// | phase | FARO Focus3D X 130, data sheet; a quarter of the full resolution |
/// | drone | RIEGL VUX-1UAV, data sheet; the exit diameter is not published |
/// | depth_camera | Microsoft Kinect: C. Nguyen, S. Izadi, D. Lovell, 2012 (noise), without their offset of 0.4 m |
ScanInstrument instrument_of(ScannerClass kind);

}  // namespace meristem
