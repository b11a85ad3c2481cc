// The data of the page, which is unpacked when the page opens and read when it is needed first.

const unpacked = new Map();
const parsed = new Map();

/** Unpacks the data of all elements: JSON, compressed and in Base64. */
async function unpackData() {
  await Promise.all([...document.querySelectorAll("script[id^=data-]")].map(async (element) => {
    const bytes = Uint8Array.from(atob(element.textContent), (character) => character.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    unpacked.set(element.id.slice("data-".length), await new Response(stream).text());
    element.textContent = "";
  }));
}

/** Returns the data of an element, or null where the page has none. */
function dataOf(id) {
  if (!parsed.has(id)) {
    parsed.set(id, unpacked.has(id) ? JSON.parse(unpacked.get(id)) : null);
    unpacked.delete(id);
  }
  return parsed.get(id);
}

/** Returns the header, totals, claims and causes of the run. */
function run() {
  return dataOf("run");
}

/** Returns whether the page has the cases of a run; that of a site has the conversions of several runs alone. */
function hasCases() {
  return document.getElementById("data-cases") !== null;
}

/** Returns the names of the engines, in the order of the run. */
function engineNames() {
  return run().header.engines.map((engine) => engine.name);
}

/** Returns an engine of the run by its name. */
function engineOf(name) {
  return run().header.engines.find((engine) => engine.name === name);
}

/** Returns a source of the run by its key. */
function sourceOf(key) {
  return (run().header.sources || []).find((source) => source.key === key);
}

/** Splits a basis, which is written `source: section`. */
function basisOf(text) {
  const at = text.indexOf(":");
  return at < 0 ? { source: text.trim(), section: "" } : { source: text.slice(0, at).trim(), section: text.slice(at + 1).trim() };
}

/** Returns the kind of the source of a basis. */
function kindOf(basis) {
  const source = sourceOf(basisOf(basis).source);
  return source === undefined ? "" : source.kind;
}

/** Returns the address of each claim by its basis. */
const addresses = (() => {
  let known = null;
  return () => {
    if (known === null) known = new Map(run().claims.map((claim) => [`${claim.source}: ${claim.section}`, claim.address]));
    return known;
  };
})();

/** Returns a basis as a link to its section, with the kind of its source. */
function basisLink(basis) {
  const { source, section } = basisOf(basis);
  const known = sourceOf(source);
  const address = addresses().get(`${source}: ${section}`) || filledAddress(known, section);
  return el("span", {}, outward(address, basis), known ? el("span.dim", {}, ` (${[known.kind, relationOf(known)].filter(Boolean).join(", ")})`) : null);
}

/** Returns how the publisher of a source stands to the compilers that somebody else makes; nothing of the makers. */
function relationOf(source) {
  return source && source.relation && source.relation !== "maker" ? source.relation.replace("-", " ") : "";
}

/** Returns the address of a section of a source, for a claim that no case of the run checks. */
function filledAddress(source, section) {
  if (source === undefined) return "";
  const anchor = section.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
  return source.address.replace("{section}", encodeURIComponent(section)).replace("{anchor}", anchor);
}

/** Returns the command that runs a case again on an engine. */
function rerunOf(engine, id, dialect) {
  const known = engineOf(engine);
  if (known === undefined || !known.rerun) return "";
  return known.rerun.replaceAll("{dialect}", dialect).replaceAll("{id}", id.replaceAll("'", "'\\''"));
}

/** Returns the cases that did not pass, with `groups` as a list of what the cases of each have in common. */
function failedCases() {
  const data = dataOf("cases");
  if (Array.isArray(data.groups)) return data;
  const { grade, open, ...named } = data.groups;
  data.groups = open.map((flag, number) => {
    const group = { grade: grade[number], open: flag === 1 };
    for (const [key, column] of Object.entries(named)) group[key] = data.words[column[number]];
    return group;
  });
  return data;
}

/** Returns a case that did not pass, with its texts, by its number in the columns. */
function caseAt(number) {
  const { groups, verdicts, words, cases } = failedCases();
  const group = groups[cases.group[number]];
  return {
    ...group,
    id: group.id + words[cases.arguments[number]],
    verdict: verdicts[cases.verdict[number]],
    line: cases.line[number],
    expected: textAt(cases.expected[number]),
    got: textAt(cases.got[number]),
    program: textAt(cases.program[number]),
    baseline: cases.baseline[number] === null ? "" : words[cases.baseline[number]],
  };
}

/** Returns a text of several lines by its number; null where it is left out. */
function textAt(number) {
  const { texts, words } = failedCases();
  return number === null ? null : texts[number].map((line) => words[line]).join("\n");
}
