// The cases that did not pass, searched and filtered.

/** The number of cases that are listed at once. */
const PAGE_LENGTH = 100;

/** The names of the filters, as they stand in an address. */
const FILTERS = ["engine", "dialect", "area", "verdict", "kind", "code", "claim", "probe", "cause", "q"];

/** Shows the filters and the cases that they leave. */
function showCases(main, query) {
  const data = failedCases();
  const chosen = Object.fromEntries(FILTERS.map((key) => [key, query.get(key) || ""]));
  const list = el("div", {});
  const update = (changes) => {
    Object.assign(chosen, changes);
    replaceAddress(addressOf("cases", chosen));
    list.replaceChildren(...listed(chosen));
  };
  const search = el("input", { type: "search", value: chosen.q, placeholder: "id or title", input: (event) => update({ q: event.target.value }) });
  const choose = (key, words, shown) => choice(key, words, chosen[key], (word) => update({ [key]: word }), shown);
  const distinct = (of) => [...new Set(data.groups.map(of))].filter((word) => word !== "").sort();
  add(main, el("h2", {}, "Cases that did not pass"),
    el("form.filters", { role: "search", submit: (event) => event.preventDefault() },
      el("label", {}, "search", search),
      choose("engine", engineNames()), choose("dialect", distinct((group) => group.dialect)), choose("area", distinct((group) => group.area)),
      choose("verdict", data.verdicts.filter((verdict) => verdict !== "pass")), choose("kind", distinct((group) => kindOf(group.basis))),
      choose("code", codesOf(data)), choose("claim", distinct((group) => group.basis)),
      chosen.probe === "" ? null : choose("probe", [chosen.probe]),
      run().causes.length === 0 ? null : choose("cause", [...causesByName().keys()], (name) => causesByName().get(name)?.title || name)),
    list);
  if (data.cases_left_out > 0) {
    add(main, el("p.notice", {}, `${counted(data.cases_left_out, "case that did not pass is", "cases that did not pass are")} not listed here; events.jsonl.gz beside this page has all.`));
  }
  if (data.texts_left_out > 0) {
    add(main, el("p.notice", {}, `The page has no room for ${counted(data.texts_left_out, "program or message", "programs and messages")}; events.jsonl.gz beside it has all.`));
  }
  list.append(...listed(chosen));
}

/** Returns the causes by the names that addresses have for them. */
function causesByName() {
  return new Map(causeLists().flatMap((list) => list.causes).map(({ cause, name }) => [name, cause]));
}

/** Returns the codes of diagnostics that occur in what was expected or came. */
function codesOf(data) {
  if (data.codes === undefined) {
    const codes = new Set();
    for (const word of data.words) {
      const found = /\b(?:error|warning) ([A-Za-z]+\d+)\b/.exec(word);
      if (found !== null) codes.add(found[1]);
    }
    data.codes = [...codes].sort();
  }
  return data.codes;
}

/** Returns the numbers of the cases that filters leave. */
function filtered(chosen) {
  const data = failedCases();
  const words = chosen.q.toLowerCase().split(/\s+/).filter((word) => word !== "");
  const cause = causesByName().get(chosen.cause);
  const explained = new Set((cause?.cases || []).map((some) => [some.probe, some.dialect, some.basis, some.verdict].join(" ")));
  const fits = data.groups.map((group) =>
    (chosen.engine === "" || group.engine === chosen.engine) && (chosen.dialect === "" || group.dialect === chosen.dialect)
    && (chosen.area === "" || group.area === chosen.area) && (chosen.kind === "" || kindOf(group.basis) === chosen.kind)
    && (chosen.claim === "" || sameBasis(group.basis, chosen.claim)) && (chosen.probe === "" || group.id === chosen.probe));
  const wanted = new Map();
  const hasCode = (text) => {
    if (text === null) return false;
    if (!wanted.has(text)) wanted.set(text, data.texts[text].some((line) => new RegExp(`\\b${chosen.code}\\b`).test(data.words[line])));
    return wanted.get(text);
  };
  const numbers = [];
  const { group, verdict, expected, got } = data.cases;
  for (let number = 0; number < group.length; number++) {
    if (!fits[group[number]]) continue;
    if (chosen.verdict !== "" && data.verdicts[verdict[number]] !== chosen.verdict) continue;
    if (chosen.cause !== "") {
      const of = data.groups[group[number]];
      if (of.engine !== cause?.engine || !explained.has([of.id, of.dialect, of.basis, data.verdicts[verdict[number]]].join(" "))) continue;
    }
    if (chosen.code !== "" && !hasCode(expected[number]) && !hasCode(got[number])) continue;
    if (words.length > 0 && !matches(number, words)) continue;
    numbers.push(number);
  }
  return numbers;

  /** Returns whether the id, dialect or title of a case has all words. */
  function matches(number, words) {
    const of = data.groups[group[number]];
    const text = `${of.id}${data.words[data.cases.arguments[number]]}@${of.dialect} ${of.title}`.toLowerCase();
    return words.every((word) => text.includes(word));
  }
}

