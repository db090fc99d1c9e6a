// To the last step and back, by keys and by buttons in turn; a line for each step shown.
const walked = document.getElementById("walked");
const text = (id) => document.getElementById(id).textContent;
const press = (key) => document.dispatchEvent(new KeyboardEvent("keydown", { key }));
const click = (id) => document.getElementById(id).click();
// Where the drawing is, at every step; whether the log's line is seen, and is the only current.
const tops = new Set(), rows = [...document.querySelectorAll("#log tbody tr")];
let unseen = 0;
const box = document.getElementById("log-box");
const look = () => {
  tops.add(document.querySelector(".path").getBoundingClientRect().top + scrollY);
  const current = rows.filter((row) => row.getAttribute("aria-current") === "step");
  const [line, log] = [current[0], box].map((part) => part.getBoundingClientRect());
  if (current.length !== 1 || line.top < log.top || line.bottom > log.bottom + 1) unseen += 1;
};
const note = () => {
  const levels = document.querySelectorAll("#stack li:not(.none)").length;
  walked.textContent += `${text("status")}; ${text("recursion")}; ${text("colour")}; ${levels}\n`;
  look();
};
const count = document.querySelectorAll("#log tbody tr").length;
press("End");
press("Home");
note();
for (let i = 1; i < count; i++) {
  if (i % 2) press("ArrowRight"); else click("to-next");
  note();
}
press("ArrowRight");
document.getElementById("to-next").focus();
click("to-next");
walked.dataset.focus = document.activeElement.id;
for (let i = 1; i < count; i++) {
  if (i % 2) press("ArrowLeft"); else click("to-back");
  note();
}
press("ArrowLeft");
walked.dataset.tops = tops.size;
walked.dataset.unseen = unseen;
walked.dataset.page = scrollY;
