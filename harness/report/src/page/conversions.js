// The conversions that the page knows: what documents state, and what engines answered.

/**
 * @typedef {Object} Answer of an engine in a dialect to a question
 * @property {"met"|"recorded"|"other"} state as a source says; recorded, since none says anything; something else
 * @property {string} text the value, or what was done instead; empty where it was met
 * @property {number|null} number of the case among those that did not pass
 */

/** Returns the tables of conversions, or null where the run has none. */
function conversions() {
  const data = dataOf("conversions");
  if (data === null || data.statements.functions.length + data.statements.pairs.length + data.statements.parts.length === 0) return null;
  if (data.functions === undefined) prepare(data);
  return data;
}

/** Adds what is looked up often: functions by name, pairs by types, answers by question. */
function prepare(data) {
  const { words, pairs, parts, functions } = data.statements;
  let question = pairs.length + parts.length;
  data.functions = functions.map((one) => {
    const known = { name: words[one.name], operands: one.operands.map((word) => words[word]), result: words[one.result],
      dialects: one.dialects, first: question, calls: one.calls, boundaries: one.boundaries, curve: one.curve };
    question += one.calls;
    return known;
  });
  data.byName = new Map();
  for (const one of data.functions) {
    if (!data.byName.has(one.name)) data.byName.set(one.name, []);
    data.byName.get(one.name).push(one);
  }
  data.pairs = new Map(pairs.map((pair, number) => [`${words[pair.from]} ${words[pair.to]}`, { number, stated: pair.stated }]));
  data.types = typesInOrder(new Set(pairs.flatMap((pair) => [words[pair.from], words[pair.to]])
    .concat(data.functions.flatMap((one) => [...one.operands, one.result]))));
  data.columns = data.answers.columns.map((column) => ({
    engine: data.answers.words[column.engine], dialect: data.answers.words[column.dialect], recording: column.recording || null, packed: column, answers: null,
  }));
}

/** Returns the names of all that have answers: the engines of the run, and behind them the recorded compilers, with their versions. */
function answererNames() {
  const recorded = conversions().columns.filter((column) => column.recording !== null).map((column) => column.engine);
  return [...new Set([...engineNames(), ...recorded])];
}

/**
 * Returns a list in which what is about the reader's own system comes first, and then what is about the dialects of the compilers that ran; all
 * are in a run of the reference alone.
 */
function ownFirst(list, dialectsOf) {
  const compilers = run().header.engines.filter((engine) => engine.name !== "reference");
  const ran = new Set(compilers.flatMap((engine) => engine.dialects));
  const own = ownSystem();
  const rank = (one) => (dialectsOf(one).includes(own) ? 0 : compilers.length === 0 || dialectsOf(one).some((dialect) => ran.has(dialect)) ? 1 : 2);
  return [...list].sort((one, other) => rank(one) - rank(other));
}

/** Returns when and where answers were recorded; empty for those of this run. */
function recordedWhen(recording) {
  return recording === null ? "" : `recorded ${recording.date}`;
}

/** The order in which types are shown; others follow. */
const TYPE_ORDER = ["BOOL", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT", "REAL", "LREAL", "BYTE", "WORD", "DWORD", "LWORD",
  "TIME", "LTIME", "DATE", "LDATE", "TOD", "LTOD", "DT", "LDT", "CHAR", "WCHAR", "STRING", "WSTRING"];

/** Returns types in the usual order. */
function typesInOrder(types) {
  const place = (type) => (TYPE_ORDER.includes(type) ? TYPE_ORDER.indexOf(type) : TYPE_ORDER.length);
  return [...types].sort((one, other) => place(one) - place(other) || one.localeCompare(other));
}

/** Returns the answer of a column to a question; undefined where no case asked it. */
function answerOf(column, question) {
  if (column.answers === null) {
    column.answers = new Map();
    const { met, recorded, other } = column.packed;
    const words = conversions().answers.words;
    const each = (distances, take) => {
      let at = 0;
      distances.forEach((distance, index) => {
        at += distance;
        column.answers.set(at, take(index));
      });
    };
    each(met, () => ({ state: "met", text: "", number: null }));
    each(recorded[0], (index) => ({ state: "recorded", text: words[recorded[1][index]], number: null }));
    each(other[0], (index) => ({ state: "other", text: words[other[1][index]], number: other[2][index] }));
  }
  return column.answers.get(question);
}

/**
 * Returns what documents state of a call.
 * @returns {{operands: string[], stated: Array<{value: string, basis: string}|null>}} by the dialects of the function
 */
function statedOf(one, index) {
  const { words, calls, bases, pairs, parts } = conversions().statements;
  const call = one.first - pairs.length - parts.length + index;
  const values = calls.values[call].map((word) => words[word]);
  let next = 0;
  const stated = bases[calls.bases[call]].map((basis, column) => {
    if (basis === null) return null;
    const value = values.length === 1 ? values[0] : values[next++];
    return { value, basis: words[basis], otherwise: disputedOf(call, one.dialects[column]) };
  });
  return { operands: calls.operands[call].map((word) => words[word]), stated };
}

/** Returns what a vendor's page states of a call otherwise than was recorded, with its basis; null where there is no such statement. */
function disputedOf(call, dialect) {
  const { words, disputed } = conversions().statements;
  const found = disputed.find(([of, at]) => of === call && at === dialect);
  return found === undefined ? null : { value: words[found[2]], basis: words[found[3]] };
}

/** Returns a typed literal without its type. */
function bare(literal) {
  return literal.replace(/^[A-Z_]+#(?=.)/, "");
}

/** Returns the number that a literal is; NaN where it is none. */
function numberOf(literal) {
  const text = bare(literal).replaceAll("_", "");
  const based = /^([+-]?)(2|8|16)#([0-9A-Fa-f]+)$/.exec(text);
  if (based !== null) return (based[1] === "-" ? -1 : 1) * parseInt(based[3], Number(based[2]));
  if (/^[+-]?Infinity$/.test(text)) return Number(text);
  if (text === "TRUE") return 1;
  if (text === "FALSE") return 0;
  return /^[+-]?\d+(\.\d+)?([eE][+-]?\d+)?$/.test(text) ? Number(text) : NaN;
}

/** Compares literals by their numbers, exactly where they are whole; what is no number follows in its order. */
function compareLiterals(one, other) {
  const [left, right] = [numberOf(one), numberOf(other)];
  if (Number.isNaN(left) || Number.isNaN(right)) return Number(Number.isNaN(left)) - Number(Number.isNaN(right));
  if (left !== right) return left - right;
  const [a, b] = [bare(one), bare(other)];
  if (/^-?\d+$/.test(a) && /^-?\d+$/.test(b)) return BigInt(a) < BigInt(b) ? -1 : Number(BigInt(a) > BigInt(b));
  return Number(!a.startsWith("-")) - Number(!b.startsWith("-"));
}
