// SPDX-License-Identifier: Apache-2.0
// Sizes of editors: in rows of the inspector, and large below the view.
import type { EditorSize } from '../rows/row_kinds.ts';
import type { PictureSize } from './plane.ts';

export const kPlaneSizes: Record<EditorSize, PictureSize> = {
  row: { wide: 256, high: 120, margin: 8 },
  large: { wide: 720, high: 300, margin: 24 },
};
