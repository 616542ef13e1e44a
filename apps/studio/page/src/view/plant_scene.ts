// SPDX-License-Identifier: Apache-2.0
// The drawn plant, kept up to date by scene packets.
import * as three from 'three';

import type { Packet, PacketBatch, PacketSkeleton } from '../server/packet.ts';
import { bytes, floats, words } from '../server/packet.ts';
import type { Batch } from './buffers.ts';
import { Buffers } from './buffers.ts';
import { place } from './instances.ts';
import { Mark } from './mark.ts';
import type { Light } from './materials.ts';
import { Materials } from './materials.ts';
import type { PickTarget } from './picker.ts';
import { kLineFragment, kLineVertex } from './plant_shader.ts';

export type Drawing = 'shaded' | 'wireframe' | 'skeleton';

/// A batch that can be pointed at.
export interface SeenBatch extends PickTarget {
  key: string;
  component: string;
}

interface DrawnBatch {
  said: PacketBatch;
  batch: Batch;
  mesh: three.Mesh;
}

export class PlantScene {
  readonly root = new three.Group();
  readonly buffers = new Buffers();
  readonly materials: Materials;
  private readonly mark_ = new Mark(this.root, this.buffers);
  private readonly drawn_ = new Map<string, DrawnBatch>();
  private readonly lines_ = new Map<string, three.LineSegments>();
  private readonly line_material_ = new three.ShaderMaterial({
    vertexShader: kLineVertex,
    fragmentShader: kLineFragment,
  });
  private drawing_: Drawing = 'shaded';
  private hidden_: ReadonlySet<string> = new Set();
  private emphasised_ = '';

  constructor(light: Light, anisotropy: number, changed: () => void) {
    this.materials = new Materials(light, anisotropy, changed);
  }

  /// The components in the scene.
  get components(): string[] {
    return [...new Set([...this.drawn_.values()].map((one) => one.said.component))];
  }

  /// All batches that are drawn as surfaces now.
  get seen(): SeenBatch[] {
    return [...this.drawn_]
      .filter(([, one]) => one.mesh.visible)
      .map(([key, { said, batch }]) => ({
        key,
        component: said.component,
        batch,
        picture: this.materials.holes_of(said.material),
      }));
  }

  /// The number of triangles that are drawn as surfaces now.
  get triangles(): number {
    return this.seen.reduce((sum, { batch }) => sum + this.buffers.triangles_of(batch), 0);
  }

  /// Returns three rows of the matrix of an instance of a batch.
  frame_of(key: string, instance: number): number[] {
    const drawn = this.drawn_.get(key);
    return drawn ? this.buffers.frame_of(drawn.batch.instances_of, instance) : [];
  }

  /// Returns the matrix of the first drawn instance of a component, or null.
  first_frame(component: string): number[] | null {
    const key = [...this.drawn_.keys()].find((one) => this.drawn_.get(one)?.said.component === component);
    return key === undefined ? null : this.frame_of(key, 0);
  }

  /// Marks one instance of a batch. Null removes the mark.
  mark(key: string | null, instance: number): void {
    const drawn = key === null ? undefined : this.drawn_.get(key);
    if (drawn) this.mark_.put(drawn.batch, instance, this.materials.holes_of(drawn.said.material));
    else this.mark_.clear();
  }

  apply(packet: Packet): void {
    const { head } = packet;
    if (head.whole) this.clear();
    for (const picture of head.pictures ?? []) this.materials.add_picture(packet, picture);
    for (const material of head.materials ?? []) this.materials.say(material);
    for (const mesh of head.meshes ?? []) this.buffers.add_mesh(packet, mesh);
    for (const set of head.instances_of ?? []) this.buffers.add_instances(packet, set);
    for (const batch of head.batches ?? []) this.put_batch(batch);
    for (const skeleton of head.skeletons ?? []) this.add_skeleton(packet, skeleton);
    if (head.lines) for (const [key, lines] of this.lines_) lines.visible = head.lines.includes(key);
    this.drop(head.gone ?? {});
    if (![...this.drawn_.values()].some((one) => one.batch === this.mark_.of)) this.mark_.clear();
    this.dress();
  }

  show(drawing: Drawing, hidden: ReadonlySet<string>, emphasised: string): void {
    this.drawing_ = drawing;
    this.hidden_ = hidden;
    this.emphasised_ = emphasised;
    this.dress();
  }

  clear(): void {
    for (const { mesh } of this.drawn_.values()) this.root.remove(mesh);
    this.drawn_.clear();
    this.mark_.clear();
    this.buffers.clear();
    this.materials.clear();
    this.drop_lines([...this.lines_.keys()]);
  }

  private put_batch(said: PacketBatch): void {
    const key = batch_key(said.component, said.number);
    const batch = this.buffers.add_batch(key, said.mesh, said.instances_of);
    const before = this.drawn_.get(key);
    if (before) this.root.remove(before.mesh);
    const mesh = new three.Mesh(batch.geometry);
    place(mesh, batch);
    this.root.add(mesh);
    this.drawn_.set(key, { said, batch, mesh });
  }

  private add_skeleton(packet: Packet, skeleton: PacketSkeleton): void {
    const geometry = new three.BufferGeometry();
    geometry.setAttribute('position', new three.BufferAttribute(floats(packet, skeleton.positions), 3));
    geometry.setAttribute('order', new three.BufferAttribute(bytes(packet, skeleton.orders), 1));
    geometry.setIndex(new three.BufferAttribute(words(packet, skeleton.segments), 1));
    const lines = new three.LineSegments(geometry, this.line_material_);
    lines.frustumCulled = false;
    this.lines_.set(skeleton.key, lines);
    this.root.add(lines);
  }

  private drop(gone: NonNullable<Packet['head']['gone']>): void {
    for (const [component, number] of gone.batches ?? []) {
      const key = batch_key(component, number);
      const drawn = this.drawn_.get(key);
      if (!drawn) continue;
      this.root.remove(drawn.mesh);
      this.drawn_.delete(key);
      this.buffers.remove_batch(key);
    }
    this.buffers.remove(gone.meshes ?? [], gone.instances_of ?? []);
    this.materials.remove_pictures(gone.pictures ?? []);
    if (gone.materials !== undefined) this.materials.keep(gone.materials);
    this.drop_lines(gone.skeletons ?? []);
  }

  private drop_lines(keys: string[]): void {
    for (const key of keys) {
      const lines = this.lines_.get(key);
      if (!lines) continue;
      this.root.remove(lines);
      lines.geometry.dispose();
      this.lines_.delete(key);
    }
  }

  /// Sets the material of each batch.
  private dress(): void {
    for (const { said, batch, mesh } of this.drawn_.values()) {
      mesh.visible = this.drawing_ !== 'skeleton' && !this.hidden_.has(said.component);
      mesh.material =
        this.drawing_ === 'wireframe'
          ? this.materials.wire
          : this.materials.material_for(said.material, batch.tint_scale, said.component === this.emphasised_);
    }
  }
}

function batch_key(component: string, number: number): string {
  return `${component}#${number}`;
}
