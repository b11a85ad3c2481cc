// The reader's own system: which it is, what is shown of it first, and how systems and engines are named.

/** The key under which the browser keeps the dialect of the reader's system, for all pages of Stickler. */
const SYSTEM_KEY = "stickler.system";

/** The chosen dialect, where the browser keeps nothing; null as long as nobody chose. */
let chosenSystem = null;

/** Returns the dialect of the reader's system; empty where none was chosen, or where the page knows nothing of it. */
function ownSystem() {
  let kept = null;
  try {
    kept = localStorage.getItem(SYSTEM_KEY);
  } catch {
    // A browser may keep nothing for a file; the choice then holds as long as the page is open.
  }
  const name = chosenSystem ?? kept ?? "";
  return conversions()?.statements.dialects.includes(name) ? name : "";
}

/** Keeps the reader's choice, and shows the page again with it. */
function chooseSystem(name) {
  chosenSystem = name;
  try {
    localStorage.setItem(SYSTEM_KEY, name);
  } catch {
    // As above.
  }
  showAddress();
  document.getElementById("system")?.focus();
  announce(name === "" ? "No system comes first" : `${titleOf(name)} comes first`);
}

/** Returns the name of the system of a dialect, for people; that of a variant tells the dialect too. */
function titleOf(dialect) {
  const { dialects, titles } = conversions().statements;
  const title = titles[dialects.indexOf(dialect)] || dialect;
  return dialects[titles.indexOf(title)] === dialect ? title : `${title} (${dialect})`;
}

/** Returns the names of the systems of dialects; variants of a system that is among them are only counted. */
function systemNames(dialects) {
  const { dialects: all, titles } = conversions().statements;
  const baseOf = (dialect) => all[titles.indexOf(titles[all.indexOf(dialect)])];
  const isVariant = (dialect) => baseOf(dialect) !== dialect && dialects.includes(baseOf(dialect));
  const names = dialects.filter((dialect) => !isVariant(dialect)).map(titleOf);
  const variants = dialects.length - names.length;
  return variants === 0 ? names : [...names, counted(variants, "variant", "variants")];
}

/** Returns the name of an engine, for people; `dialects` are those of which it gives answers. */
function engineLabel(name, dialects) {
  if (name !== "reference") return name;
  const of = dialects === undefined || dialects.length === 0 ? "each system" : systemNames(dialects).join(", ");
  return `Stickler's model of ${of}`;
}

/** Returns the question for the reader's system. */
function systemChoice() {
  const own = ownSystem();
  const names = conversions().statements.dialects.filter((name, _, all) => dialectNames(all).includes(name));
  const known = own === "" || names.includes(own) ? names : [own, ...names];
  return el("div.system", {}, el("label", {}, "Which system do you have?", el("select", { id: "system", change: (event) => chooseSystem(event.target.value) },
    el("option", { value: "", selected: own === "" }, "none in particular"),
    known.sort((one, other) => titleOf(one).localeCompare(titleOf(other))).map((name) => el("option", { value: name, selected: name === own }, `${titleOf(name)} (${name})`)))),
  el("span.dim", {}, own === "" ? "It then comes first, and the browser remembers it." : `${titleOf(own)} comes first everywhere on this page.`));
}
