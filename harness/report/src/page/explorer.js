// The explorer: what becomes of a value when its type changes, by documents and on engines.

/** Shows the conversions of a pair of types, or one function by its name. */
function showExplorer(main, query, view) {
  const data = conversions();
  add(main, el("h2", {}, "What does a conversion do?"));
  if (data === null || data.types.length === 0) {
    add(main, el("p.notice", {}, "The page has no conversion to show: no case of this run makes one by itself, or the cases were not at hand. A whole run has all: ",
      el("code", {}, "stickler run"), "."));
    return;
  }
  const named = data.byName.get(view.toUpperCase());
  const value = query.get("value") || "";
  const from = named ? query.get("from") || named[0].operands[0] : query.get("from") || startPair(data)[0];
  const to = named ? (named.find((one) => one.operands[0] === from) || named[0]).result : query.get("to") || startPair(data)[1];
  add(main, systemChoice(), explorerForm(data, { from, to, value, name: named ? named[0].name : "" }));
  if (named) {
    showFunction(main, named, from, value);
  } else if (view !== "" && view !== "convert" && view !== "explorer") {
    add(main, el("p.notice", {}, `No case of this run calls a function ${view}.`));
  }
  if (!named) showPair(main, data, from, to, value);
  // The panels show a value at once; without them, it is a row of the table.
  if (main.querySelector(".panel") === null) main.querySelector("tr.wanted")?.scrollIntoView({ block: "center" });
}

/** Returns the pair of types that is shown first. */
function startPair(data) {
  return data.byName.has("REAL_TO_INT") ? ["REAL", "INT"]
    : data.functions.length > 0 ? [data.functions[0].operands[0], data.functions[0].result]
      : [...data.pairs.keys()][0].split(" ");
}

/** Returns the choice of types and the search field. */
function explorerForm(data, { from, to, value, name }) {
  const go = (choices) => { location.hash = addressOf("convert", { from, to, value, ...choices }); };
  const types = (label, chosen, change) => el("label", {}, label, el("select", { change: (event) => change(event.target.value) },
    data.types.map((type) => el("option", { selected: type === chosen }, type))));
  const search = el("input", { type: "search", list: "functions", size: 34, placeholder: "REAL_TO_INT 2.5", "aria-describedby": "search-help",
    value: [name, value].filter((part) => part !== "").join(" ") });
  return el("form.filters", { role: "search", submit: (event) => {
    event.preventDefault();
    location.hash = wantedAddress(data, search.value, from, to);
  } },
  types("from", from, (chosen) => go({ from: chosen })), types("to", to, (chosen) => go({ to: chosen })),
  el("button", { type: "button", "aria-label": "exchange the types", click: () => go({ from: to, to: from }) }, "⇄"),
  el("label", {}, "function, types or value", search),
  el("datalist", { id: "functions" }, [...data.byName.keys()].sort().map((word) => el("option", { value: word }))),
  el("button", { type: "submit" }, "Show"),
  el("span.dim", { id: "search-help" }, "such as ", el("code", {}, "REAL_TO_INT 2.5"), ", ", el("code", {}, "UDINT TIME"), " or ", el("code", {}, "3E9")));
}

/** Returns the address for what was typed: a function, two types, a value, or several of these. */
function wantedAddress(data, text, from, to) {
  const words = text.trim().split(/[\s(),]+/).filter((word) => word !== "" && word.toLowerCase() !== "to");
  const name = words.find((word) => data.byName.has(word.toUpperCase()));
  const types = words.filter((word) => data.types.includes(word.toUpperCase())).map((word) => word.toUpperCase());
  const value = words.filter((word) => word !== name && !data.types.includes(word.toUpperCase())).join(" ");
  if (name !== undefined) return addressOf(name.toUpperCase(), { from: types[0] || "", value });
  if (types.length > 1) return addressOf("convert", { from: types[0], to: types[1], value });
  if (/^[A-Za-z]+_/.test(value)) return addressOf(value, {});
  return addressOf("convert", { from: types[0] || from, to, value });
}

