// SPDX-License-Identifier: Apache-2.0

/// A place in the world or a way through it, metres. North is -z, east +x, and y is up.
export type Vec = readonly [number, number, number];
