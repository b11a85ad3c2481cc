// Plots of conversion functions: a panel for each behaviour, in which systems that do the same are together, with three views of it.

const SVG = "http://www.w3.org/2000/svg";

/** The size of a view, and the room at its edges for numbers, and for the infinities and NaN. */
const VIEW = { width: 360, height: 216, left: 76, right: 12, top: 14, bottom: 30, beside: 26 };

/** The greatest number of panels that are shown at once. */
const MAX_PANELS = 4;

/** Creates an element of a drawing. */
function svg(tag, attributes, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(key, value);
    else if (value !== null) element.setAttribute(key, value);
  }
  add(element, ...children);
  return element;
}

/** Returns the panels of a function; null where it has no curves. `value` is the operand that the reader looks for. */
function plotOf(one, rows, value) {
  const behaviours = behavioursOf(one);
  if (behaviours.length === 0) return null;
  behaviours.forEach((behaviour, index) => {
    behaviour.parts = behaviourParts(one, behaviour);
    behaviour.words = behaviour.parts.map(({ text }) => text).join("; ");
    const alike = behaviours.slice(0, index).find(({ words }) => words === behaviour.words);
    behaviour.difference = alike === undefined ? "" : firstDifference(behaviour, alike);
  });
  const shown = behaviours.slice(0, MAX_PANELS).map((behaviour) => panel(one, rows, behaviour, value));
  const others = behaviours.slice(MAX_PANELS);
  return el("section.plots", { "aria-label": `Plots of ${one.name}` },
    el("p.dim", {}, `${counted(behaviours.length, "behaviour", "behaviours")}; systems that do the same share a panel. `,
      plotKey("stated", "stated by a source for every system of the panel"), plotKey("partly", "for some of them"), plotKey("chosen", "for none: chosen for Stickler's model (as hollow dots are)"),
      plotKey("dot", "a single value that a source states"), plotKey("cross", "what a source or compiler gives that is not on the curve: point at it"), plotKey("cursor", "the value that is read below the plots, system by system"),
      "A green band is what the result's type holds, a blue one where results wrap again and again. Arrow keys move along a view that has the focus."),
    shown, others.length === 0 ? null : opening(`${counted(others.length, "more behaviour", "more behaviours")}: ${others.map(({ dialects }) => systemNames(dialects).join(" · ")).join("; ")}`,
      () => others.map((behaviour) => panel(one, rows, behaviour, value)), value !== ""));
}

/** Returns an entry of the legend. */
function plotKey(kind, text) {
  const drawn = (status) => () => svg("line", { class: status, x1: 1, x2: 29, y1: 7, y2: 7 });
  const marks = { stated: drawn("stated"), partly: drawn("partly"), chosen: drawn("chosen"), cursor: () => svg("circle", { class: "cursor", cx: 15, cy: 7, r: 5 }),
    dot: () => svg("circle", { class: "stated", cx: 15, cy: 7, r: 3.4 }), cross: () => cross(15, 7) };
  return [el("span.key", {}, svg("svg", { viewBox: "0 0 30 14", "aria-hidden": "true" }, marks[kind]()), ` ${text}`), " "];
}

/** Returns the mark of a value beside the curve; `about` says whose it is. */
function cross(x, y, about) {
  return svg("path", { class: "cross", d: `M${x - 4} ${y - 4}l8 8m0 -8l-8 8` }, about ? svg("title", {}, about) : null);
}

/** The roundings of numbers with fractions, by what they give for 0.5, 1.5, 2.5, -0.5 and -1.5. */
const ROUNDINGS = {
  "0 1 2 0 -1": "fractions are cut off",
  "0 2 2 0 -2": "to the nearest integer, halves to the even one",
  "1 2 3 -1 -2": "to the nearest integer, halves away from zero",
  "1 2 3 0 -1": "to the nearest integer, halves to the greater one",
  "0 1 2 -1 -2": "to the next integer below",
};

