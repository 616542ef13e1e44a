// SPDX-License-Identifier: Apache-2.0
// All row kinds with their editors.
import { names_pictures } from '../files/file_endings.ts';
import { NestedRow } from '../rows/nested_rows.tsx';
import { NumberRow } from '../rows/number_row.tsx';
import { BooleanRow, BoxRow, ChoiceRow, FacingRow, LinesRow, TextRow, VectorRow } from '../rows/plain_rows.tsx';
import type { RowKinds } from '../rows/row_kinds.ts';
import { ColourRow, ColoursRow } from './colour_rows.tsx';
import { FileRow } from './file_row.tsx';
import { PositionsRow } from './positions_row.tsx';
import { SelectionRow } from './selection_row.tsx';
import { ShapeRow } from './shape_row.tsx';

const always = (): boolean => true;

export const kRowKinds: RowKinds = {
  editors: {
    number: { editor: NumberRow },
    integer: { editor: NumberRow },
    boolean: { editor: BooleanRow },
    choice: { editor: ChoiceRow },
    text: { editor: TextRow },
    file: { editor: FileRow, can_be_large: names_pictures },
    condition: { editor: TextRow, is_tall: true },
    formula: { editor: TextRow, is_tall: true },
    lines: { editor: LinesRow, is_tall: true },
    integers: { editor: VectorRow },
    vector: { editor: VectorRow, is_tall: true },
    facing: { editor: FacingRow, is_tall: true },
    box: { editor: BoxRow, is_tall: true },
    colour: { editor: ColourRow, can_be_large: always },
    colours: { editor: ColoursRow, is_tall: true, can_be_large: always },
    curve: { editor: ShapeRow, is_tall: true, can_be_large: always },
    points: { editor: ShapeRow, is_tall: true, can_be_large: always },
    positions: { editor: PositionsRow, is_tall: true, can_be_large: always },
    selection: { editor: SelectionRow, is_tall: true, can_be_large: always },
  },
  nested: { object: NestedRow, list: NestedRow, map: NestedRow },
};
