// SPDX-License-Identifier: Apache-2.0
// The button for light and dark. Replaces furo's script, which Debian 12 ships as a module: pages that are opened as
// files cannot load modules.
"use strict";

/** The order of the button, beginning with the opposite of what the system prefers. */
function nextTheme(theme) {
  const order = matchMedia("(prefers-color-scheme: dark)").matches ? ["auto", "light", "dark"] : ["auto", "dark", "light"];
  return order[(order.indexOf(theme) + 1) % order.length];
}

document.documentElement.classList.remove("no-js");
for (const button of document.getElementsByClassName("theme-toggle")) {
  button.addEventListener("click", () => {
    const theme = nextTheme(document.body.dataset.theme);
    document.body.dataset.theme = theme;
    localStorage.setItem("theme", theme);
  });
}