/** Returns in words what a behaviour does, as far as a few of its results show it, each part with these results. */
function behaviourParts(one, behaviour) {
  const all = behaviour.views.flatMap((view) => view.points);
  const at = (x) => all.find((point) => Object.is(point.x, x));
  const halves = [0.5, 1.5, 2.5, -0.5, -1.5].map(at);
  const parts = [{ text: ROUNDINGS[halves.map((point) => String(point?.y ?? "").replace(/^-0$/, "0")).join(" ")], points: halves }];
  const limits = limitsOf(one.result);
  if (limits !== null && WIDTHS[one.result] <= 32) {
    const size = 2 ** WIDTHS[one.result];
    const beside = (isThere, limit, shift) => {
      const points = all.filter(({ x }) => isThere(x) && Math.abs(x - limit) <= size / 4 && Number.isInteger(x)).slice(0, 9);
      const isDone = (test) => points.length > 1 && points.every(test);
      return { points, text: isDone(({ x, y }) => y === x + shift) ? `the low ${WIDTHS[one.result]} bits` : isDone(({ y }) => y === limit) ? "the limit" : undefined };
    };
    const above = beside((x) => x > limits[1], limits[1], -size);
    const below = beside((x) => x < limits[0], limits[0], size);
    const told = (where, { text, points }) => ({ text: text && `${where} ${text}`, points });
    parts.push(...(above.text === below.text || below.points.length === 0 ? [told("beyond the limits", above)] : [told("above the greatest value", above), told("below the least one", below)]));
  }
  const signs = at(Infinity)?.result === at(-Infinity)?.result ? [[Infinity, "infinity"]] : [[Infinity, "infinity"], [-Infinity, "negative infinity"]];
  const ends = [...signs, [NaN, "NaN"]].filter(([x]) => at(x) !== undefined).map(([x, name]) => ({ text: `${name} gives ${at(x).result}`, points: [at(x)] }));
  return [...parts, ...ends].filter(({ text }) => text !== undefined);
}

/** Returns where a behaviour first does otherwise than another that has the same words. */
function firstDifference(behaviour, other) {
  const points = behaviour.views.flatMap((view) => view.points);
  const others = new Map(other.views.flatMap((view) => view.points).map((point) => [point.operand, point.result]));
  const found = points.find(({ operand, result }) => others.has(operand) && others.get(operand) !== result);
  return found === undefined ? "" : `Not with ${systemNames(other.dialects)[0]}, because ${found.operand} gives ${found.result} here and ${others.get(found.operand)} there.`;
}

/** Returns the panel of a behaviour: the systems that share it, its views, what is under the cursor, and all of it as a table. */
function panel(one, rows, behaviour, value) {
  const own = ownSystem();
  const judged = behaviour.dialects.includes(own) ? [own] : behaviour.dialects;
  const singles = singleResults(one, rows, judged);
  const readout = el("p.readout", { "aria-live": "polite" });
  const bits = el("div", {});
  const known = { one, judged, behaviour, singles, show: (view, point) => {
    readout.replaceChildren(el("strong", {}, `${point.operand} → ${point.result}`), " ", ...sourcesOf(view, point, behaviour, judged, singles));
    bits.replaceChildren(...bitStrip(one, behaviour, point));
  } };
  const [sought, soughtView] = behaviour.views.flatMap((view) => view.points.map((point) => [point, view])).find(([point]) => isAt(point, value)) || [];
  const start = soughtView || behaviour.views[0];
  const isChosen = ({ points }) => points.every((point) => statedFor(known, start, point).length === 0);
  const words = behaviour.parts.map((part) => `${part.text}${isChosen(part) ? " (chosen)" : ""}`).join("; ");
  const drawn = behaviour.views.map((view) => viewOf(known, view, start === view, sought));
  known.show(start, sought || notable(one, start)[0] || start.points[0]);
  return el("figure.panel", {}, el("figcaption", {}, el("h4", {}, systemNames([...judged, ...behaviour.dialects.filter((name) => !judged.includes(name))]).map((name, index) =>
    [index > 0 ? " · " : "", own !== "" && index === 0 && judged[0] === own ? el("strong.own", {}, name) : name]))),
  words === "" && behaviour.difference === "" ? null : el("p.dim", {}, words === "" ? "" : `${words[0].toUpperCase()}${words.slice(1)}. `, behaviour.difference),
  el("div.views", {}, drawn), readout, bits,
  opening("The same as a table", () => behaviour.views.map((view) => table(viewTitle(one, view), [one.operands[0], one.result, "source"],
    view.points.map((point) => [point.operand, point.result, el("span", {}, ...sourcesOf(view, point, behaviour, judged, singles))]))), false));
}

