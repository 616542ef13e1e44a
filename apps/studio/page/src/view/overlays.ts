// SPDX-License-Identifier: Apache-2.0
// Overlays on the plant: points, lines, arrows and labels, in layers that are added and removed by name. A layer needs
// at most two draw calls per picture.
import * as three from 'three';

import type { Vec } from '../base/vec.ts';
import { kOverlayFragment, kOverlayPointFragment, kOverlayPointVertex, kOverlayVertex } from './overlay_shader.ts';

export type Colour = readonly [number, number, number]; // sRGB, 0 to 255

export interface OverlayPoints {
  positions: Float32Array; // three numbers for each
  colours: Uint8Array; // red, green, blue, opacity for each
  size: number; // pixels across
}

export interface OverlayLines {
  positions: Float32Array; // six numbers for each line
  colours: Uint8Array; // four for each end
}

export interface OverlayArrow {
  from: Vec;
  to: Vec;
  colour: Colour;
}

export interface OverlayLabel {
  at: Vec;
  text: string;
}

export interface OverlayLayer {
  points?: OverlayPoints;
  lines?: OverlayLines;
  arrows?: readonly OverlayArrow[];
  labels?: readonly OverlayLabel[];
  /// True: visible through parts in front of it.
  is_in_front?: boolean;
}

const kHead = 0.18; // share of an arrow's length
const kHeadWidth = 0.4; // share of the head's length

interface DrawnLayer {
  objects: (three.Points | three.LineSegments)[];
  labels: readonly OverlayLabel[];
}

export class Overlays {
  readonly root = new three.Group();
  private readonly layers_ = new Map<string, DrawnLayer>();
  private readonly materials_: Record<'points' | 'lines', [three.ShaderMaterial, three.ShaderMaterial]>;

  constructor(private readonly changed_: () => void) {
    const material = (points: boolean, in_front: boolean) =>
      new three.ShaderMaterial({
        vertexShader: points ? kOverlayPointVertex : kOverlayVertex,
        fragmentShader: points ? kOverlayPointFragment : kOverlayFragment,
        transparent: true,
        depthWrite: false,
        depthTest: !in_front,
        uniforms: { size: { value: 6 }, pixel_ratio: { value: 1 } },
      });
    this.materials_ = {
      points: [material(true, false), material(true, true)],
      lines: [material(false, false), material(false, true)],
    };
  }

  /// Adds a layer and replaces the layer of that name. Null removes the layer.
  put(name: string, layer: OverlayLayer | null): void {
    this.remove(name);
    if (layer) this.layers_.set(name, this.made(layer));
    for (const object of this.layers_.get(name)?.objects ?? []) this.root.add(object);
    this.changed_();
  }

  has(name: string): boolean {
    return this.layers_.has(name);
  }

  /// The labels of all layers, in the order of adding.
  get labels(): OverlayLabel[] {
    return [...this.layers_.values()].flatMap((layer) => [...layer.labels]);
  }

  /// For tests.
  get counts(): { layers: number; points: number; lines: number } {
    const sum = { layers: this.layers_.size, points: 0, lines: 0 };
    for (const { objects } of this.layers_.values()) {
      for (const object of objects) {
        const count = object.geometry.getAttribute('position').count;
        if (object instanceof three.Points) sum.points += count;
        else sum.lines += count / 2;
      }
    }
    return sum;
  }

  clear(): void {
    for (const name of [...this.layers_.keys()]) this.remove(name);
  }

  private remove(name: string): void {
    for (const object of this.layers_.get(name)?.objects ?? []) {
      this.root.remove(object);
      object.geometry.dispose();
    }
    this.layers_.delete(name);
  }

  private made({ points, lines, arrows, labels, is_in_front }: OverlayLayer): DrawnLayer {
    const objects: DrawnLayer['objects'] = [];
    const front = is_in_front ? 1 : 0;
    if (points && points.positions.length > 0) objects.push(points_object(points, this.materials_.points[front]));
    const all = joined(lines, arrows ?? []);
    if (all.positions.length > 0) objects.push(new three.LineSegments(geometry_of(all), this.materials_.lines[front]));
    for (const object of objects) {
      object.frustumCulled = false;
      object.matrixAutoUpdate = false;
      object.renderOrder = 1;
    }
    return { objects, labels: labels ?? [] };
  }
}

function points_object(points: OverlayPoints, material: three.ShaderMaterial): three.Points {
  const object = new three.Points(geometry_of(points), material);
  object.onBeforeRender = (renderer) => {
    const { size, pixel_ratio } = material.uniforms;
    if (size) size.value = points.size;
    if (pixel_ratio) pixel_ratio.value = renderer.getPixelRatio();
    material.uniformsNeedUpdate = true;
  };
  return object;
}

function geometry_of({ positions, colours }: { positions: Float32Array; colours: Uint8Array }): three.BufferGeometry {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.BufferAttribute(positions, 3));
  geometry.setAttribute('colour', new three.BufferAttribute(colours, 4, true));
  return geometry;
}

/// Returns the lines together with the lines of arrows. An arrow has a shaft, and four lines as its head.
function joined(lines: OverlayLines | undefined, arrows: readonly OverlayArrow[]): OverlayLines {
  if (arrows.length === 0) return lines ?? { positions: new Float32Array(), colours: new Uint8Array() };
  const positions = [...(lines?.positions ?? [])];
  const colours = [...(lines?.colours ?? [])];
  for (const { from, to, colour } of arrows) {
    for (const [begin, end] of arrow_lines(from, to)) {
      positions.push(...begin, ...end);
      colours.push(...colour, 255, ...colour, 255);
    }
  }
  return { positions: new Float32Array(positions), colours: new Uint8Array(colours) };
}

/// Returns the segments that draw an arrow.
export function arrow_lines(from: Vec, to: Vec): [Vec, Vec][] {
  const tip = new three.Vector3(...to);
  const way = tip.clone().sub(new three.Vector3(...from));
  const length = way.length();
  if (length === 0) return [];
  way.divideScalar(length);
  const side = new three.Vector3(Math.abs(way.y) > 0.9 ? 1 : 0, Math.abs(way.y) > 0.9 ? 0 : 1, 0)
    .cross(way)
    .normalize();
  const other = way.clone().cross(side);
  const back = tip.clone().addScaledVector(way, -kHead * length);
  const wide = kHead * kHeadWidth * length;
  const corners = [side, side.clone().negate(), other, other.clone().negate()].map((across) =>
    back.clone().addScaledVector(across, wide),
  );
  return [[from, to], ...corners.map((corner): [Vec, Vec] => [to, [corner.x, corner.y, corner.z]])];
}
