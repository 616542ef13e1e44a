// SPDX-License-Identifier: Apache-2.0
// Scrolls the sidebar so that the current page is in view.
"use strict";

const pages = document.querySelectorAll(".sidebar-tree .current-page");
const scrolled = document.querySelector(".sidebar-scroll");
if (pages.length > 0 && scrolled) {
  const page = pages[pages.length - 1].getBoundingClientRect();
  const view = scrolled.getBoundingClientRect();
  const top = scrolled.scrollTop + page.top - view.top - view.height / 2;
  if (page.bottom > view.bottom) scrolled.scrollTo({ top, behavior: "instant" });
}