/** Returns the title of a view, which says what its axes are. */
function viewTitle(one, { name }) {
  const [from] = one.operands;
  if (name === "zero") return "Around zero";
  if (name === "whole") return `All of ${from}: symmetric logarithmic axes`;
  return isReal(one.result) ? `Where ${one.result} begins to skip whole numbers` : `Around the limits of ${one.result}: linear axes`;
}

/** Returns whether a type is one of the reals. */
function isReal(type) {
  return type === "REAL" || type === "LREAL";
}

/** Returns the least and the greatest value of an integer or bit string; null of other types. */
function limitsOf(type) {
  if (!(type in WIDTHS)) return null;
  return /^(SINT|INT|DINT|LINT)$/.test(type) ? [-(2 ** (WIDTHS[type] - 1)), 2 ** (WIDTHS[type] - 1) - 1] : [0, 2 ** WIDTHS[type] - 1];
}

/** Returns the points of a view that its caption names, the most telling one first. */
function notable(one, { name, points }) {
  const at = (x) => points.find((point) => Object.is(point.x, x));
  const limits = limitsOf(one.result);
  const wanted = name === "zero" ? [2.5, -0.5, 0.5, 1.5]
    : name === "limits" && limits !== null ? [limits[1] + 1, points.find(({ x }) => x > 1.2 * limits[1])?.x, limits[0] - 1]
      : name === "limits" ? [2 ** 24 + 1, 2 ** 24 + 3, 2 ** 53 + 1, 2 ** 32] : [1e10, Infinity, NaN];
  return wanted.map(at).filter((point) => point !== undefined);
}

/** Returns who states the result of a point, and for which systems nobody does. */
function sourcesOf(view, point, behaviour, judged, singles) {
  const by = new Map();
  const take = (basis, name) => by.set(basis, [...(by.get(basis) || []), name]);
  for (const dialect of judged) {
    const single = singles.find(({ x, basis, who }) => Object.is(x, point.x) && basis !== null && who === titleOf(dialect));
    take(view.basisOf(dialect, point) || single?.basis || null, dialect);
  }
  const deviating = singles.filter(({ x, y }) => Object.is(x, point.x) && !Object.is(y, point.y));
  const agreeing = singles.filter(({ x, y, basis }) => basis === null && Object.is(x, point.x) && Object.is(y, point.y));
  return [[...by].map(([basis, names], index) => [index > 0 ? "; " : "", judged.length > 1 ? `${systemNames(names).join(" · ")}: ` : "", basis === null ? "chosen, no source states it" : basisLink(basis)]),
    agreeing.length > 0 ? `; so does ${[...new Set(agreeing.map(({ who }) => who))].join(", ")}` : "",
    deviating.map(({ result, who, basis }) => [" ", el("span.tag.differs", {}, `≠ ${result}`), ` ${who}${basis === null ? "" : `, ${basis}`}`])].flat(4);
}

/** Returns the class of a mark by how many of the systems that count have a source for it. */
function statusOf(number, { judged }) {
  return number === judged.length ? "stated" : number > 0 ? "partly" : "chosen";
}

/** Returns the systems that count for which a source states the result of a point. */
function statedFor(known, view, point) {
  const isStated = (dialect) => isDocumented(view.basisOf(dialect, point))
    || known.singles.some(({ x, y, basis, who }) => x === point.x && y === point.y && isDocumented(basis) && who === titleOf(dialect));
  return known.judged.filter(isStated);
}

/** Returns for how many of the systems that count a source states the result of a point: `stated`, `partly` or `chosen`. */
function statusOfPoint(known, view, point) {
  return statusOf(statedFor(known, view, point).length, known);
}

/** Returns in words for which systems of a panel a source states the result of a point, where it is not for all. */
function statedWords(known, view, point) {
  const names = systemNames(statedFor(known, view, point));
  if (statusOfPoint(known, view, point) === "stated") return "";
  return names.length === 0 ? " (chosen)" : ` (stated for ${names.length > 3 ? `${names.slice(0, 2).join(" · ")} and ${names.length - 2} more` : names.join(" · ")})`;
}

