// SPDX-License-Identifier: Apache-2.0
// The part of the plant at a pixel of the view, which the user clicks or rests the pointer on.
import type { Orbit } from './orbit.ts';
import { Picker } from './picker.ts';
import type { PlantScene, SeenBatch } from './plant_scene.ts';
import type { ViewEvents } from './view_events.ts';

/// An instance of a drawn batch, and the position of the hit in the world.
export type PointedInstance = SeenBatch & { instance: number; position: [number, number, number] };

export class Pointing {
  private readonly picker_ = new Picker();

  constructor(
    private readonly plant_: PlantScene,
    private readonly orbit_: Orbit,
    private readonly canvas_: HTMLCanvasElement,
    private readonly events_: ViewEvents,
    private readonly ask_: () => void, // requests a picture
  ) {}

  /// Returns the batch and the instance at a pixel of the canvas.
  pick(x: number, y: number): PointedInstance | null {
    const { seen } = this.plant_;
    const size: [number, number] = [this.canvas_.clientWidth, this.canvas_.clientHeight];
    const found = this.picker_.pick(seen, this.orbit_.camera, [x, y], size);
    const batch = found ? seen[found.target] : undefined;
    return found && batch ? { ...batch, instance: found.instance, position: found.position } : null;
  }

  /// Reports and marks the clicked part. Reports null if nothing is there.
  click(x: number, y: number): void {
    if (!this.events_.clicked || this.plant_.seen.length === 0) return;
    const found = this.pick(x, y);
    if (found) {
      const { component, key, instance, position } = found;
      this.events_.clicked({ component, frame: this.plant_.frame_of(key, instance), position });
      this.plant_.mark(key, instance);
    } else {
      this.events_.clicked(null);
    }
    this.ask_();
  }

  /// Reports the part under the resting pointer.
  rest(x: number, y: number): void {
    const found = this.events_.pointed ? this.pick(x, y) : null;
    if (found) this.events_.pointed?.({ component: found.component, x, y });
  }
}