/** Shows whether a type becomes another implicitly, and the functions that convert it. */
function showPair(main, data, from, to, value) {
  add(main, el("h3", {}, `Does ${from} become ${to} without a function?`), implicitTable(data, from, to), comparisonView(data, from, to));
  const functions = data.functions.filter((one) => one.operands.length === 1 && one.operands[0] === from && one.result === to);
  functions.sort((one, other) => Number(other.name === `${from}_TO_${to}`) - Number(one.name === `${from}_TO_${to}`) || one.calls < other.calls);
  if (functions.length === 0) {
    add(main, el("p", {}, `No function of this run's cases makes ${to} of ${from}.`));
  }
  functions.forEach((one, index) => {
    if (index === 0) add(main, functionView(one, value));
    else add(main, opening(`${one.name}(${from}) : ${to}`, () => functionView(one, value), false));
  });
}

/** Shows a function, and a choice among the types that it takes. */
function showFunction(main, named, from, value) {
  const shown = named.find((one) => one.operands[0] === from) || named[0];
  if (named.length > 1) {
    add(main, el("p", {}, `${shown.name} takes several types: `, named.map((one) => [
      el("a", { href: addressOf(one.name, { from: one.operands[0], value }), "aria-current": one === shown ? "true" : null }, one.operands.join(", ")), " "])));
  }
  add(main, functionView(shown, value), el("p", {}, link(addressOf("convert", { from: shown.operands[0], to: shown.result }),
    `Does ${shown.operands[0]} become ${shown.result} without a function?`)));
}

/** The words of the documents' matrix, with a mark that does not depend on colours. */
const IMPLICIT = {
  yes: { mark: "✓", text: "yes", tag: "pass" }, warn: { mark: "!", text: "yes, with a warning", tag: "warn" },
  "=": { mark: "=", text: "same type", tag: "pass" },
  no: { mark: "✕", text: "no", tag: "no" }, open: { mark: "?", text: "open", tag: "open" },
};

/**
 * Returns what an engine does with a pair of types, where it departs from the documents or these are silent.
 * @returns {{text: string, mark: string, contradicts: boolean}|null} null where it does as they say
 */
function implicitAnswer(answer, word) {
  if (answer === undefined || answer.state === "met") return null;
  if (answer.state === "recorded") {
    // Where a value is open, the program is accepted all the same.
    const text = answer.text === "rejected" ? "no" : answer.text === "warned" ? "warn" : "yes";
    if (text === word || (word === "=" && text === "yes")) return null;
    return { text: IMPLICIT[text].text, mark: IMPLICIT[text].mark, contradicts: false };
  }
  if (["unsupported", "waiting", "crashed", "nothing"].includes(answer.text)) return { text: answer.text, mark: "–", contradicts: answer.text === "crashed" };
  const is = (kind, text) => ({ text, mark: IMPLICIT[kind].mark, contradicts: true });
  if (answer.text.startsWith("rejected")) return is("no", word === "no" ? `no, ${answer.text}` : "no");
  if (answer.text.startsWith("warned")) return is("warn", `yes, ${answer.text}`);
  if (answer.text === "no warning") return is("yes", `yes, ${answer.text}`);
  return is("yes", word === "no" ? "yes" : `yes, but ${bare(answer.text)}`);
}

/** Returns the table of a pair: a row for each dialect, a column for the documents, one for each engine, and one for the recorded compilers. */
function implicitTable(data, from, to) {
  const pair = data.pairs.get(`${from} ${to}`);
  if (pair === undefined) return el("p", {}, from === to ? "It is the same type." : "No case of this run asks.");
  const answerIn = (engine, dialect) => {
    const column = data.columns.find((one) => one.engine === engine && one.dialect === dialect);
    return column === undefined ? undefined : answerOf(column, pair.number);
  };
  const isAsked = (dialect, index) => pair.stated[index] !== null || answererNames().some((engine) => answerIn(engine, dialect) !== undefined);
  const recorded = data.columns.filter((column) => column.recording !== null);
  const unasked = data.statements.dialects.filter((dialect, index) => !isAsked(dialect, index));
  const dialects = ownFirst(data.statements.dialects.map((dialect, index) => ({ dialect, index })), (one) => [one.dialect]);
  const rows = dialects.flatMap(({ dialect, index }) => {
    if (!isAsked(dialect, index)) return [];
    const stated = pair.stated[index];
    const word = stated === null ? null : stated[0];
    const basis = stated === null ? "" : data.statements.words[stated[1]];
    return [[el("code", {}, dialect),
      stated === null ? el("span.dim", {}, "no source in Stickler says") : el("span", {}, el(`span.tag.${IMPLICIT[word].tag}`, {}, `${IMPLICIT[word].mark} ${IMPLICIT[word].text}`), " ", basisLink(basis)),
      ...engineNames().map((engine) => {
        const answer = answerIn(engine, dialect);
        return answer === undefined ? el("span.dim", {}, "–") : implicitTag(answer, word);
      }),
      recorded.length === 0 ? null : el("span", {}, recorded.filter((column) => column.dialect === dialect).map((column) => {
        const answer = answerOf(column, pair.number);
        return answer === undefined ? null : el("div", { title: `${recordedWhen(column.recording)} on ${column.recording.platform}` }, implicitTag(answer, word), ` ${column.engine}`);
      }))].filter((cell) => cell !== null)];
  });
  const heads = ["dialect", "documents", ...engineNames().map((name) => engineLabel(name)), ...(recorded.length === 0 ? [] : ["recorded compilers"])];
  return el("div", {}, table(`Implicit conversion of ${from} to ${to}`, heads, rows),
    unasked.length > 0 ? el("p.dim", {}, `No case asks in ${unasked.join(", ")}.`) : null,
    hasCases() ? el("p", {}, link(addressOf("cases", { q: `(${from},${to}` }), "Cases of this pair that did not pass")) : null);
}