/** Returns for how many of the systems that count a source states a rule by which the result of a point comes, and not only single results. */
function statusOfRule(known, view, point) {
  return statusOf(known.judged.filter((dialect) => isDocumented(view.basisOf(dialect, point))).length, known);
}

/** Returns the status of what lies between two points. */
function between(left, right) {
  return left === right ? left : [left, right].includes("chosen") ? "chosen" : "partly";
}

/** Returns the scales of a view, from numbers to places in the drawing. */
function scalesOf(view, points) {
  const { width, height, left, right, top, bottom, beside } = VIEW;
  const isWhole = view.name === "whole";
  const by = isWhole ? scaled : (number) => number;
  const extent = (values, pad) => {
    const [least, greatest] = [Math.min(...values), Math.max(...values)];
    const room = (greatest - least || 1) * pad;
    return [least - room, greatest + room];
  };
  const [x0, x1] = extent(points.map(({ x }) => by(x)), 0.01);
  // What wraps around near zero is far off: it has a row of its own at the edge, so that the steps stay steps.
  const isFar = (y) => view.name === "zero" && Math.abs(y) > 8 && points.some((point) => Math.abs(point.y) <= 8);
  const [y0, y1] = extent(points.filter(({ y }) => !isFar(y)).map(({ y }) => by(y)), points.some(({ y }) => isFar(y)) ? 0.16 : 0.07);
  const gutter = view.points.some(({ x }) => !Number.isFinite(x)) ? beside : 0;
  const [start, end] = [left + gutter, width - right - 2 * gutter];
  return { start, end, isFar,
    x: (number) => (Number.isNaN(number) ? end + gutter * 1.55 : number === Infinity ? end + gutter * 0.6 : number === -Infinity ? left + gutter * 0.4 : start + ((by(number) - x0) / (x1 - x0)) * (end - start)),
    y: (number) => (isFar(number) ? (number > 0 ? top + 2 : height - bottom - 2) : Number.isFinite(number) ? height - bottom - ((by(number) - y0) / (y1 - y0)) * (height - bottom - top) : top) };
}

/** Returns a scale that keeps sign and order and makes room for great and small numbers alike. */
function scaled(number) {
  return Math.sign(number) * Math.log10(1 + Math.abs(number));
}

/** Returns whether the results between two neighbouring samples lie on the line between them: they are equal, or follow their operands. */
function isJoined(view, left, right) {
  if (left.y === right.y) return true;
  if (view.name === "whole") return [left, right].every(({ x, y }) => Math.abs(y - x) <= 1 + 1e-6 * Math.abs(x));
  const difference = Math.abs((right.y - right.x) - (left.y - left.x));
  return view.name === "zero" ? difference === 0 : difference < 1;
}

