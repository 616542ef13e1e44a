// SPDX-License-Identifier: Apache-2.0
// One tooltip for the whole page. It shows `data-tip` of the element under a resting pointer, or with the keyboard
// focus.

const kRest = 350;

export function start_tooltips(root: HTMLElement): void {
  const tip = document.createElement('div');
  tip.className = 'tooltip';
  tip.setAttribute('aria-hidden', 'true'); // screen readers use the label or the description
  document.body.append(tip);
  let timer = 0;
  let owner: Element | null = null;

  const hide = (): void => {
    clearTimeout(timer);
    owner = null;
    tip.classList.remove('shown');
  };
  const show = (element: Element): void => {
    tip.textContent = element.getAttribute('data-tip');
    tip.classList.add('shown');
    const [at, { width, height }] = [element.getBoundingClientRect(), tip.getBoundingClientRect()];
    const left = Math.max(8, Math.min(at.left + at.width / 2 - width / 2, window.innerWidth - width - 8));
    const below = at.bottom + 6 + height < window.innerHeight;
    tip.style.left = `${left}px`;
    tip.style.top = `${below ? at.bottom + 6 : at.top - height - 6}px`;
  };
  const come = (target: EventTarget | null): void => {
    const element = target instanceof Element ? target.closest('[data-tip]') : null;
    if (element === owner) return;
    hide();
    if (!element?.getAttribute('data-tip')) return;
    owner = element;
    timer = window.setTimeout(() => {
      if (element.isConnected) show(element);
    }, kRest);
  };
  root.addEventListener('pointerover', (event) => come(event.target));
  root.addEventListener('focusin', (event) => {
    if (event.target instanceof Element && event.target.matches(':focus-visible')) come(event.target);
  });
  for (const end of ['pointerdown', 'keydown', 'focusout', 'pointerleave', 'wheel'] as const)
    root.addEventListener(end, hide, { passive: true });
}
