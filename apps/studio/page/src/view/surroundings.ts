// SPDX-License-Identifier: Apache-2.0
// What of a scene is no mesh: poles and wires as lines, lamps as dots.
import * as three from 'three';

import type { Packet, PacketScene } from '../server/packet.ts';
import { floats } from '../server/packet.ts';

const kWire = { light: 0x5a4a3a, dark: 0xcbb89f };
const kLamp = { light: 0xd08a00, dark: 0xffc94d };
const kLampSize = 9; // pixels

export class Surroundings {
  readonly root = new three.Group();
  private readonly wire_ = new three.LineBasicMaterial();
  private readonly lamp_ = new three.PointsMaterial({ size: kLampSize, sizeAttenuation: false });
  private said_: PacketScene | null = null;

  /// Of the last packet that has told of it; null before.
  get said(): PacketScene | null {
    return this.said_;
  }

  apply(packet: Packet): void {
    if (packet.head.whole) this.clear();
    const { scene } = packet.head;
    if (!scene) return;
    this.clear();
    this.said_ = scene;
    for (const { points } of scene.supports) this.add(new three.Line(geometry_of(floats(packet, points)), this.wire_));
    const lamps = new Float32Array(scene.lamps.flatMap(({ position }) => position));
    if (lamps.length > 0) this.add(new three.Points(geometry_of(lamps), this.lamp_));
  }

  paint(is_dark: boolean): void {
    const shade = is_dark ? 'dark' : 'light';
    this.wire_.color.set(kWire[shade]);
    this.lamp_.color.set(kLamp[shade]);
  }

  clear(): void {
    for (const one of [...this.root.children]) {
      this.root.remove(one);
      if (one instanceof three.Line || one instanceof three.Points) (one.geometry as three.BufferGeometry).dispose();
    }
    this.said_ = null;
  }

  private add(object: three.Object3D): void {
    object.frustumCulled = false;
    this.root.add(object);
  }
}

function geometry_of(positions: Float32Array): three.BufferGeometry {
  return new three.BufferGeometry().setAttribute('position', new three.BufferAttribute(positions, 3));
}
