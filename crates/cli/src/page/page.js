"use strict";
// The slider shows so much of the upper picture.
for (const slider of document.querySelectorAll(".slider")) {
  const pair = slider.closest("figure").querySelector(".pair");
  const show = () => pair.style.setProperty("--part", slider.value + "%");
  slider.addEventListener("input", show);
  show();
}
// A mark tells its figures below the chart.
for (const chart of document.querySelectorAll(".chart")) {
  const readout = chart.querySelector(".readout");
  for (const point of chart.querySelectorAll(".point")) {
    const show = () => {
      for (const other of chart.querySelectorAll(".point.shown")) other.classList.remove("shown");
      point.classList.add("shown");
      readout.textContent = point.getAttribute("aria-label");
    };
    point.addEventListener("focus", show);
    point.addEventListener("pointerenter", show);
    point.addEventListener("click", show);
  }
}
// Steps from clock to clock: by the buttons and by the keys. `show` draws the state after so many steps.
function step(stepper, steps, show) {
  let at = 0;
  const go = { first: () => 0, back: () => at - 1, next: () => at + 1, last: () => steps };
  const move = (where) => {
    at = Math.max(0, Math.min(steps, go[where]()));
    show(at);
  };
  for (const button of stepper.querySelectorAll("button"))
    button.addEventListener("click", () => move(button.dataset.go));
  stepper.addEventListener("keydown", (event) => {
    const where = { ArrowRight: "next", ArrowLeft: "back", Home: "first", End: "last" }[event.key];
    if (!where) return;
    event.preventDefault();
    move(where);
  });
  show(0);
}
const data = (element) => JSON.parse(element.textContent);
// The hypercube.
for (const source of document.querySelectorAll(".steps-data")) {
  const stepper = source.closest(".stepper");
  const { registers, steps, states } = data(source);
  const items = stepper.querySelectorAll(".steps li");
  const column = Object.fromEntries(registers.map((name, index) => [name, index]));
  step(stepper, steps.length, (at) => {
    const last = at > 0 ? steps[at - 1] : null;
    stepper.querySelector(".now").textContent =
      last ? `After clock ${last.clock}, ${last.text}: ${last.formula}` : "Before the first step";
    for (const link of stepper.querySelectorAll(".link"))
      link.classList.toggle("active", last !== null && link.dataset.axis === last.axis);
    for (const node of stepper.querySelectorAll(".node")) {
      const now = states[at][node.dataset.node];
      const before = at > 0 ? states[at - 1][node.dataset.node] : now;
      for (const name of ["v", "s"]) node.querySelector("." + name).textContent = `${name} ${now[column[name]]}`;
      node.classList.toggle("changed", now.some((value, index) => value !== before[index]));
    }
    items.forEach((item, index) => {
      if (index === at - 1) item.setAttribute("aria-current", "step");
      else item.removeAttribute("aria-current");
    });
  });
}
// The registers of engines.
for (const source of document.querySelectorAll(".pipeline-data")) {
  const stepper = source.closest(".stepper");
  const { clocks } = data(source);
  const cells = stepper.querySelectorAll("[data-place]");
  step(stepper, clocks.length - 1, (at) => {
    stepper.querySelector(".now").textContent = `Clock ${at} of ${clocks.length - 1}`;
    for (const cell of cells) {
      const place = cell.dataset.place;
      cell.textContent = clocks[at][place];
      cell.classList.toggle("changed", at > 0 && clocks[at][place] !== clocks[at - 1][place]);
    }
  });
}
