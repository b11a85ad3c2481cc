// Bit access: which bits and parts of a type have a name, by documents, with what engines do otherwise.

/** The forms of a part, in their order, each with the bits that it takes. */
const FORMS = [["", "variable.n", 1], ["%X", "variable.%Xn", 1], ["%B", "variable.%Bn", 8], ["%W", "variable.%Wn", 16], ["%D", "variable.%Dn", 32], ["%L", "variable.%Ln", 64]];

/** The bits of the types that have bits. */
const WIDTHS = { SINT: 8, INT: 16, DINT: 32, LINT: 64, USINT: 8, UINT: 16, UDINT: 32, ULINT: 64, BYTE: 8, WORD: 16, DWORD: 32, LWORD: 64 };

/** Shows the bits and parts of a type. */
function showBits(main, query) {
  const data = conversions();
  add(main, el("h2", {}, "Bit access"));
  if (data === null || data.statements.parts.length === 0) {
    add(main, el("p.notice", {}, "No case of this run takes a bit out of a variable by itself."));
    return;
  }
  const parts = data.statements.parts.map((part, index) => ({ type: data.statements.words[part.from], part: data.statements.words[part.to],
    stated: part.stated, number: data.statements.pairs.length + index }));
  const types = typesInOrder(new Set(parts.map((part) => part.type)));
  const type = types.includes(query.get("type")) ? query.get("type") : types.includes("BYTE") ? "BYTE" : types[0];
  add(main, el("div.filters", {}, el("label", {}, "type", el("select", { change: (event) => { location.hash = addressOf("bits", { type: event.target.value }); } },
    types.map((word) => el("option", { selected: word === type }, word))))),
  type in WIDTHS ? el("p", {}, `${type} has bits 0 to ${WIDTHS[type] - 1}; bit 0 is the least significant one.`) : el("p", {}, `${type} has no bits.`),
  el("p.dim", {}, "✓ accepted, ! accepted with a warning, ✕ rejected, ? no document decides, blank: no case of this run asks. Behind ≠ stands what engines and recorded compilers do otherwise. Only the parts that cases ask for are shown; ",
    "those outside the type have a broken edge."));
  for (const [prefix, title, bits] of FORMS) {
    const shown = parts.filter((one) => one.type === type && (prefix === "" ? /^\d+$/ : new RegExp(`^${prefix}\\d+$`)).test(one.part))
      .map((one) => ({ ...one, index: Number(one.part.slice(prefix.length)) })).sort((one, other) => one.index - other.index);
    if (shown.length > 0) add(main, strip(data, type, title, bits, shown));
  }
}

/** Returns the strip of a form: a row for each dialect, a column for each index, from the least one. */
function strip(data, type, title, bits, shown) {
  const names = ownFirst(data.statements.dialects.map((name, index) => ({ name, index })), ({ name }) => [name]).filter(({ name, index }) => shown.some((one) => one.stated[index] !== null
    || data.columns.some((column) => column.dialect === name && answerOf(column, one.number) !== undefined)));
  const isOutside = (one) => !(type in WIDTHS) || (one.index + 1) * bits > WIDTHS[type];
  return el("section", { "aria-label": title }, el("h3", {}, el("code", {}, title)),
    el("div.scroll", { tabindex: "0", role: "region", "aria-label": `${title} of ${type}` }, el("table.matrix.bits", {},
      el("thead", {}, el("tr", {}, el("td", {}), shown.map((one) => el(`th${isOutside(one) ? ".outside" : ""}`, { scope: "col" }, el("span", {}, String(one.index)))))),
      el("tbody", {}, names.map(({ name, index }) => el("tr", {}, el("th", { scope: "row" }, name), shown.map((one) => {
        const cell = statedCell(data, data.columns.filter((column) => column.dialect === name), one.stated[index], one.number,
          `${type}: ${title.replace("n", one.index)} in ${name}`, hasCases() ? addressOf("cases", { dialect: name, area: "bit-access", q: `(${type},${one.index}` }) : null);
        if (isOutside(one)) cell.classList.add("outside");
        return cell;
      })))))));
}
