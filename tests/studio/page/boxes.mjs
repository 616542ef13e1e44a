// SPDX-License-Identifier: Apache-2.0
// Checks the layout of a page: no element crosses the edge, covers another element or is cut, and no text is tiny. Also
// checks accessibility.
import { readFile } from 'node:fs/promises';

import { kAxe } from './support.mjs';

/// Returns the faults as texts; empty if there are none.
export function box_faults(page) {
  return page.evaluate(() => {
    const kMinText = 11; // pixels
    const faults = [];
    const box_of = (element) => {
      const box = element.getBoundingClientRect();
      const { visibility, opacity } = getComputedStyle(element);
      return box.width > 0 && box.height > 0 && visibility !== 'hidden' && opacity !== '0' ? box : null;
    };
    const name = (element) =>
      `${element.tagName.toLowerCase()}.${element.className.baseVal ?? element.className} "${(element.getAttribute('aria-label') ?? element.textContent).trim().slice(0, 40)}"`;
    const all = (selector) => [...document.querySelectorAll(selector)].filter(box_of);
    const { scrollWidth, scrollHeight } = document.documentElement;
    if (scrollWidth > innerWidth || scrollHeight > innerHeight)
      faults.push(`the page is ${scrollWidth} x ${scrollHeight} pixels`);
    const [view, canvas] = ['.centre .view', '.centre .view canvas'].map((one) => box_of(document.querySelector(one)));
    if (Math.abs(view.width - canvas.width) > 1 || Math.abs(view.height - canvas.height) > 1)
      faults.push('the plant does not fill its view');
    for (const element of all('#root *')) {
      const has_text = [...element.childNodes].some(
        (node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim() !== '',
      );
      // Sizes within pictures are in the picture's own units.
      if (has_text && !element.closest('svg') && parseFloat(getComputedStyle(element).fontSize) < kMinText)
        faults.push(`tiny: ${name(element)}`);
    }
    for (const element of all('button, h1, h2, h3, .quiet.unit')) {
      if (
        element.scrollWidth > element.clientWidth + 1 &&
        element.textContent.trim() !== '' &&
        getComputedStyle(element).textOverflow !== 'ellipsis'
      )
        faults.push(`cut: ${name(element)}`);
    }
    for (const element of all('.top-bar *, .status > *, .view-tools *, .side-tabs *, .left-tabs *')) {
      const box = box_of(element);
      if (box.left < -1 || box.top < -1 || box.right > innerWidth + 1 || box.bottom > innerHeight + 1)
        faults.push(`over the edge: ${name(element)}`);
    }
    const lying = all('.centre .view > *')
      .filter((one) => one.tagName === 'DIV' || one.tagName === 'SECTION')
      .filter((one) => !one.matches('.overlay-labels'));
    const apart = (one, other) =>
      Math.min(one.right, other.right) - Math.max(one.left, other.left) <= 1 ||
      Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) <= 1;
    lying.forEach((one, k) => {
      const box = box_of(one);
      if (box.left < view.left || box.right > view.right + 1 || box.top < view.top || box.bottom > view.bottom + 1)
        faults.push(`out of the view: ${name(one)}`);
      for (const other of lying.slice(k + 1))
        if (!apart(box, box_of(other))) faults.push(`one over the other: ${name(one)}, ${name(other)}`);
    });
    const editors = all('.curve-editor');
    for (const [k, one] of editors.entries())
      for (const other of editors.slice(k + 1))
        if (!apart(box_of(one), box_of(other)) && !one.closest('.panel'))
          faults.push(`one over the other: ${name(one)}, ${name(other)}`);
    for (const editor of editors) {
      const parts = [...editor.children].filter(box_of);
      for (const [k, one] of parts.entries())
        for (const other of parts.slice(k + 1))
          if (!apart(box_of(one), box_of(other))) faults.push(`one over the other: ${name(one)}, ${name(other)}`);
      for (const one of editor.querySelectorAll('.curve-tools > *'))
        if (box_of(one) && box_of(one).right > box_of(one.parentElement).right + 1)
          faults.push(`over the edge of its row: ${name(one)}`);
    }
    return faults;
  });
}

/// Returns the accessibility faults that axe finds, as texts. `colours_only` limits the check to colours, for another
/// theme of a page that was checked in full.
export async function serious_faults(page, { colours_only = false } = {}) {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(await readFile(kAxe, 'utf8'));
  return page.evaluate(
    async (rules) => {
      const { violations } = await window.axe.run(document, {
        resultTypes: ['violations'],
        ...(rules && { runOnly: rules }),
      });
      const serious = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
      return serious.map(
        ({ id, nodes }) =>
          `${id}: ${nodes
            .slice(0, 3)
            .map((node) => `${node.html.slice(0, 160)} ${node.any[0]?.message ?? ''}`)
            .join('; ')}`,
      );
    },
    colours_only ? ['color-contrast', 'link-in-text-block'] : null,
  );
}

/// Returns texts with too little contrast to their background.
export async function faint_texts(page, axe) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const found = await window.axe.run(document, { runOnly: ['color-contrast'], resultTypes: ['violations'] });
    return found.violations.flatMap((one) =>
      one.nodes.map((node) => `${node.html.slice(0, 120)} ${node.any[0]?.message ?? ''}`),
    );
  });
}
