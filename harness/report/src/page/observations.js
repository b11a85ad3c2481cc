// Observations: what engines do where no source in Stickler says what they must do; of several, where they part.

/** The number of lists of observations that are shown at once. */
const MAX_OBSERVATIONS = 300;

/** Shows where engines do different things, or what a single one does. */
function showObservations(main, query) {
  const { observations, disagreements, disagreements_left_out: leftOut } = run();
  const q = (query.get("q") || "").toLowerCase();
  add(main, el("h2", {}, "Observations"), el("p", {},
    `${counted(observations, "observation was", "observations were")} recorded where no source in Stickler says what must be. `,
    "They are compared, and never failed."));
  const alone = engineNames().length < 2;
  if (alone) {
    add(main, el("p.dim", {}, "With several engines in one run, where they part stands here: ",
      el("code", {}, "stickler run --engine reference --engine ironplc")));
  }
  const list = el("div", {});
  const show = (text) => {
    const words = text.toLowerCase().split(/\s+/).filter((word) => word !== "");
    const found = disagreements.filter(({ id, name, values }) => {
      const all = `${id} ${name} ${values.map(([value, by]) => `${value} ${by.join(" ")}`).join(" ")}`.toLowerCase();
      return words.every((word) => all.includes(word));
    });
    list.replaceChildren(table(`${counted(found.length, "list of cases", "lists of cases")} ${alone ? "with one value each" : "on which engines part"}`,
      ["case", "observed", "values", el("th.number", {}, "cases")],
      found.slice(0, MAX_OBSERVATIONS).map(({ id, name, values, cases }) => [
        el("span.code", {}, readable(id)), el("code", {}, name),
        el("div", {}, values.map(([value, by]) => el("div", {}, el("code", {}, value), alone ? "" : [" by ", by.join(" and ")]))),
        numberCell(cases)])),
    found.length > MAX_OBSERVATIONS ? el("p.dim", {}, `and ${grouped(found.length - MAX_OBSERVATIONS)} more; search for less`) : "");
  };
  add(main, el("form.filters", { role: "search", submit: (event) => event.preventDefault() },
    el("label", {}, "search", el("input", { type: "search", value: q, placeholder: "case, engine or value", input: (event) => {
      replaceAddress(addressOf("observations", { q: event.target.value }));
      show(event.target.value);
    } }))), list);
  if (leftOut > 0) add(main, el("p.notice", {}, `${counted(leftOut, "list", "lists")} more are left out here; events.jsonl.gz beside this page has all.`));
  show(q);
}