/** Returns a view: the drawing with its cursor, and a caption that names the most telling values. */
function viewOf(known, view, isRead, found) {
  const sought = isRead ? found : undefined;
  const { one } = known;
  const points = view.points.filter(({ x, y }) => Number.isFinite(x) && Number.isFinite(y));
  const scales = scalesOf(view, points);
  const title = viewTitle(one, view);
  const line = svg("line", { class: "cursor", y1: VIEW.top, y2: VIEW.height - VIEW.bottom });
  const ring = svg("circle", { class: "cursor", r: 5 });
  let at = 0;
  const drawing = svg("svg", { viewBox: `0 0 ${VIEW.width} ${VIEW.height}`, class: `plot${isRead ? " read" : ""}`, tabindex: "0", role: "slider", "aria-label": `${one.name} of ${systemNames(known.judged).join(" · ")}. ${title}`, "aria-valuetext": "",
    "aria-valuemin": 0, "aria-valuemax": view.points.length - 1, "aria-valuenow": 0,
    pointermove: (event) => {
      const box = drawing.getBoundingClientRect();
      const place = ((event.clientX - box.left) / box.width) * VIEW.width;
      move(nearest(view, scales, place), true);
    },
    focus: () => move(at, true),
    keydown: (event) => {
      const to = { ArrowLeft: at - 1, ArrowRight: at + 1, ArrowUp: at + 1, ArrowDown: at - 1, PageUp: at + 10, PageDown: at - 10, Home: 0, End: view.points.length - 1 }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      move(Math.min(Math.max(to, 0), view.points.length - 1), true);
    } },
  axesOf(one, view, points, scales), curveParts(known, view, points, scales), line, ring);
  const move = (index, isShown) => {
    at = index;
    const point = view.points[index];
    for (const key of ["x1", "x2"]) line.setAttribute(key, scales.x(point.x).toFixed(1));
    ring.setAttribute("cx", scales.x(point.x).toFixed(1));
    ring.setAttribute("cy", scales.y(point.y).toFixed(1));
    drawing.setAttribute("aria-valuenow", index);
    drawing.setAttribute("aria-valuetext", `${point.operand} gives ${point.result}`);
    if (!isShown) return;
    drawing.closest(".views").querySelectorAll(".read").forEach((other) => other.classList.remove("read"));
    drawing.classList.add("read");
    known.show(view, point);
  };
  const told = notable(one, view);
  move((sought || told[0] || view.points[0]).index, false);
  return el("div.view", {}, el("div.name", {}, title), drawing,
    el("div.told", {}, [sought, ...told].filter((point, index, all) => point !== undefined && all.indexOf(point) === index).map((point) =>
      el(point === sought ? "strong" : "span", {}, `${point.operand} → ${point.result}`, statedWords(known, view, point)))));
}

/** Returns the index of the sample that is nearest to a place in the drawing. */
function nearest(view, scales, place) {
  let [best, least] = [0, Infinity];
  for (const { index, x } of view.points) {
    // Of samples at the same place, such as 2.5 and its neighbours, the one with the fewest digits counts.
    const distance = Math.abs(scales.x(x) - place) + 1e-3 * view.points[index].operand.length;
    if (distance < least) [best, least] = [index, distance];
  }
  return best;
}

/** Returns the grid of a view with its numbers, and the range of the target as a band. */
function axesOf(one, view, points, scales) {
  const { width, height, left, right, top, bottom } = VIEW;
  const limits = limitsOf(one.result);
  const near = points.map(({ y }) => y).filter((y) => !scales.isFar(y));
  const far = points.map(({ y }) => y).filter(scales.isFar);
  const [least, greatest] = [Math.min(...near), Math.max(...near)];
  const [first, last] = [points[0].x, points[points.length - 1].x];
  const decades = Math.log10(Math.max(1, last, -first)) / 4;
  const step = [1, 2, 3, 5, 10, 100].find((size) => size >= decades) || 100;
  const powers = [0, ...Array.from({ length: 310 }, (_, power) => [10 ** power, -(10 ** power)]).flat()];
  const even = (from, to) => {
    const sizes = Array.from({ length: 20 }, (_, power) => [1, 2, 5].map((digit) => digit * 10 ** power)).flat();
    const size = sizes.find((one) => (to - from) / one <= 4.5) || 1e20;
    return Array.from({ length: Math.floor(to / size) - Math.ceil(from / size) + 1 }, (_, index) => (Math.ceil(from / size) + index) * size);
  };
  const isLinear = view.name === "limits" && limits !== null;
  const marksX = view.name === "zero" ? [-3, -2, -1, 0, 1, 2, 3] : isLinear ? [limits[1], limits[0], 0, ...even(first, last)] : view.name === "whole" ? powers.filter((mark) => mark === 0 || Math.round(Math.log10(Math.abs(mark))) % step === 0 && Math.abs(mark) !== 1) : even(first, last);
  const marksY = view.name === "zero" && greatest - least <= 12 ? Array.from({ length: greatest - least + 1 }, (_, index) => least + index) : view.name === "zero" ? even(least, greatest) : [least, greatest, 0, ...(view.name === "whole" ? powers : even(least, greatest))];
  const spaced = (marks, place, gap) => marks.reduce((kept, mark) => (kept.some((other) => Math.abs(place(other) - place(mark)) < gap(mark, other)) ? kept : [...kept, mark]), []);
  const wide = (mark, other) => 8 + 3.2 * (axisLabel(mark).length + axisLabel(other).length);
  const special = view.points.filter(({ x }) => !Number.isFinite(x));
  const within = (mark) => mark >= first && mark <= last && (special.length === 0 || (scales.x(mark) > scales.start + 18 && scales.x(mark) < scales.end - 18));
  const band = limits === null || view.name === "zero" ? null : svg("rect", { class: "range", x: scales.x(Math.max(limits[0], first)), width: scales.x(Math.min(limits[1], last)) - scales.x(Math.max(limits[0], first)),
    y: top, height: height - bottom - top }, svg("title", {}, `what ${one.result} holds`));
  return [band,
    view.name === "zero" ? [-3.5, -2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5].map((half) => svg("line", { class: "half", x1: scales.x(half), x2: scales.x(half), y1: top, y2: height - bottom })) : null,
    spaced(marksX.filter(within), scales.x, wide).map((mark) => svg("g", { class: "axis" }, svg("line", { x1: scales.x(mark), x2: scales.x(mark), y1: top, y2: height - bottom }),
      svg("text", { x: scales.x(mark), y: height - bottom + 13, "text-anchor": "middle" }, axisLabel(mark)))),
    spaced([...marksY.filter((mark) => mark >= least && mark <= greatest), ...(far.length === 0 ? [] : [Math.max(...far)])], scales.y, () => 14).map((mark) => svg("g", { class: "axis" }, svg("line", { x1: scales.start, x2: scales.end, y1: scales.y(mark), y2: scales.y(mark) }),
      svg("text", { x: left - 4, y: scales.y(mark) + 4, "text-anchor": "end" }, axisLabel(mark)))),
    special.map(({ x }) => svg("g", { class: "axis" }, svg("line", { x1: scales.x(x), x2: scales.x(x), y1: top, y2: height - bottom }),
      svg("text", { x: scales.x(x), y: height - bottom + 13, "text-anchor": "middle" }, Number.isNaN(x) ? "NaN" : x < 0 ? "−∞" : "∞"))),
    svg("text", { class: "title", x: width - right, y: height - 4, "text-anchor": "end" }, `${one.operands[0]}${isDuration(one.operands[0]) ? " in ms" : ""} →`)];
}

