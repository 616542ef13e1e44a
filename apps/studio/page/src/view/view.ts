// SPDX-License-Identifier: Apache-2.0
// The 3D view: one canvas, which is drawn only when something has changed.
import * as three from 'three';

import type { Vec } from '../base/vec.ts';
import type { Packet } from '../server/packet.ts';
import { draws_by_software } from './budgets.ts';
import { CanvasPixels } from './canvas_pixels.ts';
import { Eye } from './eye.ts';
import { Ground } from './ground.ts';
import type { CameraState } from './orbit.ts';
import { kFieldOfView, Orbit } from './orbit.ts';
import { Overlays } from './overlays.ts';
import { PictureQueue } from './picture_queue.ts';
import type { Drawing } from './plant_scene.ts';
import { PlantScene } from './plant_scene.ts';
import { listen } from './pointer.ts';
import type { PointedInstance } from './pointing.ts';
import { Pointing } from './pointing.ts';
import { Sunlight } from './sunlight.ts';
import { Surroundings } from './surroundings.ts';
import type { SeenInstance, ViewEvents, ViewFacts } from './view_events.ts';

export type { SeenInstance, ViewEvents, ViewFacts };

const kAfterMove = 200; // ms without a camera movement until all pixels are drawn

export class View {
  readonly orbit = new Orbit();
  readonly eye: Eye;
  readonly plant: PlantScene;
  readonly overlays = new Overlays(() => this.ask());
  readonly is_software: boolean;
  frames_drawn = 0;
  private readonly sunlight_ = new Sunlight();
  private readonly renderer_: three.WebGLRenderer;
  private readonly scene_ = new three.Scene();
  readonly surroundings = new Surroundings(this.overlays);
  private readonly ground_ = new Ground();
  readonly bounds = new three.Box3(); // box around everything that is shown
  // Box to which the camera was fitted; empty after the user has moved the camera
  private readonly fitted_ = new three.Box3();
  private readonly pointing_: Pointing;
  private readonly queue_: PictureQueue;
  private readonly pixels_: CanvasPixels;
  private readonly sizes_ = new ResizeObserver(() => this.resize());
  private is_draft_ = false;
  private time_moves_ = false;
  private moves_until_ = 0; // a timer; 0: the camera does not move

  constructor(
    private readonly canvas_: HTMLCanvasElement,
    private readonly events_: ViewEvents,
  ) {
    this.eye = new Eye(this.orbit, canvas_);
    this.is_software = draws_by_software();
    this.renderer_ = new three.WebGLRenderer({
      canvas: canvas_,
      antialias: !this.is_software,
      alpha: true,
      powerPreference: 'high-performance',
    });
    this.renderer_.setClearColor(0, 0);
    this.pixels_ = new CanvasPixels(this.renderer_, this.is_software);
    this.queue_ = new PictureQueue(this.renderer_.getContext() as WebGL2RenderingContext, () => this.draw());
    this.plant = new PlantScene(this.sunlight_.light, this.is_software ? 1 : 4, () => this.ask());
    this.pointing_ = new Pointing(this.plant, this.orbit, canvas_, events_, () => this.ask());
    this.scene_.add(this.ground_.mesh, this.plant.root, this.overlays.root);
    this.scene_.matrixWorldAutoUpdate = false;
    listen(canvas_, this.orbit, {
      moved: () => this.move(),
      fit: () => this.fit(),
      entered: () => events_.entered?.(),
      clicked: (x, y) => this.pointing_.click(x, y),
      rested: (x, y) => this.pointing_.rest(x, y),
      went_on: () => events_.pointed?.(null),
    });
    canvas_.addEventListener('webglcontextrestored', () => {
      events_.restored();
      this.ask();
    });
    this.sizes_.observe(canvas_.parentElement ?? canvas_);
    this.resize();
  }

  /// Objects of three on the card, for tests.
  get counts(): object {
    const { geometries, textures } = this.renderer_.info.memory;
    return {
      geometries,
      textures,
      triangles: this.plant.triangles,
      frames: this.frames_drawn,
      ...this.plant.buffers.counts,
      ...this.plant.materials.counts,
      overlays: this.overlays.counts,
    };
  }

  apply(packet: Packet): void {
    this.plant.apply(packet);
    this.surroundings.apply(packet);
    this.is_draft_ = packet.head.draft ?? false;
    const bounds = packet.head.bounds;
    this.bounds.makeEmpty();
    if (bounds) {
      this.bounds.set(new three.Vector3(...bounds[0]), new three.Vector3(...bounds[1]));
      this.ground_.suit(this.bounds);
      this.sunlight_.suit(this.bounds);
    }
    if (packet.head.fit) {
      this.orbit.open_to(kFieldOfView);
      this.fit();
    }
    this.ask();
  }

