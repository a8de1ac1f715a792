// Runs before the page is shown, so that a chosen appearance does not flash.
"use strict";
(function () {
  let chosen = null;
  try {
    chosen = localStorage.getItem("gainproof-theme");
  } catch (error) {
    // a page read from a folder may have no storage: the system's appearance it is
  }
  if (chosen === "light" || chosen === "dark") {
    document.documentElement.dataset.theme = chosen;
  }
})();
