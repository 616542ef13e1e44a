// SPDX-License-Identifier: Apache-2.0
// The heads of scene packets.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
/// The size of the whole plant.
export interface PacketCounts {
  /// Number of triangles. An estimate if `share` < 1.
  triangles: number;
  /// Number of instances.
  instances: number;
  /// Number of nodes of skeletons.
  nodes: number;
}

/// A picture.
export interface PacketPicture {
  /// Key of the content, which never changes.
  key: string;
  /// Type of the file.
  type: 'image/png' | 'image/jpeg';
  /// Width, pixels.
  width: number;
  /// Height, pixels.
  height: number;
  /// The file. v = 0 is its lower edge.
  bytes: [at: number, count: number];
}

/// A new or changed material.
export interface PacketMaterial {
  /// Index of the material.
  index: number;
  /// Name of the material.
  name: string;
  /// Linear factor of the texels of its picture, or of white.
  colour: [x: number, y: number, z: number];
  /// Roughness, 0 to 1.
  roughness: number;
  /// Share of light that passes, 0 to 1.
  translucency: number;
  /// Share of light that does not pass straight through, 0 to 1.
  opacity: number;
  /// True: both sides are visible.
  two_sided: boolean;
  /// True: the material has holes where alpha is below 0.5.
  masked: boolean;
  /// Key of its picture. Missing: none.
  picture?: string;
  /// Key of its picture of normals. Missing: none.
  normals?: string;
}

/// A new mesh.
export interface PacketMesh {
  /// Key of the content, which never changes.
  key: string;
  /// Number of vertices.
  vertices: number;
  /// Number of triangles.
  triangles: number;
  /// Three f32 per vertex, metres.
  positions: [at: number, count: number];
  /// Four normalised i8 per vertex, the last 0.
  normals: [at: number, count: number];
  /// Four normalised i8 per vertex, w is -1 or 1. For pictures of normals.
  tangents?: [at: number, count: number];
  /// Two numbers per vertex.
  uvs?: [at: number, count: number];
  /// Type of `uvs`: normalised u16 if all are within 0 to 1.
  uv_type?: 'u16' | 'f32';
  /// Three per triangle, counter-clockwise from outside.
  indices: [at: number, count: number];
  /// Type of `indices`.
  index_type: 'u16' | 'u32';
}

/// A new set of instances.
export interface PacketInstances {
  /// Key of the content, which never changes.
  key: string;
  /// Number of instances.
  count: number;
  /// Twelve f32 per instance: three rows of a 3x4 matrix, x' = r0 . (x, y, z, 1). A frame may be mirrored.
  frames: [at: number, count: number];
  /// Four normalised u8 per instance, the last 255: shares of `tint_scale`.
  tints?: [at: number, count: number];
  /// Linear factor of the colour of the material for a full tint.
  tint_scale?: [x: number, y: number, z: number];
}

/// Instances that are drawn, new or changed.
export interface PacketBatch {
  /// Id of the component, or path of the obstacle.
  component: string;
  /// Number of the batch within the component.
  number: number;
  /// Key of the mesh.
  mesh: string;
  /// Index of the material.
  material: number;
  /// Key of the set of instances.
  instances_of: string;
}

/// A new skeleton.
export interface PacketSkeleton {
  /// Key of the content, which never changes.
  key: string;
  /// Three f32 per node.
  positions: [at: number, count: number];
  /// Two u32 per segment: its lower and its upper node.
  segments: [at: number, count: number];
  /// One u8 per node.
  orders: [at: number, count: number];
  /// One f32 per node, metres.
  radii: [at: number, count: number];
}

/// A lamp.
export interface PacketLamp {
  /// Position in the world.
  position: [x: number, y: number, z: number];
  /// Strength.
  strength: number;
}

/// A support, such as a wire.
export interface PacketSupport {
  /// Name of the support.
  name: string;
  /// Three f32 per point.
  points: [at: number, count: number];
}

/// The surroundings of the plants that are no meshes.
export interface PacketScene {
  /// Unit vector to the sun.
  sun: [x: number, y: number, z: number];
  /// Lamps.
  lamps: PacketLamp[];
  /// Supports.
  supports: PacketSupport[];
}

/// Content that is removed, after all other members were applied.
export interface PacketRemovals {
  /// Batches.
  batches?: [component: string, number: number][];
  /// Keys of meshes.
  meshes?: string[];
  /// Keys of sets of instances.
  instances_of?: string[];
  /// Keys of pictures.
  pictures?: string[];
  /// Keys of skeletons.
  skeletons?: string[];
  /// Materials from this index on are removed.
  materials?: number;
}

/// The head of a scene packet.
export interface PacketHead {
  /// Number of the packet, for `shown`. It rises.
  packet: number;
  /// True: everything that was shown before is removed.
  whole: boolean;
  /// True: the first packet of a document. The camera may be fitted to it.
  fit: boolean;
  /// Hash of the text that the packet shows.
  hash: string;
  /// True: coarser than at rest, while something moves or at first.
  draft: boolean;
  /// Share of all triangles that was requested of the meshes.
  share: number;
  /// Number of triangles that are shown, of all instances.
  triangles: number;
  /// Number of instances that are shown.
  instances: number;
  /// Size of the whole plant.
  of: PacketCounts;
  /// Corners of what is shown. Missing: nothing.
  bounds?: [low: [x: number, y: number, z: number], high: [x: number, y: number, z: number]];
  /// New pictures.
  pictures?: PacketPicture[];
  /// New and changed materials.
  materials?: PacketMaterial[];
  /// New meshes.
  meshes?: PacketMesh[];
  /// New sets of instances.
  instances_of?: PacketInstances[];
  /// Instances that are drawn, new or changed. Component and number name a batch.
  batches?: PacketBatch[];
  /// New skeletons.
  skeletons?: PacketSkeleton[];
  /// Keys of all skeletons to draw. Missing: as before.
  lines?: string[];
  /// Surroundings of the plants. Missing: as before.
  scene?: PacketScene;
  /// Content that is removed.
  gone?: PacketRemovals;
}
