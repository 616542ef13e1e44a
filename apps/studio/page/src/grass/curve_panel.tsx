// SPDX-License-Identifier: Apache-2.0
// The midrib and the width of a grass leaf side by side, over the measured points. The points are also shown beside the
// leaf in the view.
import type { ReactElement } from 'react';
import { useEffect, useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton } from '../controls/button.tsx';
import { limits_of } from '../editors/limits.ts';
import { PlaneEditor } from '../editors/plane_editor.tsx';
import type { PlaneLine } from '../editors/plane_lines.tsx';
import { shape_of, with_points } from '../editors/shape.ts';
import { StillPlane } from '../editors/still_plane.tsx';
import { InstanceChoice } from '../page/instance_choice.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { Edit, LeafCurves } from '../server/protocol.ts';
import { row_at } from '../tables/resolve.ts';
import type { Json } from '../values/json.ts';
import { member_of, path_below, value_at } from '../values/path.ts';
import { draw_midrib, draw_widths, line_length, name_of } from './curves.ts';
import { LeafCurvesModel } from './leaf_curves.ts';

export function CurvePanel(): ReactElement | null {
  const page = use_page();
  const { tree } = use_document();
  const component = use_store(page.tool(LeafCurvesModel).component);
  const path = path_below('components', component ?? '');
  const is_gone = component !== null && value_at(tree, path) === undefined;
  useEffect(() => {
    if (is_gone) page.tool(LeafCurvesModel).component.set(null);
  }, [page, is_gone]);
  return component === null || is_gone ? null : <Curves key={component} component={component} path={path} />;
}

function Curves({ component, path }: { component: string; path: string }): ReactElement {
  const page = use_page();
  const leaf_curves = page.tool(LeafCurvesModel);
  const { shown } = use_store(page.growth);
  const found = use_store(page.tool(InstanceChoice).found);
  const curves = use_store(leaf_curves.told);
  const [wanted, want] = useState<number | null>(null); // index into the leaves of the source
  const of_instance =
    found?.component === component
      ? found.values.find((one) => one.path === path_below(path, 'rank'))?.value
      : undefined;
  const name = wanted === null ? undefined : curves?.leaves[wanted];
  useEffect(() => {
    if (shown) leaf_curves.ask(component, name?.rank ?? of_instance ?? null, name?.leaf ?? null);
  }, [leaf_curves, component, shown, name?.rank, name?.leaf, of_instance]);
  const close = (): void => leaf_curves.component.set(null);
  return (
    <section className="drawer" aria-label="Midrib and width" onKeyDown={(event) => event.key === 'Escape' && close()}>
      <header>
        <h2>
          Midrib and width <span className="quiet">of {component}</span>
        </h2>
        {curves && curves.leaves.length > 1 && (
          <select
            className="select"
            aria-label="Leaf of the source"
            value={curves.leaves.findIndex((one) => name_of(one) === name_of(curves.leaf))}
            onChange={(event) => want(Number(event.target.value))}
          >
            {curves.leaves.map((one, k) => (
              <option key={k} value={k}>
                {name_of(one)}
              </option>
            ))}
          </select>
        )}
        <p className="quiet">{curves ? fit_text(curves) : 'Waiting for the curves…'}</p>
        <IconButton icon="close" label="Close midrib and width" press={close} />
      </header>
      {curves && (
        <div className="leaf-curves">
          <Midrib path={path} curves={curves} />
          <Widths path={path} curves={curves} />
        </div>
      )}
    </section>
  );
}

function fit_text(curves: LeafCurves): string {
  const share = (100 * curves.distance) / (line_length(curves.midrib) || 1);
  return `The midrib passes its ${curves.midrib_points.length} points at ${share.toPrecision(2)} % of its length`;
}

interface PartProps {
  path: string;
  curves: LeafCurves;
}

function Midrib({ path, curves }: PartProps): ReactElement {
  const { tree } = use_document();
  const said = value_at(tree, path);
  const behind: PlaneLine[] = [
    { points: curves.midrib, kind: 'behind' },
    { points: curves.midrib_points, kind: 'dots' },
  ];
  return (
    <Part
      title="Midrib"
      names={['away', 'up']}
      path={path}
      row="midrib_points"
      form="line"
      value={member_of(said, 'midrib_points')}
      behind={behind}
      is_file={curves.midrib_file}
      edits={draw_midrib(path, said, curves)}
    />
  );
}

function Widths({ path, curves }: PartProps): ReactElement {
  const { tree } = use_document();
  const said = value_at(tree, path);
  const behind: PlaneLine[] = [
    { points: curves.widths, kind: 'behind' },
    ...(curves.width_file ? [{ points: curves.width_points, kind: 'dots' } as const] : []),
  ];
  // Without a curve in the document, the built-in profile is shown, which the user may then edit.
  const value =
    member_of(said, 'profile') ??
    (curves.width_file ? undefined : { curve: curves.width_points.map((one) => [...one]), kind: 'spline' });
  return (
    <Part
      title="Width"
      names={['along', 'share']}
      path={path}
      row="profile"
      form="line"
      value={value}
      behind={behind}
      is_file={curves.width_file}
      edits={draw_widths(path, said, curves)}
    />
  );
}

interface CurvePartProps {
  title: string;
  names: readonly [string, string];
  path: string;
  row: string;
  form: 'line';
  value: Json | undefined;
  behind: PlaneLine[];
  is_file: boolean;
  edits: Edit[]; // edits that replace the file by an editable curve
}

function Part({ title, names, path, row, form, value, behind, is_file, edits }: CurvePartProps): ReactElement {
  const page = use_page();
  const at = path_below(path, row);
  const dragged = use_store(page.dragged)[at];
  const shown = dragged ?? value;
  const shape = is_file ? null : shape_of(shown, form);
  const range = row_at(page.tables, use_document().tree, at);
  const label = `Set ${row.replaceAll('_', ' ')}`;
  return (
    <div className="leaf-curve" aria-label={title} role="group">
      <h3>
        {title}
        {shape === null && (
          <Button
            kind="quiet"
            tip="As points of the document, which hands can move"
            press={() => void page.edit(edits, `Draw the ${title.toLowerCase()} by hand`)}
          >
            Draw by hand
          </Button>
        )}
      </h3>
      {shape ? (
        <PlaneEditor
          label={title}
          shape={shape}
          is_dim={value === undefined}
          size="large"
          limits={limits_of(range ?? {}, shape.form)}
          behind={behind}
          drag={(one) => page.drag({ [at]: with_points(shown, one) })}
          commit={(one) => page.set_value(at, with_points(shown, one), label)}
          cancel={() => page.stop_drag()}
        />
      ) : (
        <StillPlane label={title} names={names} lines={behind} is_even={row === 'midrib_points'} />
      )}
    </div>
  );
}
