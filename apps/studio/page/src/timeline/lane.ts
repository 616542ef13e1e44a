// SPDX-License-Identifier: Apache-2.0
// A lane of the timeline: conversion of pixels into seconds.
import type { PointerEvent } from 'react';

/// Returns the time under a pointer, in a lane that shows the whole animation.
export function time_under(event: PointerEvent, lane: Element | null, length: number): number {
  const box = lane?.getBoundingClientRect();
  if (!box || box.width === 0) return 0;
  return Math.min(1, Math.max(0, (event.clientX - box.left) / box.width)) * length;
}

/// Rounds a time to the nearest frame, unless `is_fine`.
export function to_frame(time: number, fps: number, is_fine: boolean): number {
  return is_fine ? time : Math.round(time * fps) / fps;
}

export function percent(time: number, length: number): string {
  return `${Math.min(100, Math.max(0, (100 * time) / length))}%`;
}
