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
// The hypercube, clock by clock.
for (const stepper of document.querySelectorAll(".stepper")) {
  const { registers, steps, states } = JSON.parse(stepper.querySelector(".steps-data").textContent);
  const items = stepper.querySelectorAll(".steps li");
  const column = Object.fromEntries(registers.map((name, index) => [name, index]));
  let at = 0;
  const show = () => {
    const step = at > 0 ? steps[at - 1] : null;
    stepper.querySelector(".now").textContent =
      step ? `After clock ${at} of ${steps.length}, ${step.text}: ${step.formula}` : "Before the first step";
    for (const link of stepper.querySelectorAll(".link"))
      link.classList.toggle("active", step !== null && link.dataset.axis === step.axis);
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
  };
  const go = { first: () => 0, back: () => at - 1, next: () => at + 1, last: () => steps.length };
  const move = (where) => {
    at = Math.max(0, Math.min(steps.length, go[where]()));
    show();
  };
  for (const button of stepper.querySelectorAll("button"))
    button.addEventListener("click", () => move(button.dataset.go));
  stepper.addEventListener("keydown", (event) => {
    const where = { ArrowRight: "next", ArrowLeft: "back", Home: "first", End: "last" }[event.key];
    if (!where) return;
    event.preventDefault();
    move(where);
  });
  show();
}
