"use strict";
(() => {
  const steps = JSON.parse(document.getElementById("life").textContent);
  const element = (id) => document.getElementById(id);
  const rows = [...document.querySelectorAll("#log tbody tr")];
  const drawn = [...document.querySelectorAll("[data-depth]")];
  // Entries of a pile that are shown at its top and at its bottom.
  const TOP = 6, BOTTOM = 3;
  let at = 0;

  // What has happened up to a step, told anew from the first.
  function history(last) {
    const calls = [], stack = [], paid = new Map();
    let flying = null, deepest = 0, colour = null;
    for (const step of steps.slice(0, last + 1)) {
      flying = null;
      if (step.kind === "call") {
        calls.push({ depth: step.depth, says: `trace, depth ${step.depth}` });
        flying = step.depth;
        deepest = step.depth;
      } else if (step.kind === "hit") {
        const call = calls[calls.length - 1];
        call.says += step.owed ? `: waits to add ${step.owed.k} · its mirror` : ": the last";
        if (step.owed) stack.push({ says: `level ${step.depth}: ${step.owed.local} + ${step.owed.k} · ?`, css: step.owed.css });
      } else if (step.kind === "fold") {
        stack.pop();
        calls[calls.length - 1].says = `trace, depth ${step.depth}: folds`;
        colour = step.colour;
      } else if (step.kind === "return") {
        calls.pop();
        paid.set(step.depth, step.colour.css);
        colour = step.colour;
      } else if (step.gap.down) {
        // Levels between that the page leaves out, as one entry.
        const gap = { says: `… ${step.gap.levels} more`, levels: step.gap.levels };
        calls.push(gap);
        stack.push(gap);
        deepest = step.gap.deepest;
      } else {
        calls.pop();
        stack.pop();
      }
    }
    return { calls, stack, paid, flying, deepest, colour };
  }

  function swatch(css) {
    const box = document.createElement("span");
    box.className = "swatch";
    box.style.background = css;
    return box;
  }

  // How many calls or levels a list of entries stands for.
  const levels = (entries) => entries.reduce((sum, entry) => sum + (entry.levels ?? 1), 0);

  // The newest entry on top, the middle of a high pile as one line.
  function pile(list, entries, empty) {
    const line = (says, name, css) => {
      const item = document.createElement("li");
      item.className = name;
      if (css) item.append(swatch(css), " ");
      item.append(says);
      return item;
    };
    const newest = entries.slice().reverse();
    const items = newest.map((entry, i) => line(entry.says, i === 0 ? "top" : "", entry.css));
    if (items.length === 0) items.push(line(empty, "none"));
    const hidden = items.length - TOP - BOTTOM;
    if (hidden > 1) {
      const more = levels(newest.slice(TOP, TOP + hidden));
      items.splice(TOP, hidden, line(`… ${more} more`, "more"));
    }
    list.replaceChildren(...items);
  }

  // Scrolls the log, and not the page, so that a row is seen.
  function reveal(row) {
    const box = element("log-box"), head = box.querySelector("thead").offsetHeight;
    const top = row.offsetTop - head, bottom = row.offsetTop + row.offsetHeight;
    if (top < box.scrollTop) box.scrollTop = top;
    else if (bottom > box.scrollTop + box.clientHeight) box.scrollTop = bottom - box.clientHeight;
  }

  function show(index) {
    rows[at].classList.remove("current");
    rows[at].removeAttribute("aria-current");
    at = Math.min(Math.max(index, 0), steps.length - 1);
    const step = steps[at], past = history(at);
    rows[at].classList.add("current");
    rows[at].setAttribute("aria-current", "step");
    reveal(rows[at]);
    element("status").textContent = `step ${step.number} of ${steps[steps.length - 1].number}`;
    const cells = rows[at].cells;
    element("recursion").textContent = cells[1].textContent;
    element("engine").textContent = cells[2].textContent || "nothing: the colour is at hand";
    const numbers = step.numbers.flatMap(([name, value]) => {
      const [term, said] = ["dt", "dd"].map((tag) => document.createElement(tag));
      term.textContent = name;
      said.textContent = value;
      return [term, said];
    });
    element("numbers").replaceChildren(...numbers);
    pile(element("calls"), past.calls, "no call");
    pile(element("stack"), past.stack, "stack empty");
    const colour = past.colour;
    element("colour").textContent = colour ? colour.text : "none yet";
    element("colour").dataset.levels = colour ? colour.levels.join(" ") : "";
    element("swatch").className = colour ? "swatch" : "swatch unknown";
    element("swatch").style.background = colour ? colour.css : "";
    const waiting = `Calls: ${levels(past.calls)}, levels on the stack: ${levels(past.stack)}`;
    const back = colour ? `colour ${colour.text}` : "no colour yet";
    element("spoken").textContent = `${element("status").textContent}. The recursion: ${element("recursion").textContent}. The engine: ${element("engine").textContent}. ${waiting}, ${back}.`;
    for (const part of drawn) {
      const depth = Number(part.dataset.depth), leg = part.classList.contains("leg");
      part.classList.toggle("ahead", depth > past.deepest);
      part.classList.toggle("flying", leg && depth === past.flying);
      part.classList.toggle("paid", leg && past.paid.has(depth));
      part.style.stroke = leg && past.paid.has(depth) ? past.paid.get(depth) : "";
    }
    // A disabled button would lose the focus.
    const off = (button, is) => element(button).setAttribute("aria-disabled", is);
    for (const button of ["to-first", "to-back"]) off(button, at === 0);
    for (const button of ["to-next", "to-last"]) off(button, at === steps.length - 1);
  }

  // Gives the piles the height that they have when they are fullest.
  function settle() {
    const piles = [element("calls"), element("stack")], kinds = ["call", "hit"];
    let high = 0;
    for (const pile of piles) pile.style.height = "";
    for (const kind of kinds) {
      show(steps.findLastIndex((step) => step.kind === kind));
      high = Math.max(high, ...piles.map((pile) => pile.offsetHeight));
    }
    for (const pile of piles) pile.style.height = `${high}px`;
  }

  // #last, or #step=N; anything else is the first.
  function show_fragment() {
    const number = /^#step=(\d+)$/.exec(location.hash);
    if (location.hash === "#last") return show(steps.length - 1);
    const found = number ? steps.findIndex((step) => step.number >= Number(number[1])) : 0;
    show(found < 0 ? steps.length - 1 : found);
  }

  const moves = {
    Home: ["to-first", () => 0],
    ArrowLeft: ["to-back", () => at - 1],
    ArrowRight: ["to-next", () => at + 1],
    End: ["to-last", () => steps.length - 1],
  };
  for (const [button, to] of Object.values(moves)) {
    element(button).addEventListener("click", () => show(to()));
  }
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.shiftKey || !(event.key in moves)) return;
    event.preventDefault();
    show(moves[event.key][1]());
  });
  rows.forEach((row, index) => row.addEventListener("click", () => show(index)));
  window.addEventListener("hashchange", show_fragment);
  element("controls").hidden = element("now").hidden = false;
  element("log-box").classList.add("stepped");
  settle();
  window.addEventListener("resize", () => {
    const was = at;
    settle();
    show(was);
  });
  show_fragment();
})();