  /// Shows nothing until the next packet, which must be a whole scene.
  clear(): void {
    this.plant.clear();
    this.surroundings.clear();
    this.bounds.makeEmpty();
    this.is_draft_ = false;
    this.ask();
  }

  show(drawing: Drawing, hidden: ReadonlySet<string>, emphasised: string): void {
    this.plant.show(drawing, hidden, emphasised);
    this.ask();
  }

  paint(is_dark: boolean, shows_ground: boolean): void {
    this.ground_.paint(is_dark);
    this.surroundings.paint(is_dark);
    this.ground_.mesh.visible = shows_ground;
    this.plant.materials.wire.uniforms['line']?.value.set(is_dark ? 0x9fc7ae : 0x2d4a38).convertLinearToSRGB();
    this.ask();
  }

  /// Removes the mark.
  unmark(): void {
    this.plant.mark(null, 0);
    this.ask();
  }

  /// The distance at which the camera sees everything.
  get fitting_distance(): number {
    return this.orbit.distance_for(this.bounds);
  }

  /// Fits the plant and `beside` to the view, also when the view changes its size, until the user moves the camera.
  fit(beside: readonly Vec[] = []): void {
    this.fitted_.copy(this.bounds);
    for (const place of beside) this.fitted_.expandByPoint(new three.Vector3(...place));
    this.orbit.fit(this.fitted_, beside.length > 0);
    this.ask();
  }

  look_from(azimuth: number, altitude: number): void {
    this.orbit.look_from(azimuth, altitude);
    this.ask();
  }

  /// Sets the vertical field of view, degrees.
  open_to(field_of_view: number): void {
    this.orbit.open_to(field_of_view);
    this.ask();
  }

  /// Sets whether the shown time moves, so that each packet changes the picture.
  move_time(moves: boolean): void {
    if (moves === this.time_moves_) return;
    this.time_moves_ = moves;
    if (this.is_software) this.ask();
  }

  /// Restores a pose of the camera.
  look(state: CameraState): void {
    this.fitted_.makeEmpty();
    this.orbit.look(state);
    this.ask();
  }

  /// Requests a picture. Many requests make one picture.
  ask(): void {
    this.queue_.ask();
  }

  /// Resolves when everything requested so far is visible.
  drawn(): Promise<void> {
    return this.queue_.drawn();
  }

  /// Draws a picture now. Only measurements need this; others use `ask`.
  draw(): void {
    this.sunlight_.place(this.orbit.azimuth, this.surroundings.said?.sun);
    this.pixels_.suit(this.is_draft_ || this.time_moves_ || this.moves_until_ !== 0);
    this.renderer_.render(this.scene_, this.orbit.camera);
    this.frames_drawn += 1;
    this.events_.drawn({ camera: this.orbit.state, metres_per_pixel: this.eye.metres_per_pixel });
    this.queue_.watch_card();
  }

  /// Sets whether the document's sun lights the plant if it is above the horizon.
  shine(is_sunlit: boolean): void {
    this.sunlight_.is_sunlit = is_sunlit;
    this.ask();
  }

  /// Takes over the camera of another view, and what that view is fitted to.
  follow(other: View): void {
    this.fitted_.copy(other.fitted_);
    if (this.orbit.follow(other.orbit)) this.ask();
  }

  /// Releases everything that the view holds. It draws no more.
  destroy(): void {
    this.sizes_.disconnect();
    this.queue_.stop();
    this.plant.clear();
    this.overlays.clear();
    this.renderer_.dispose();
    this.renderer_.forceContextLoss();
  }

  /// Returns the batch and the instance at a pixel of the canvas.
  pick(x: number, y: number): PointedInstance | null {
    return this.pointing_.pick(x, y);
  }

  private move(): void {
    this.fitted_.makeEmpty();
    clearTimeout(this.moves_until_);
    this.moves_until_ = window.setTimeout(() => {
      this.moves_until_ = 0;
      if (this.is_software) this.ask();
    }, kAfterMove);
    this.ask();
  }

  private resize(): void {
    const frame = this.canvas_.parentElement ?? this.canvas_;
    const [width, height] = [frame.clientWidth, frame.clientHeight];
    if (width === 0 || height === 0) return;
    this.pixels_.resize(width, height);
    this.orbit.resize(width, height);
    this.orbit.fit(this.fitted_);
    this.ask();
  }
}
