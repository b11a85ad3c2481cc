// Matrices: which types become which without a function, by documents, with what engines do otherwise.

/** Shows the matrix of each dialect, or of one. */
function showMatrices(main, query) {
  const data = conversions();
  add(main, el("h2", {}, "Implicit conversion"));
  if (data === null || data.pairs.size === 0) {
    add(main, el("p.notice", {}, "No case of this run asks whether a type becomes another without a function."));
    return;
  }
  const dialect = query.get("dialect") || "";
  add(main, el("div.filters", {}, choice("dialect", data.statements.dialects, dialect, (chosen) => { location.hash = addressOf("matrix", { dialect: chosen }); })),
    el("p.dim", {}, "A row is the type of the value, a column the type of the target: ✓ yes, ! yes with a warning, ✕ no, = the same type, ? no document decides. ",
      "Behind ≠ stands what engines and recorded compilers do otherwise; behind ? and where no case of this run asks, what they do; – is no answer. A cell leads to its values and cases."));
  const types = typesInOrder(new Set([...data.pairs.keys()].flatMap((key) => key.split(" "))));
  for (const { name, index } of ownFirst(data.statements.dialects.map((name, index) => ({ name, index })), ({ name }) => [name])) {
    if (dialect === "" || dialect === name) add(main, matrixOf(data, types, name, index));
  }
}

/** Returns the grid of a dialect. */
function matrixOf(data, types, dialect, index) {
  const columns = data.columns.filter((column) => column.dialect === dialect);
  const isKnown = (key) => {
    const pair = data.pairs.get(key);
    return pair !== undefined && (pair.stated[index] !== null || columns.some((column) => answerOf(column, pair.number) !== undefined));
  };
  const said = types.filter((type) => types.some((other) => [`${type} ${other}`, `${other} ${type}`].some((key) => isKnown(key))));
  const letters = engineLetters();
  const cell = (from, to) => {
    const pair = data.pairs.get(`${from} ${to}`);
    return pair === undefined ? el("td", {})
      : statedCell(data, columns, pair.stated[index], pair.number, `${from} to ${to}`, addressOf("convert", { from, to }));
  };
  return el("section", { "aria-label": dialect }, el("h3", {}, dialect),
    el("div.scroll", { tabindex: "0", role: "region", "aria-label": `Matrix of ${dialect}` }, el("table.matrix", {},
      el("caption", {}, columns.length === 0 ? "No engine of the run has this dialect"
        : `${columns.length === 1 ? "Engine" : "Engines"}: ${columns.map((column) => [columns.length === 1 ? "" : letters.get(column.engine), column.engine,
          column.recording === null ? "" : `(${recordedWhen(column.recording)})`].filter((part) => part !== "").join(" ")).join(", ")}`),
      el("thead", {}, el("tr", {}, el("td", {}), said.map((type) => el("th", { scope: "col" }, el("span", {}, type))))),
      el("tbody", {}, said.map((from) => el("tr", {}, el("th", { scope: "row" }, from), said.map((to) => cell(from, to))))))));
}

/**
 * Returns the cell of a statement: the word of the documents, and the engines that do otherwise.
 * @param {Array} columns the answers of the engines that speak the dialect
 * @param {[string, number]|null} stated the word and its basis
 * @param {number} question of which the engines' answers are
 * @param {string} about what the cell is about
 * @param {string|null} address where the cell leads, if anywhere
 */
function statedCell(data, columns, stated, question, about, address) {
  const word = stated === null ? null : stated[0];
  const letters = engineLetters();
  const departing = columns.map((column) => [column, implicitAnswer(answerOf(column, question), word)]).filter(([, answer]) => answer !== null);
  if (stated === null && departing.length === 0) return el("td", {});
  const contradicts = departing.some(([, answer]) => answer.contradicts);
  const words = departing.map(([column, answer]) => `${column.engine}: ${answer.text}`);
  const said = stated === null ? { text: departing.length > 0 ? "no source in Stickler says" : "no case asks", mark: "", tag: "unstated" } : IMPLICIT[word];
  const label = `${about}: ${[said.text, ...words].join("; ")}${stated === null ? "" : ` (${data.statements.words[stated[1]]})`}`;
  return el(`td.${said.tag}${contradicts ? ".contradicts" : ""}`, {}, el("a", { href: address, title: label, "aria-label": label },
    said.mark, departing.map(([column, answer]) => el(answer.contradicts ? "b" : "span", {},
      `${answer.contradicts ? "≠" : ""}${columns.length > 1 ? letters.get(column.engine) : ""}${answer.mark}`))));
}

/** Returns a letter or two for each engine and each recorded compiler, by which a cell names it. */
function engineLetters() {
  const letters = new Map();
  for (const name of answererNames()) {
    let length = 1;
    while ([...letters.values()].includes(name.slice(0, length).toUpperCase()) && length < name.length) length++;
    letters.set(name, name.slice(0, length).toUpperCase());
  }
  return letters;
}