/** Returns what recorded compilers answer to a comparison of the two types, or null where none was asked. */
function comparisonView(data, from, to) {
  const { compared } = data.answers;
  const wordOf = (column) => Object.entries((column.packed.comparisons || {})[from] || {}).find(([, types]) => types.includes(to))?.[0];
  const answers = data.columns.filter((column) => wordOf(column) !== undefined);
  if (answers.length === 0) return null;
  const isLess = compareLiterals(compared[from], compared[to]) < 0;
  return el("p", {}, el("code", {}, `${compared[from]} < ${compared[to]}`), ` is ${isLess ? "true" : "false"} of the numbers. `, answers.map((column) => {
    const word = wordOf(column);
    const isWrong = (word === "true" || word === "false") && (word === "true") !== isLess;
    return [el(`span.tag.${isWrong ? "differs" : "open"}`, { title: `${recordedWhen(column.recording)} in ${column.dialect}` }, `${isWrong ? "≠ " : ""}${word}`), ` ${column.engine} (${column.dialect}) `];
  }));
}

/** Returns the tag of an answer about a pair of types. */
function implicitTag(answer, word) {
  const departs = implicitAnswer(answer, word);
  return departs === null ? el("span.tag.pass", {}, "✓ as said") : answerTag(departs.text, departs.contradicts, answer.number);
}

/** Returns the tag of an engine's answer, which leads to its case where it contradicts a source. */
function answerTag(text, contradicts, number) {
  const tag = el(`span.tag.${contradicts ? "fail" : "open"}`, {}, contradicts ? `✗ ${text}` : text);
  if (number === null || number === undefined) return tag;
  const of = caseAt(number);
  if (["differs", "unsupported", "waiting"].includes(of.verdict)) tag.className = `tag ${of.verdict}`;
  return link(addressOf("case", { engine: of.engine, dialect: of.dialect, id: of.id }), tag);
}

/** Returns everything about a function: its plot and the table of its values. */
function functionView(one, value) {
  const rows = Array.from({ length: one.calls }, (_, index) => ({ ...statedOf(one, index), question: one.first + index, isBoundary: index < one.boundaries }));
  rows.sort((left, right) => compareLiterals(left.operands[0], right.operands[0]));
  const columns = columnsOf(one, rows);
  const isDrawn = behavioursOf(one).some(({ views }) => views.some(({ points }) => points.some((point) => isAt(point, value))));
  const wanted = value === "" ? null : rows.find((row) => row.operands.length === 1 && isSame(row.operands[0], value));
  const command = `stickler conversions ${one.name} ${value === "" ? "" : `'${value}'`}`.trim();
  const title = `${one.name}(${one.operands.join(", ")}) : ${one.result}`;
  return el("section", { "aria-label": title },
    el("h3", {}, link(addressOf(one.name, { from: one.operands[0] }), title)),
    value !== "" && wanted === undefined && !isDrawn ? el("p.notice", {}, `The page does not hold ${value} for it. `, el("code", {}, command), " ", copyButton("command", command)) : null,
    plotOf(one, rows, value),
    valueTable(title, one, rows, columns, wanted), printedTable(one.name));
}

