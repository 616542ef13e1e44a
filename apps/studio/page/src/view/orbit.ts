// SPDX-License-Identifier: Apache-2.0
// A camera that orbits a point. Angles in degrees: azimuth of the camera from north over east, altitude above the
// horizon.
import * as three from 'three';

import type { ExportCamera } from '../server/protocol.ts';

export interface CameraState {
  azimuth: number;
  altitude: number;
  distance: number;
  target: [number, number, number];
  field_of_view?: number; // vertical angle, degrees; missing: the default
}

export const kFieldOfView = 32;
const kRadians = Math.PI / 180;
const kCrownReach = 0.72; // extent of a round crown toward the corners of its box

export class Orbit {
  readonly camera = new three.PerspectiveCamera(kFieldOfView, 1, 0.01, 1000);
  private azimuth_ = 155;
  private altitude_ = 12;
  private distance_ = 10;
  private field_of_view_ = kFieldOfView;
  private shows_corners_ = false; // true: the last fit included the corners of the box
  private readonly target_ = new three.Vector3(0, 1, 0);

  get state(): CameraState {
    return {
      azimuth: this.azimuth_,
      altitude: this.altitude_,
      distance: this.distance_,
      target: this.target_.toArray(),
      field_of_view: this.field_of_view_,
    };
  }
  /// The camera in the form of documents and exports.
  get as_document(): ExportCamera {
    return {
      position: this.camera.position.toArray(),
      target: this.target_.toArray(),
      field_of_view: this.field_of_view_,
    };
  }
  get distance(): number {
    return this.distance_;
  }
  get azimuth(): number {
    return this.azimuth_;
  }
  get target(): three.Vector3 {
    return this.target_;
  }
  /// Height of the picture at the point that the camera looks at, metres.
  get height_at_target(): number {
    return 2 * this.distance_ * this.slope;
  }

  /// Takes over the pose of another camera. Returns true if this changed anything.
  follow(other: Orbit): boolean {
    if (JSON.stringify(other.state) === JSON.stringify(this.state)) return false;
    [this.azimuth_, this.altitude_, this.distance_, this.field_of_view_] = [
      other.azimuth_,
      other.altitude_,
      other.distance_,
      other.field_of_view_,
    ];
    this.target_.copy(other.target_);
    this.place();
    return true;
  }

  /// Restores a pose.
  look(state: CameraState): void {
    [this.azimuth_, this.altitude_, this.distance_] = [
      state.azimuth,
      Math.min(89.5, Math.max(-89.5, state.altitude)),
      state.distance,
    ];
    this.target_.fromArray(state.target);
    this.open_to(state.field_of_view ?? kFieldOfView);
  }

  /// Sets the field of view; the camera stays in place.
  open_to(field_of_view: number): void {
    this.field_of_view_ = Math.min(150, Math.max(1, field_of_view));
    this.place();
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.place();
  }

  turn(degrees_east: number, degrees_up: number): void {
    this.azimuth_ = (this.azimuth_ + degrees_east + 360) % 360;
    this.altitude_ = Math.min(89.5, Math.max(-89.5, this.altitude_ + degrees_up));
    this.place();
  }

  look_from(azimuth: number, altitude: number): void {
    this.azimuth_ = azimuth;
    this.altitude_ = Math.min(89.5, Math.max(-89.5, altitude));
    this.place();
  }

  zoom(factor: number): void {
    this.distance_ = Math.min(5000, Math.max(0.005, this.distance_ * factor));
    this.place();
  }

  /// Moves the camera sideways by shares of the picture's height.
  pan(right: number, up: number): void {
    const height = this.height_at_target;
    const [x, y] = [new three.Vector3(), new three.Vector3()];
    this.camera.matrixWorld.extractBasis(x, y, new three.Vector3());
    this.target_.addScaledVector(x, right * height).addScaledVector(y, up * height);
    this.place();
  }

  /// Moves the camera until the box fills the picture. The corners of the box around a crown are empty and may be left
  /// out. The direction of view stays.
  fit(box: three.Box3, shows_corners = this.shows_corners_): void {
    if (box.isEmpty()) return;
    this.shows_corners_ = shows_corners;
    box.getCenter(this.target_);
    this.place();
    this.distance_ = this.distance_for(box, shows_corners);
    this.place();
  }

  /// Returns the distance from the middle of the box at which it fills the picture.
  distance_for(box: three.Box3, shows_corners = false): number {
    // The box is projected by the camera's rotation only, so that a repeated fit changes nothing.
    const inverse = new three.Matrix4().lookAt(this.way_to_eye(), new three.Vector3(), this.camera.up).transpose();
    const tan_y = this.slope * 0.94;
    const tan_x = tan_y * this.camera.aspect;
    // The corners of the box around a crown are empty; the corners of the box around a field or a row of trees are not.
    const half = box.getSize(new three.Vector3()).multiplyScalar(0.5);
    const reach = !shows_corners && half.y > 0.6 * Math.max(half.x, half.z) ? kCrownReach : 1;
    let distance = 0.01;
    // Round crowns reach the sides of the box at half their height.
    const girth = [0, 1, 2, 3, 4, 5, 6, 7].map(
      (k) => new three.Vector3(Math.cos(k * 45 * kRadians), 0, Math.sin(k * 45 * kRadians)),
    );
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(
      (k) => new three.Vector3(k & 1 ? reach : -reach, k & 2 ? 1 : -1, k & 4 ? reach : -reach),
    );
    for (const share of [...corners, ...girth]) {
      const point = share.multiply(half).applyMatrix4(inverse);
      distance = Math.max(distance, point.z + Math.abs(point.x) / tan_x, point.z + Math.abs(point.y) / tan_y);
    }
    return distance;
  }

  /// Half of the picture's height, one metre before the camera.
  private get slope(): number {
    return Math.tan((this.field_of_view_ / 2) * kRadians);
  }

  /// Returns the unit vector from the target to the camera. North is -z and east +x.
  private way_to_eye(): three.Vector3 {
    const [azimuth, altitude] = [this.azimuth_ * kRadians, this.altitude_ * kRadians];
    return new three.Vector3(
      Math.cos(altitude) * Math.sin(azimuth),
      Math.sin(altitude),
      -Math.cos(altitude) * Math.cos(azimuth),
    );
  }

  private place(): void {
    this.camera.position.copy(this.target_).addScaledVector(this.way_to_eye(), this.distance_);
    this.camera.near = this.distance_ / 200;
    this.camera.far = this.distance_ * 60;
    this.camera.fov = this.field_of_view_;
    this.camera.lookAt(this.target_);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }
}
