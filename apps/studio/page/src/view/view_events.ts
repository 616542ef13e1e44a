// SPDX-License-Identifier: Apache-2.0
// Events of a view: pictures, and actions of the user.
import type { CameraState } from './orbit.ts';

export interface ViewFacts {
  camera: CameraState;
  metres_per_pixel: number; // at the point that the camera looks at
}

export interface ViewEvents {
  /// Called after each picture.
  drawn(facts: ViewFacts): void;
  /// The graphics card has lost all data and is available again.
  restored(): void;
  /// The user has clicked on a component, or on nothing.
  clicked?(found: SeenInstance | null): void;
  /// Enter was pressed while the view has the focus.
  entered?(): void;
  /// The pointer rests on a component, at pixels of the canvas. Null: it has moved on.
  pointed?(at: { component: string; x: number; y: number } | null): void;
}

/// An instance that is visible at a pixel.
export interface SeenInstance {
  component: string;
  frame: number[]; // three rows of a 3x4 matrix, from its mesh to the world
  position: [number, number, number]; // position of the hit in the world
}
