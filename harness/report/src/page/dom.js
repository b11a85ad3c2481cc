// Building blocks of the document. Texts of a run are only ever put in as text, never as markup.

/**
 * Creates an element.
 * @param {string} tag name, with classes behind dots: "td.number"
 * @param {Object<string, *>} attributes attributes; a function is a listener of the event that its key names
 * @param {...(Node|string|number|null|undefined|Array)} children
 * @returns {HTMLElement}
 */
function el(tag, attributes, ...children) {
  const [name, ...classes] = tag.split(".");
  const element = document.createElement(name);
  if (classes.length > 0) element.className = classes.join(" ");
  for (const [key, value] of Object.entries(attributes || {})) {
    if (typeof value === "function") element.addEventListener(key, value);
    else if (value === true) element.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(key, value);
  }
  add(element, ...children);
  return element;
}

/** Adds children, of which lists are added one by one and empty values are left out. */
function add(element, ...children) {
  for (const child of children) {
    if (Array.isArray(child)) add(element, ...child);
    else if (child instanceof Node) element.append(child);
    else if (child !== null && child !== undefined && child !== false) element.append(String(child));
  }
}

/** Returns a link within the page. */
function link(address, ...children) {
  return el("a", { href: address }, ...children);
}

/**
 * Returns a link to an address of a source, or the text alone where the address is none of the web: a text of a run never
 * becomes an address that runs something.
 */
function outward(address, text) {
  if (!/^https?:\/\//.test(address)) return el("span", { title: address || null }, text);
  return el("a", { href: address, rel: "noreferrer", target: "_blank" }, text);
}

/** Returns a table in a box that scrolls sideways, for a head and rows of cells. A cell is a node, a text, or [tag, text]. */
function table(caption, head, rows) {
  const cell = (value, tag) => (value instanceof HTMLTableCellElement ? value : el(tag, {}, value));
  return el("div.scroll", { tabindex: "0", role: "region", "aria-label": caption },
    el("table", {}, el("caption", {}, caption),
      el("thead", {}, el("tr", {}, head.map((value) => {
        const th = cell(value, "th");
        th.scope = "col";
        return th;
      }))),
      el("tbody", {}, rows.map((row) => el("tr", {}, row.map((value) => cell(value, "td")))))));
}

/** Returns a cell with a number. */
function numberCell(value) {
  return el("td.number", {}, typeof value === "number" ? grouped(value) : value);
}

/** Writes a number with its thousands apart. */
function grouped(value) {
  return String(value).replace(/\B(?=(\d{3})+$)/g, ",");
}

/** Returns a number with its noun. */
function counted(value, one, many) {
  return `${grouped(value)} ${value === 1 ? one : many}`;
}

/** Returns the names of dialects; variants beside the dialect that they vary are only counted. */
function dialectNames(dialects) {
  const isBeside = (name) => dialects.some((base) => name.startsWith(`${base}+`) || name.startsWith(`${base}-without-`));
  const names = dialects.filter((name) => !isBeside(name));
  const variants = dialects.length - names.length;
  return variants === 0 ? names : [...names, counted(variants, "variant", "variants")];
}

/** Returns the tag of a verdict, with its number where one is given. */
function verdictTag(verdict, number) {
  return el(`span.tag.${verdict}`, {}, number === undefined ? verdict : `${grouped(number)} ${verdict}`);
}

/** Returns a button that copies a text and says so. */
function copyButton(label, text) {
  return el("button", { type: "button", click: () => copy(text, label) }, `Copy ${label}`);
}

/** Copies a text to the clipboard, also where the browser gives a file no access to it. */
async function copy(text, label) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = el("textarea", { "aria-hidden": "true" });
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  announce(`Copied: ${label}`);
}

let announced = 0;

/** Shows a short message for a while, which a screen reader reads. */
function announce(message) {
  const status = document.getElementById("status");
  status.textContent = message;
  clearTimeout(announced);
  announced = setTimeout(() => { status.textContent = ""; }, 2500);
}

/** Returns the id of a case with the characters that ids cannot have, of which `~3C` is one. */
function readable(id) {
  return id.replace(/(?<!~)~([2-7][0-9A-F])/g, (_, code) => String.fromCharCode(parseInt(code, 16)));
}

/** Returns a choice among words, the first of which stands for all; `shown` gives the text of a word, where that is another. */
function choice(label, words, chosen, change, shown) {
  const text = (word) => (shown === undefined ? word : shown(word));
  const option = (word) => el("option", { value: word, selected: word === chosen }, word === "" ? "all" : text(word));
  const known = words.includes(chosen) || chosen === "" ? words : [chosen, ...words];
  return el("label", {}, label,
    el("select", { change: (event) => change(event.target.value) }, ["", ...known].map(option)));
}

/** Returns a box that builds its inside when it is opened first. */
function opening(summary, build, open) {
  const box = el("details", {}, el("summary", {}, summary));
  const fill = () => {
    if (box.open && box.children.length === 1) box.append(el("div.inside", {}, build()));
  };
  box.addEventListener("toggle", fill);
  if (open) {
    box.open = true;
    fill();
  }
  return box;
}