/** Writes a number on an axis in few characters. */
function axisLabel(number) {
  if (Math.abs(number) >= 1e6 && Number.isInteger(Math.log10(Math.abs(number)))) return number.toExponential(0).replace("e+", "E").replace("-", "−");
  const text = String(number);
  if (text.length <= 11 && Math.abs(number) < 1e15) return text.replace("-", "−");
  return number.toExponential(1).replace("e+", "E").replace("-", "−");
}

/** Returns the lines, jumps, bands and dots of a curve, and the single values of sources and engines. */
function curveParts(known, view, points, scales) {
  const parts = [];
  const place = ({ x, y }) => [scales.x(x).toFixed(1), scales.y(y).toFixed(1)];
  const status = points.map((point) => statusOfRule(known, view, point));
  const segment = (index) => between(status[index], status[index + 1]);
  const joined = points.map((point, index) => index + 1 < points.length && isJoined(view, point, points[index + 1]));
  const isLone = (index) => !joined[index] && !(index > 0 && joined[index - 1]);
  for (let index = 0; index < points.length; index++) {
    // Lone samples side by side: the results wrap again and again, and no line joins them.
    let end = index;
    while (view.name === "whole" && end + 1 < points.length && isLone(end) && isLone(end + 1)) end++;
    if (end > index + 1) {
      const [tops, bottoms] = [Math.max(...points.slice(index, end + 1).map(({ y }) => y)), Math.min(...points.slice(index, end + 1).map(({ y }) => y))];
      const width = scales.x(points[end].x) - scales.x(points[index].x);
      parts.push(svg("rect", { class: "wraps", x: scales.x(points[index].x), width, y: scales.y(tops), height: scales.y(bottoms) - scales.y(tops) }),
        width > 44 ? svg("text", { class: "wrapping", x: scales.x(points[index].x) + width / 2, y: VIEW.top - 4, "text-anchor": "middle" }, limitsOf(known.one.result) === null ? "jumps" : "wraps") : null);
      for (let lone = index; lone <= end; lone++) parts.push(dot(place(points[lone]), 1.3, status[lone]));
      index = end;
      continue;
    }
    if (isLone(index) && view.name === "whole") parts.push(dot(place(points[index]), 1.8, status[index]));
    let last = index;
    while (joined[last] && segment(last) === segment(index)) last++;
    if (last > index) {
      parts.push(svg("polyline", { class: segment(index), points: points.slice(index, last + 1).map((point) => place(point).join(",")).join(" ") }));
    } else if (index + 1 < points.length && view.name !== "whole" && points[index + 1].x - points[index].x <= 1) {
      const [[x1, y1], [x2, y2]] = [place(points[index]), place(points[index + 1])];
      const middle = (Number(x1) + Number(x2)) / 2;
      parts.push(svg("path", { class: "jump", d: `M${x1} ${y1}H${middle}V${y2}H${x2}` }));
    }
    index = Math.max(index, last - 1);
  }
  // The results of the halves, on which roundings differ; of few samples, all of them.
  const dotted = view.name === "zero" ? (point) => Math.abs(point.x * 2) % 2 === 1 : (point) => points.length <= 60 && view.name === "limits";
  points.forEach((point) => {
    if (dotted(point)) parts.push(dot(place(point), 3, statusOfPoint(known, view, point)));
  });
  view.points.filter(({ x }) => !Number.isFinite(x)).forEach((point) => parts.push(dot(place(point), 3.2, statusOfPoint(known, view, point))));
  const [first, last] = [points[0].x, points[points.length - 1].x];
  const around = (x) => {
    const next = view.points.findIndex((point) => Object.is(point.x, x) || point.x >= x);
    return view.points.slice(Object.is(view.points[next]?.x, x) ? next : Math.max(next - 1, 0), next + 1);
  };
  // What a source states of the number beside a half would hide what comes of the half.
  const isBesideHalf = (x) => view.name === "zero" && !Number.isInteger(x * 2) && Math.abs(x * 2 - Math.round(x * 2)) < 0.02;
  for (const single of known.singles.filter(({ x }) => !isBesideHalf(x)).filter(({ x }) => (x >= first && x <= last) || (view.name === "whole" && !Number.isFinite(x)))) {
    const curve = view.points.find(({ x }) => Object.is(x, single.x));
    if (curve !== undefined && !Object.is(curve.y, single.y)) parts.push(cross(...place(single).map(Number), `${single.operand} gives ${single.result}: ${single.who}${single.basis === null ? "" : `, ${single.basis}`}`));
    else if (isDocumented(single.basis) && !around(single.x).every((point) => statusOfRule(known, view, point) === "stated")) parts.push(dot(place(single), 3, "stated"));
  }
  return parts;
}

