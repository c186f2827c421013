"use strict";
// Filters what is on the page, and opens what a link leads to. Without it all is there, and folds by itself.
(function () {
  const form = document.getElementById("filter");
  const text = document.getElementById("filter-text");
  const verdict = document.getElementById("filter-verdict");
  const part = document.getElementById("filter-part");
  const count = document.getElementById("filter-count");
  const items = Array.from(document.querySelectorAll(".item"));
  const parts = Array.from(document.querySelectorAll(".part"));

  function matches(item, words) {
    if (verdict.value && item.dataset.verdict !== verdict.value) return false;
    if (part.value && !(item.closest(".part") && item.closest(".part").id === part.value)) return false;
    return words.every((word) => item.dataset.search.includes(word));
  }

  function filter() {
    const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
    const asked = words.length > 0 || verdict.value !== "" || part.value !== "";
    let shown = 0;
    for (const item of items) {
      item.hidden = asked && !matches(item, words);
      if (!item.hidden) shown += 1;
    }
    for (const one of parts) {
      const has = one.querySelector(".item:not([hidden])");
      one.hidden = asked && !has;
      if (one.tagName === "DETAILS") one.open = asked && Boolean(has);
    }
    count.textContent = asked ? shown + " of " + items.length : "";
  }

  // A link to what the filter hides takes the filter away; what is folded around it is unfolded.
  function reveal() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    if (target.closest("[hidden]")) {
      form.reset();
      filter();
    }
    for (let one = target; one; one = one.parentElement) {
      if (one.tagName === "DETAILS") one.open = true;
    }
    target.scrollIntoView();
  }

  form.hidden = false;
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", filter);
  addEventListener("hashchange", reveal);
  reveal();
})();
