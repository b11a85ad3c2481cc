// Causes: what one mend in a compiler would put right, each with the smallest program that shows it.

/** The lists of causes: the title of each, the folder of its pages in `discrepancies`, and which causes it has. */
const CAUSE_LISTS = [
  { title: "Contradicts a source that binds the engine", folder: "", has: (cause) => !cause.differs && cause.reduction !== "partly" },
  { title: "Not made small, as the search ended before: most may show a cause of the list above", folder: "unreduced",
    has: (cause) => !cause.differs && cause.reduction === "partly" },
  { title: "Differs from rules of Stickler, or from sources that speak for other engines", folder: "differs", has: (cause) => cause.differs },
];

/**
 * Returns the causes list by list, those that explain most cases first. Each has the name by which addresses know it: its engine, the folder of
 * its page in `discrepancies`, and its number there.
 * @returns {Array<{title: string, causes: Array<{cause: Object, name: string}>}>}
 */
function causeLists() {
  return CAUSE_LISTS.map(({ title, folder, has }) => {
    const numbers = new Map();
    const causes = run().causes.filter(has).map((cause) => {
      numbers.set(cause.engine, (numbers.get(cause.engine) || 0) + 1);
      return { cause, name: [cause.engine, folder, numbers.get(cause.engine)].filter((part) => part !== "").join("/") };
    });
    return { title, causes: causes.sort((one, other) => other.cause.number - one.cause.number) };
  });
}

/** Shows the causes, those that explain most cases first, and apart those that contradict no source that binds the engine. */
function showCauses(main, query) {
  const engine = query.get("engine") || "";
  const open = query.get("cause");
  const lists = causeLists().map(({ title, causes }) => ({ title, causes: causes.filter(({ cause }) => engine === "" || cause.engine === engine) }));
  add(main, el("h2", {}, "Causes"), el("p.dim", {},
    "A cause is what one mend in the compiler would probably put right. Each has the smallest program that was found for it."));
  if (engineNames().length > 1) {
    add(main, el("div.filters", {}, choice("engine", engineNames(), engine, (chosen) => {
      location.hash = addressOf("causes", { engine: chosen });
    })));
  }
  for (const { title, causes } of lists.filter((list) => list.causes.length > 0)) {
    add(main, el("h3", {}, `${title}: ${grouped(causes.length)}`), causes.map(({ cause, name }) => causeBox(cause, name, open === name)));
  }
  const lacks = run().lacks.filter((lack) => engine === "" || lack.engine === engine);
  if (lacks.length > 0) {
    add(main, table("Features that are lacking", ["feature", "what the compiler said", "waiting"], lacks.map((lack) => [
      el("div", {}, engineNames().length > 1 ? `${lack.engine}: ` : "", quoted(lack.feature), lack.fails ? el("span.tag.fail", {}, "promised") : null),
      el("span.code", {}, lack.said), grouped(lack.waiting)])));
  }
  const leftOut = run().causes_left_out;
  if (leftOut > 0) {
    add(main, el("p.notice", {}, `${counted(leftOut, "cause", "causes")} with fewer cases left out, for which the page has no room; the folder discrepancies beside it has a page for each.`));
  }
  if (open !== null) main.querySelector("details[open]")?.scrollIntoView({ block: "start" });
  if (lists.every((list) => list.causes.length === 0)) {
    const failing = run().footer.totals.pass !== run().header.cases;
    add(main, el("p", {}, failing ? "No cause was searched for or found; " : "Nothing to explain: every case is as expected. ",
      failing ? link("#cases", "the cases that did not pass") : null));
  }
}

/** Returns the box of a cause. */
function causeBox(cause, name, open) {
  const title = [el("span.tag.fail", {}, cause.cases_shown), " ", engineNames().length > 1 ? `${cause.engine}: ` : "", quoted(cause.title)];
  if (cause.differs) title[0].className = "tag differs";
  return opening(title, () => {
    const address = addressOf("causes", { cause: name });
    return [
      el("div.actions", {}, copyButton("program", cause.shown.program), commandsOf(cause.shown) === "" ? null : copyButton("commands", commandsOf(cause.shown)),
        copyButton("text of a report", cause.report), link(address, "address of this cause"),
        link(addressOf("cases", { cause: name }), "its cases")),
      witnessView(cause.engine, cause.shown),
      cause.flaky ? el("p.notice", {}, `By chance: this came in ${cause.flaky[0]} of ${cause.flaky[1]} runs of the same program.`) : null,
      cause.reduction === "partly" ? el("p.dim", {}, "The program is not as small as it can be: the search for causes ended before.") : null,
      cause.shown.neighbours ? el("p", {}, quoted(cause.shown.neighbours)) : null,
      explained(cause),
    ];
  }, open);
}

/** Returns a title whose pieces between backquotes are code. */
function quoted(title) {
  return title.split("`").map((piece, index) => (index % 2 === 0 ? piece : el("code", {}, piece)));
}

/** Returns the commands by which a person sees it without Stickler. */
function commandsOf(shown) {
  const files = shown.files.slice(1).map(([name, text]) => `cat > ${name} <<'END'\n${text.replace(/\n?$/, "\n")}END`);
  const tools = shown.tools.map(([variable, value]) => `${variable}="\${${variable}:-${value}}"`);
  // Each command is run only where the one before it succeeded.
  return shown.commands.length === 0 ? "" : [...tools, ...files, shown.commands.join(" &&\n")].join("\n");
}

/** Returns a program, what must come of it and what came. */
function witnessView(engine, shown) {
  const rerun = rerunOf(engine, shown.case, shown.dialect);
  const commands = commandsOf(shown);
  return el("div.pair", {},
    el("div", {}, el("p", {}, shown.about), programView(shown.program)),
    el("div", {},
      el("p", {}, shown.is_derived ? "Found through cases of " : "Expected by ", basisLink(shown.basis)),
      differenceView(shown.expected, shown.got),
      commands === "" ? null : [el("p", {}, "With the compiler's own tools, beside ", el("code", {}, shown.files[0][0]), ":"), el("pre", { tabindex: "0" }, commands)],
      shown.printed === "" ? null : [el("p", {}, "They print:"), el("pre", { tabindex: "0" }, shown.printed)],
      el("p", {}, "Dialect ", el("code", {}, shown.dialect), rerun === "" ? null : ["; a case that shows it: ", el("span.code", {}, rerun)])));
}

/** Returns the table of the cases that fail for a cause. */
function explained(cause) {
  const rows = [...cause.cases].sort((one, other) => other.cases - one.cases).slice(0, 60).map((some) => [
    numberCell(some.cases), verdictTag(some.verdict),
    link(addressOf("cases", { engine: cause.engine, dialect: some.dialect, probe: some.probe }), el("span.code", {}, some.probe)),
    some.dialect, basisLink(some.basis)]);
  const rest = cause.cases.length - rows.length;
  return el("div", {}, table(`${counted(cause.number, "case fails or differs", "cases fail or differ")} for it`,
    [el("th.number", {}, "cases"), "verdict", "probe", "dialect", "claim"], rows),
    rest > 0 ? el("p.dim", {}, `and ${counted(rest, "probe", "probes")} more`) : null);
}
