// Plots: the result of a function against its operand, from the values that the page holds.

const SVG = "http://www.w3.org/2000/svg";

/** The greatest number of lines in a plot. */
const MAX_LINES = 8;

/** Creates an element of a drawing. */
function svg(tag, attributes, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  add(element, ...children);
  return element;
}

/** Returns a scale that keeps sign and order and makes room for great and small numbers alike. */
function scaled(number) {
  return Math.sign(number) * Math.log10(1 + Math.abs(number));
}

/** Returns the points of a column whose operand and result are numbers. */
function pointsOf(rows, column) {
  const points = rows.map((row, index) => ({ x: numberOf(row.operands[0]), y: numberOf(column.cells[index].text), operand: row.operands[0], result: column.cells[index].text }));
  return points.filter((point) => Number.isFinite(point.x) && Number.isFinite(point.y) && point.result !== "");
}

/** Returns the plot of a function, or null where its operands or results are no numbers. */
function plotOf(one, rows, columns) {
  if (one.operands.length !== 1) return null;
  const lines = linesOf(rows, columns);
  if (lines.length === 0) return null;
  const leftOut = lines.slice(MAX_LINES).map((line) => line.name);
  return opening("Result against operand", () => [plot(one, lines.slice(0, MAX_LINES)),
    leftOut.length > 0 ? el("p.dim", {}, `The table below has what the plot has no room for: ${leftOut.join("; ")}.`) : null], true);
}

/** Returns the lines of a plot, each with the columns whose points are the same. */
function linesOf(rows, columns) {
  const lines = new Map();
  for (const column of columns) {
    const points = pointsOf(rows, column);
    if (points.length <= 3) continue;
    const key = JSON.stringify(points.map((point) => [point.x, point.y]));
    if (!lines.has(key)) lines.set(key, { points, origins: new Map() });
    const { origins } = lines.get(key);
    origins.set(column.origin, [...(origins.get(column.origin) || []), ...column.dialects]);
  }
  // Where there is no room for all, what compilers do comes before what only documents say, and Stickler's own reference last.
  const rank = ({ origins }) => Math.min(...[...origins.keys()].map((origin) => (origin === "reference" ? 2 : origin === "documents" ? 1 : 0)));
  return [...lines.values()].sort((one, other) => rank(one) - rank(other)).map(({ points, origins }) => ({ points,
    name: [...origins].map(([origin, dialects]) => `${origin}: ${dialectNames(dialects).join(", ")}`).join("; ") }));
}

/** Draws a plot with its legend. Lines differ in colour, dashes and marks. */
function plot(one, lines) {
  const [width, height, left, bottom] = [720, 340, 78, 34];
  const all = lines.flatMap((line) => line.points);
  const extent = (of) => {
    const values = all.map((point) => scaled(of(point)));
    const [least, greatest] = [Math.min(...values), Math.max(...values)];
    return least === greatest ? [least - 1, greatest + 1] : [least, greatest];
  };
  const [[x0, x1], [y0, y1]] = [extent((point) => point.x), extent((point) => point.y)];
  const x = (value) => left + ((scaled(value) - x0) / (x1 - x0)) * (width - left - 14);
  const y = (value) => height - bottom - ((scaled(value) - y0) / (y1 - y0)) * (height - bottom - 12);
  const marks = [0, 1, -1, 100, -100, 1e4, -1e4, 1e6, -1e6, 1e9, -1e9, 1e12, -1e12, 1e18, -1e18, 1e38, -1e38, 1e308, -1e308];
  const inside = (least, greatest) => marks.filter((mark) => scaled(mark) >= least && scaled(mark) <= greatest);
  const spaced = (list, place, gap) => list.reduce((kept, mark) => (kept.some((other) => Math.abs(place(other) - place(mark)) < gap) ? kept : [...kept, mark]), []);
  const label = (mark) => (Math.abs(mark) >= 1e6 ? mark.toExponential(0).replace("+", "") : String(mark));
  const drawing = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", class: "plot", "aria-label": `${one.name}: result against operand; the table below has the same values` },
    spaced(inside(x0, x1), x, 42).map((mark) => svg("g", { class: "axis" }, svg("line", { x1: x(mark), x2: x(mark), y1: 10, y2: height - bottom }),
      svg("text", { x: x(mark), y: height - bottom + 16, "text-anchor": "middle" }, label(mark)))),
    spaced(inside(y0, y1), y, 18).map((mark) => svg("g", { class: "axis" }, svg("line", { x1: left, x2: width - 14, y1: y(mark), y2: y(mark) }),
      svg("text", { x: left - 6, y: y(mark) + 4, "text-anchor": "end" }, label(mark)))),
    lines.map((line, index) => svg("g", { class: `series s${index}` },
      svg("polyline", { points: line.points.map((point) => `${x(point.x).toFixed(1)},${y(point.y).toFixed(1)}`).join(" ") }),
      line.points.map((point) => markOf(index, x(point.x), y(point.y), `${bare(point.operand)} gives ${bare(point.result)}`)))),
    svg("text", { x: width - 14, y: height - 4, "text-anchor": "end", class: "name" }, `${one.operands[0]} (logarithmic on both sides of 0)`));
  return [drawing, el("ul.legend", {}, lines.map((line, index) => el("li", {},
    svg("svg", { viewBox: "0 0 34 14", class: "plot key", "aria-hidden": "true" }, svg("g", { class: `series s${index}` },
      svg("polyline", { points: "1,7 33,7" }), markOf(index, 17, 7, ""))), " ", line.name)))];
}

/** Returns the mark of a line: each has a form of its own. */
function markOf(index, x, y, title) {
  const forms = [
    () => svg("circle", { cx: x, cy: y, r: 3.4 }), () => svg("rect", { x: x - 3, y: y - 3, width: 6, height: 6 }),
    () => svg("path", { d: `M${x} ${y - 4}l4 7h-8z` }), () => svg("path", { d: `M${x} ${y - 4.5}l4.5 4.5l-4.5 4.5l-4.5 -4.5z` }),
  ];
  const mark = forms[index % forms.length]();
  if (title !== "") mark.append(svg("title", {}, title));
  return mark;
}
