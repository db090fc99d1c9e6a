// To the last step and back, by keys and by buttons in turn; a line for each step shown.
const walked = document.getElementById("walked");
const text = (id) => document.getElementById(id).textContent;
const press = (key) => document.dispatchEvent(new KeyboardEvent("keydown", { key }));
const click = (id) => document.getElementById(id).click();
const note = () => {
  const levels = document.querySelectorAll("#stack li:not(.none)").length;
  walked.textContent += `${text("status")}; ${text("recursion")}; ${text("colour")}; ${levels}\n`;
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
for (let i = 1; i < count; i++) {
  if (i % 2) press("ArrowLeft"); else click("to-back");
  note();
}
press("ArrowLeft");