/** Returns a dot: filled where a source states the result. */
function dot([cx, cy], r, status) {
  return svg("circle", { class: status, cx, cy, r });
}

/** Returns the bits of an operand and those that the result keeps, where a conversion of integers does nothing else. */
function bitStrip(one, behaviour, point) {
  const [from, to] = [WIDTHS[one.operands[0]], WIDTHS[one.result]];
  if (from === undefined || to === undefined) return [];
  const kept = (text) => BigInt.asUintN(to, BigInt(text));
  const isWrap = behaviour.views.every(({ points }) => points.every(({ operand, result }) => kept(operand) === kept(result)));
  if (!isWrap) return [];
  const bits = [...BigInt.asUintN(from, BigInt(point.operand)).toString(2).padStart(from, "0")];
  const group = (list, first) => list.map((bit, index) => el(`span.bit${(first - index) % 8 === 0 ? ".byte" : ""}`, {}, bit));
  const lost = Math.max(from - to, 0);
  return [el("p.bits", { "aria-label": `The result is the low ${Math.min(from, to)} bits of the operand` },
    lost > 0 ? el("span.lost", { title: "bits that are lost" }, group(bits.slice(0, lost), from - 1)) : null, el("span.kept", { title: "bits that are kept" }, group(bits.slice(lost), from - lost - 1)),
    el("span.dim", {}, lost > 0 ? ` the low ${to} of ${from} bits are kept` : ` all ${from} bits are kept${to > from ? `, ${to - from} are added` : ""}, and read as ${one.result}`))];
}