/** Returns what documents print of a function where no case holds it, a row for each call and a column for each document; null where there is nothing. */
function printedTable(name) {
  const printed = (conversions().statements.printed || []).filter(({ call }) => call.startsWith(`${name}(`));
  if (printed.length === 0) return null;
  const [calls, sources, bases] = ["call", "source", "basis"].map((key) => [...new Set(printed.map((one) => one[key]))]);
  const letter = (basis) => el("sup", {}, String.fromCharCode(97 + bases.indexOf(basis)));
  const cell = (found) => (found === undefined ? el("td", {}) : el("td", { title: found.basis }, found.result, " ", letter(found.basis)));
  return el("div", {},
    el("div.scroll", { tabindex: "0", role: "region", "aria-label": `Printed of ${name}` }, el("table.values", {}, el("caption", {}, "What documents print of other systems and calls, and no case holds"),
      el("thead", {}, el("tr", {}, ["", ...sources].map((source) => el("th", { scope: "col" }, source)))),
      el("tbody", {}, calls.map((call) => el("tr", {}, el("th", { scope: "row" }, call),
        sources.map((source) => cell(printed.find((one) => one.call === call && one.source === source)))))))),
    el("ul.notes", {}, bases.map((basis) => el("li", {}, letter(basis), " ", basis))));
}

/** Returns whether a row is shown without being asked for: a boundary value, what was looked for, or where an engine contradicts a source. */
function isShownFirst(row, index, columns, wanted) {
  return row.isBoundary || row === wanted || columns.some((column) => column.cells[index].state === "other" || column.cells[index].otherwise);
}

/** Returns whether a literal has this value. */
function isSame(literal, value) {
  if (literal === value || bare(literal) === value) return true;
  const [left, right] = [numberOf(literal), numberOf(value)];
  return left === right && Object.is(left, right);
}

/**
 * Returns the columns of a function: the documents by dialect, and each engine by dialect. A recording of a product is a column like the
 * others.
 * @returns {Array<{origin: string, dialects: string[], cells: Array}>}
 */
function columnsOf(one, rows) {
  const data = conversions();
  const columns = one.dialects.map((dialect, index) => ({ ...statedOrigin(rows, index), dialects: [data.statements.dialects[dialect]],
    cells: rows.map((row) => (row.stated[index] === null ? { state: "open", text: "" } : { state: "stated", text: row.stated[index].value, basis: row.stated[index].basis, otherwise: row.stated[index].otherwise })) }));
  // Compilers stand before Stickler's own reference.
  const answerers = answererNames().sort((one, other) => Number(one === "reference") - Number(other === "reference"));
  for (const engine of answerers) {
    for (const [index, dialect] of one.dialects.entries()) {
      const name = data.statements.dialects[dialect];
      const column = data.columns.find((known) => known.engine === engine && known.dialect === name);
      if (column === undefined) continue;
      columns.push({ origin: engine, when: recordedWhen(column.recording), dialects: [name], cells: rows.map((row) => {
        const answer = answerOf(column, row.question);
        if (answer === undefined) return { state: "none", text: "" };
        const stated = row.stated[index];
        return { ...answer, text: answer.state === "met" && stated !== null ? stated.value : answer.text };
      }) });
    }
  }
  return ownFirst(columns.filter((column) => column.isStated || column.cells.some((cell) => cell.state !== "none")), (column) => column.dialects);
}

/** Returns who states the values of a dialect: documents, or a recording by its product and version where there is nothing else. */
function statedOrigin(rows, index) {
  const bases = new Set(rows.filter((row) => row.stated[index] !== null).map((row) => row.stated[index].basis));
  const sources = [...new Set([...bases].map((basis) => basisOf(basis).source))].map(sourceOf);
  const isRecording = sources.length > 0 && sources.every((source) => source !== undefined && source.kind === "recording" && source.read);
  return { isStated: true, origin: isRecording ? [...new Set(sources.map((source) => source.read))].join("; ") : "documents", when: isRecording ? "recorded" : "" };
}

/**
 * Returns columns with the cells of some rows, given by their indices; those of one origin with the same cells are one. Of a dialect of which
 * no source states any of them, it does not matter who states the others.
 */
