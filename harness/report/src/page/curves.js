// Curves of conversion functions: the dense samples that exact arithmetic computed, by the systems that do the same.

/** The views of a curve, in the order of the data. */
const CURVE_VIEWS = ["zero", "limits", "whole"];

/** Returns the items of a list in which equal ones in a row are one: `3*item`. */
function unpackedRuns(text) {
  return text.split(" ").filter((token) => token !== "").flatMap((token) => {
    const [, number, item] = /^(?:(\d+)\*)?(.*)$/.exec(token);
    return Array(Number(number || 1)).fill(item);
  });
}

/**
 * Returns numbers of a curve, each with its text: `=number` and `+difference` are in quarters, and `~literal` is any other value.
 * @param {function(number): BigInt|null} other the number from which an item differs, in quarters, by the index of the item
 */
function unpackedNumbers(text, other) {
  const numbers = [];
  for (const item of unpackedRuns(text)) {
    const [kind, rest] = [item[0], item.slice(1)];
    const quarters = kind === "~" ? null : kind === "=" ? BigInt(rest) : BigInt(rest) + other(numbers.length, numbers);
    numbers.push({ quarters, text: quarters === null ? rest : quartersText(quarters) });
  }
  return numbers;
}

/** Writes quarters as a decimal number. */
function quartersText(quarters) {
  const size = quarters < 0n ? -quarters : quarters;
  return `${quarters < 0n ? "-" : ""}${size / 4n}${["", ".25", ".5", ".75"][Number(size % 4n)]}`;
}

/** Returns whether a type is one of the durations, which curves count in milliseconds. */
function isDuration(type) {
  return type === "TIME" || type === "LTIME";
}

/** Writes a number of a curve as people write it in a program: a whole real with its point, a duration with its unit. */
function curveText(type, text) {
  if (isDuration(type)) return /[a-z]/.test(text) ? text : `${text} ms`;
  return ["REAL", "LREAL"].includes(type) && /^-?\d+$/.test(text) ? `${text}.0` : text;
}

/** Returns the number of a literal on the scale of curves, where durations are milliseconds; a duration without a unit is in milliseconds too. */
function curveNumber(type, literal) {
  if (type === "REAL") return Math.fround(numberOf(literal));
  if (!isDuration(type) || /^-?[\d.]+$/.test(literal)) return numberOf(literal);
  const parts = [...bare(literal).matchAll(/([\d.]+)(d|h|ms|us|ns|m|s)/g)];
  const units = { d: 86400e3, h: 3600e3, m: 60e3, s: 1e3, ms: 1, us: 1e-3, ns: 1e-6 };
  if (parts.length === 0) return NaN;
  return (bare(literal).startsWith("-") ? -1 : 1) * parts.reduce((sum, [, number, unit]) => sum + Number(number) * units[unit], 0);
}

/** Returns whether a point of a curve is at the value that a reader looks for. */
function isAt({ operand }, value) {
  return value !== "" && isSame(operand.replace(" ms", "ms"), value);
}

/** Returns whether a basis is what a document, a standard, a recording or a measurement says, and no rule of Stickler's own. */
function isDocumented(basis) {
  return basis !== null && kindOf(basis) !== "rule";
}

/** Returns whether an operand is in a view; that of limits reaches as far beyond them as they are apart, and around the first integers that a real skips. */
function isInView(name, from, to, x) {
  if (name === "zero") return !(from in WIDTHS) && Math.abs(x) <= 3.5;
  if (name === "whole") return true;
  if (isReal(to)) return x >= 2 ** (to === "REAL" ? 24 : 53) - 9 && x <= 2 ** (to === "REAL" ? 24 : 53) + 16;
  const [least, greatest] = limitsOf(to) || [-(2 ** 31), 2 ** 32];
  return Math.abs(x - (least + greatest) / 2) <= 1.75 * (greatest - least + 2);
}

/** Returns points by their operands, each once, with its place among them; NaN comes last. */
function inOrder(points) {
  const each = new Map(points.map((point) => [point.operand, point]));
  const compare = (one, other) => (one.x === other.x && one.exact !== null && other.exact !== null ? Number(one.exact > other.exact) - Number(one.exact < other.exact)
    : Number(Number.isNaN(one.x)) - Number(Number.isNaN(other.x)) || (one.x < other.x ? -1 : Number(one.x > other.x)));
  return [...each.values()].sort(compare).map((point, index) => ({ ...point, index }));
}

/**
 * Returns what systems do, each behaviour with the systems that share it; empty for a function without curves. The reader's own system is in the first.
 * @returns {Array<{dialects: string[], views: Array<{name: string, points: Array<{x: number, y: number, operand: string, result: string}>, basisOf: function(string, Object): string|null}>}>}
 */
function behavioursOf(one) {
  if (!one.curve) return [];
  const { words, dialects } = conversions().statements;
  const axis = unpackedNumbers(words[one.curve.axis], (index, before) => before[index - 1].quarters);
  const groups = new Map();
  one.dialects.forEach((dialect, index) => {
    const [results, bases] = one.curve.rules[one.curve.of[index]];
    if (!groups.has(results)) groups.set(results, new Map());
    groups.get(results).set(dialects[dialect], unpackedRuns(words[bases]).map((item) => (item === "-" ? null : words[Number(item)])));
  });
  const [from, to] = [one.operands[0], one.result];
  const behaviours = [...groups].map(([rule, bases]) => {
    const results = unpackedNumbers(words[rule], (index) => axis[index].quarters);
    const points = axis.map((operand, index) => ({ sample: index, exact: operand.quarters, x: curveNumber(from, operand.text), y: curveNumber(to, results[index].text),
      operand: curveText(from, operand.text), result: curveText(to, results[index].text) }));
    const views = CURVE_VIEWS.map((name) => ({ name, points: inOrder(points.filter(({ x }) => isInView(name, from, to, x))), basisOf: (dialect, point) => bases.get(dialect)[point.sample] }));
    return { dialects: [...bases.keys()], views: views.filter((view) => view.points.length > 0) };
  });
  const own = ownSystem();
  return behaviours.sort((left, right) => Number(right.dialects.includes(own)) - Number(left.dialects.includes(own)) || right.dialects.length - left.dialects.length);
}

/**
 * Returns the single results that sources state or engines gave in some dialects, with operands and results on the scale of curves.
 * @returns {Array<{x: number, y: number, operand: string, result: string, who: string, basis: string|null}>}
 */
function singleResults(one, rows, dialects) {
  const data = conversions();
  const found = [];
  const take = (row, text, who, basis) => {
    const [x, y] = [curveNumber(one.operands[0], row.operands[0]), curveNumber(one.result, text)];
    if (text !== "" && !Number.isNaN(y)) found.push({ x, y, operand: bare(row.operands[0]), result: bare(text), who, basis });
  };
  for (const dialect of dialects) {
    const at = one.dialects.findIndex((index) => data.statements.dialects[index] === dialect);
    const columns = data.columns.filter((column) => column.dialect === dialect && column.engine !== "reference");
    for (const row of rows) {
      const stated = row.stated[at];
      if (stated !== null) take(row, stated.value, titleOf(dialect), stated.basis);
      for (const column of columns) {
        const answer = answerOf(column, row.question);
        if (answer !== undefined && answer.state !== "met") take(row, answer.text, `${column.engine} (${dialect})`, null);
      }
    }
  }
  return found;
}
