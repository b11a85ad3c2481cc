// Programs, and what was expected beside what came.

/** Returns a program with its lines numbered and its comments coloured, from its first line that is not blank. */
function programView(text) {
  const all = text.replace(/\n$/, "").split("\n");
  const blank = Math.max(0, all.findIndex((line) => line.trim() !== ""));
  const lines = all.slice(blank);
  let comment = false;
  const line = (content) => {
    const span = el("span", {});
    // Pieces of the line: comments, which may go on from line to line, and what stands between them.
    for (const piece of content.split(/(\(\*|\*\))/)) {
      if (piece === "(*") comment = true;
      if (piece !== "") span.append(comment ? el("span.comment", {}, piece) : piece);
      if (piece === "*)") comment = false;
    }
    return span;
  };
  const view = el("pre.program", { tabindex: "0", "aria-label": "program" }, lines.map(line));
  view.style.counterReset = `line ${blank}`;
  return view;
}

/**
 * Compares two texts line by line.
 * @returns {Array<[string, string]>} lines with "+" (only expected), "-" (only got) or " " before them
 */
function difference(expected, got) {
  const [left, right] = [expected, got].map((text) => (text === "" ? [] : text.split("\n")));
  // The longest common lines from each pair of places to the ends.
  const common = Array.from({ length: left.length + 1 }, () => new Uint32Array(right.length + 1));
  for (let i = left.length - 1; i >= 0; i--) {
    for (let j = right.length - 1; j >= 0; j--) {
      common[i][j] = left[i] === right[j] ? common[i + 1][j + 1] + 1 : Math.max(common[i + 1][j], common[i][j + 1]);
    }
  }
  const lines = [];
  let [i, j] = [0, 0];
  while (i < left.length || j < right.length) {
    if (i < left.length && j < right.length && left[i] === right[j]) {
      lines.push([" ", left[i]]);
      i++;
      j++;
    } else if (j >= right.length || (i < left.length && common[i + 1][j] >= common[i][j + 1])) lines.push(["+", left[i++]]);
    else lines.push(["-", right[j++]]);
  }
  return lines;
}

/** Returns what was expected and what came, as lines with signs. */
function differenceView(expected, got) {
  if (expected === null || got === null) {
    return el("p.notice", {}, "The page has no room for what was expected and what came; events.jsonl.gz beside it has both.");
  }
  const word = { "-": "less", "+": "more", " ": "same" };
  const say = { "+": "expected", "-": "got", " ": "both" };
  return el("pre", { tabindex: "0", "aria-label": "expected (-) and got (+)" },
    difference(expected, got).map(([sign, line]) => el(`div.${word[sign]}`, { title: say[sign] }, `${sign} ${line}`)));
}
