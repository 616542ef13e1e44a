// SPDX-License-Identifier: Apache-2.0
// The name of the chosen part, which can be changed, and a button that deletes the part. A link has no name, but can be
// written in its long form.
import type { ReactElement } from 'react';
import { Board } from '../board/board.ts';
import { component_of } from '../board/board_edits.ts';
import { IconButton } from '../controls/button.tsx';
import { TextField } from '../controls/text_field.tsx';
import { use_page } from '../page/use_page.ts';
import { path_below, steps_of } from '../values/path.ts';

export function NamedTools({ path }: { path: string }): ReactElement | null {
  const page = use_page();
  const [head, name] = steps_of(path);
  if ((head !== 'components' && head !== 'variables') || typeof name !== 'string') return null;
  const rename = (wanted: string): void => {
    if (head === 'components') void page.tool(Board).actions.rename(name, wanted);
    else
      void page.edit([{ rename: path, name: wanted }], `Rename ${name}`, { choose: path_below('variables', wanted) });
  };
  const remove = (): void => {
    if (component_of(path) !== null) void page.tool(Board).actions.remove(name);
    else void page.edit([{ remove: path }], `Delete ${name}`, { choose: '' });
  };
  return (
    <div className="named-tools">
      <TextField label="Name" value={name} commit={rename} is_code />
      <IconButton is_small icon="bin" label={`Delete ${name}`} press={remove} />
    </div>
  );
}
