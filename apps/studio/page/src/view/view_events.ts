// SPDX-License-Identifier: Apache-2.0
// What a view tells of itself and of hands.
import type { CameraState } from './orbit.ts';

export interface ViewFacts {
  camera: CameraState;
  metres_per_pixel: number; // at the point that the camera looks at
}

export interface ViewEvents {
  /// After each picture.
  drawn(facts: ViewFacts): void;
  /// The graphics card has lost all, and has come back.
  restored(): void;
  /// Somebody has clicked at a component, or at none.
  clicked?(found: SeenInstance | null): void;
  /// Enter, while the view has the keyboard.
  entered?(): void;
  /// The pointer rests on a component, at pixels of the canvas; null: it has gone on.
  pointed?(at: { component: string; x: number; y: number } | null): void;
}

/// An instance that is seen at a pixel.
export interface SeenInstance {
  component: string;
  frame: number[]; // three rows of a 3x4 matrix, from its mesh to the world
  position: [number, number, number]; // of what was hit, in the world
}