function folded(columns, indices) {
  const joined = new Map();
  for (const { isStated, dialects, cells, ...column } of columns) {
    const shown = indices.map((index) => cells[index]);
    const isSilent = isStated && shown.every((cell) => cell.state === "open");
    const { origin, when } = isSilent ? { origin: "documents", when: "" } : column;
    const key = JSON.stringify([origin, shown.map((cell) => [cell.state, cell.text, cell.basis, cell.otherwise?.value])]);
    if (!joined.has(key)) joined.set(key, { origin, when, isSilent, dialects: [], cells: shown });
    joined.get(key).dialects.push(...dialects);
  }
  return [...joined.values()];
}

/** Returns the table of a function's values. */
function valueTable(title, one, rows, columns, wanted) {
  const notes = new Map();
  const note = (basis) => {
    if (!notes.has(basis)) notes.set(basis, String.fromCharCode(97 + notes.size % 26).repeat(1 + Math.floor(notes.size / 26)));
    return notes.get(basis);
  };
  const cell = (known) => {
    if (known.state === "stated" && known.otherwise) {
      return el("td.number", { title: `${known.basis}; but ${bare(known.otherwise.value)} by ${known.otherwise.basis}` }, bare(known.text), " ", el("sup", {}, note(known.basis)), " ",
        el("span.tag.differs", {}, `≠ ${bare(known.otherwise.value)}`), el("sup", {}, note(known.otherwise.basis)));
    }
    if (known.state === "stated") return el("td.number", { title: known.basis }, bare(known.text), " ", el("sup", {}, note(known.basis)));
    if (known.state === "open") return el("td.number.dim", { title: "no source in Stickler says what must come" }, "open");
    if (known.state === "none") return el("td.number.dim", { title: "no case of this run asks, and no recording" }, "·");
    if (known.state === "met") return el("td.number", { title: "as its source says" }, known.text === "" ? "" : `${bare(known.text)} `, el("span.tag.pass", {}, "✓"));
    if (known.state === "recorded") return el("td.number", { title: "recorded: no source in Stickler says what must come" }, bare(known.text));
    return el("td.number", {}, answerTag(bare(known.text), true, known.number));
  };
  const heads = (shown) => shown.map((column) => el(`th.number${column.dialects.includes(own) ? ".mine" : ""}`, { scope: "col" }, originLink(column.origin, one.name, column.origin === "reference" ? "Stickler's model of" : undefined),
    column.when === "" ? null : el("div.dim", {}, column.when), dialectNames(column.dialects).map((name) => el("div.dim", { title: column.dialects.join(", ") }, name))));
  const grid = el("table.values", {});
  const list = el("ul.notes", {});
  const silent = el("p.dim", { id: "silent" });
  const own = ownSystem();
  const show = (indices) => {
    const all = folded(columns, indices);
    const shown = all.filter((column) => !column.isSilent);
    const open = all.filter((column) => column.isSilent).flatMap((column) => column.dialects);
    silent.textContent = open.length === 0 ? "" : `Open for every value shown, since no source in Stickler says what must come: ${dialectNames(open).join(", ")}.`;
    grid.replaceChildren(el("caption", {}, "What comes of these values"),
      el("thead", {}, el("tr", {}, el("th.number", { scope: "col" }, one.operands.join(", ")), heads(shown))),
      el("tbody", {}, indices.map((index, line) => el(`tr${rows[index] === wanted ? ".wanted" : ""}`, {},
        el("th.number", { scope: "row" }, rows[index].operands.map(bare).join(", ")), shown.map((column) => cell(column.cells[line]))))));
    list.replaceChildren(...[...notes].map(([basis, letter]) => el("li", {}, el("sup", {}, letter), " ", basisLink(basis))));
  };
  const every = [...rows.keys()];
  const first = every.filter((index) => isShownFirst(rows[index], index, columns, wanted));
  show(first);
  const all = el("button", { type: "button", click: () => {
    show(every);
    all.remove();
  } }, `Show all ${grouped(rows.length)} values`);
  return el("div", {},
    el("div.scroll", { tabindex: "0", role: "region", "aria-label": title }, grid),
    silent,
    first.length < rows.length ? all : null,
    list,
    el("p.dim", {}, "✓ as the source of its case says; ✗ otherwise; ≠ behind a recorded value: what the page of the same vendor says; open: no source in Stickler says what must come; ·: not asked."));
}