/** Returns whether two texts are the same basis, whose blanks may differ. */
function sameBasis(one, other) {
  const [left, right] = [basisOf(one), basisOf(other)];
  return left.source === right.source && left.section === right.section;
}

/** Returns the number of the cases that filters leave, and the first of them. */
function listed(chosen) {
  const numbers = filtered(chosen);
  const box = el("div", {});
  const more = el("button", { type: "button" });
  let shown = 0;
  const extend = () => {
    const next = numbers.slice(shown, shown + PAGE_LENGTH);
    box.append(...next.map((number) => caseBox(number, false)));
    shown += next.length;
    more.hidden = shown >= numbers.length;
    more.textContent = `Show ${grouped(Math.min(PAGE_LENGTH, numbers.length - shown))} more of ${grouped(numbers.length)}`;
  };
  more.addEventListener("click", extend);
  extend();
  const total = failedCases().cases.group.length;
  return [el("p", { role: "status" }, total === 0 ? "Every case passed." : `${grouped(numbers.length)} of ${counted(total, "case", "cases")}`), box, more];
}

/** Returns the box of a case. */
function caseBox(number, open) {
  const of = caseAt(number);
  const summary = [verdictTag(of.verdict), " ", el("span.code", {}, `${readable(of.id)}@${of.dialect}`),
    engineNames().length > 1 ? ` on ${of.engine}` : "", " ", el("span.dim", {}, of.title)];
  return opening(summary, () => caseView(of), open);
}

/** Returns everything about a case. */
function caseView(of) {
  const rerun = rerunOf(of.engine, of.id, of.dialect);
  return [
    el("div.actions", {}, of.program === null ? null : copyButton("program", of.program), copyButton("command", rerun),
      link(addressOf("case", { engine: of.engine, dialect: of.dialect, id: of.id }), "address of this case")),
    el("div.pair", {},
      el("div", {}, of.program === null
        ? el("p.dim", {}, ["unsupported", "waiting", "xpass"].includes(of.verdict) ? "The program stands in the case file." : "The program is left out here.")
        : programView(of.program)),
      el("div", {},
        el("p", {}, "Expected by ", basisLink(of.basis)),
        differenceView(of.expected, of.got),
        of.grade ? el("p", {}, `grade: ${of.grade}`) : null,
        of.baseline === "" ? null : el("p", {}, "Baseline: ", of.baseline),
        el("p", {}, el("span.code", {}, of.line > 0 ? `${of.file}:${of.line}` : of.file)),
        el("p", {}, "Run it again: ", el("span.code", {}, rerun)))),
  ];
}

/** Shows one case by its address. */
function showCase(main, query) {
  const [engine, dialect, id] = ["engine", "dialect", "id"].map((key) => query.get(key) || "");
  const data = failedCases();
  const { group, arguments: rest } = data.cases;
  let number = 0;
  while (number < group.length) {
    const of = data.groups[group[number]];
    if (of.engine === engine && of.dialect === dialect && id.startsWith(of.id) && of.id + data.words[rest[number]] === id) break;
    number++;
  }
  add(main, el("h2", {}, el("span.code", {}, `${readable(id)}@${dialect}`)));
  if (number < group.length) {
    add(main, caseBox(number, true));
  } else {
    add(main, el("p", {}, `It passed on ${engine}, or is not part of this run. Run it: `),
      el("pre", { tabindex: "0" }, rerunOf(engine, id, dialect) || `stickler show '${id}@${dialect}'`));
  }
  add(main, el("p", {}, link(addressOf("cases", { engine }), "All cases that did not pass")));
}
