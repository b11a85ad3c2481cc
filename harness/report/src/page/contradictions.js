// Contradictions: questions to which documents, editions of the standard, recordings and measurements give different answers.

/** Shows where sources contradict each other, the largest disagreement first. */
function showContradictions(main, query) {
  const data = dataOf("conversions");
  const found = data === null ? null : data.statements.contradictions;
  add(main, el("h2", {}, "Contradictions"));
  if (!found || found.number === 0) {
    add(main, el("p.notice", {}, "No source contradicts another on the questions of this run."));
    return;
  }
  add(main, el("p", {}, `${counted(found.number, "contradiction", "contradictions")} on ${counted(found.questions, "question", "questions")}: where documents, editions of the standard, `,
    "recordings and measurements give different answers. Questions of one kind on which the same systems part in the same way are one entry, which shows the question on which the most systems differ."));
  const texts = found.topics.map((topic) => [topic.question, topic.kind, topic.case || "", topic.program || "", ...topic.others,
    ...topic.answers.flatMap(([answer, by]) => [answer, ...by.flatMap(({ system, source }) => [system, source])])].join(" ").toLowerCase());
  const list = el("div", {});
  const show = (text) => {
    const words = text.toLowerCase().split(/\s+/).filter((word) => word !== "");
    const shown = found.topics.map((topic, index) => [topic, index]).filter(([, index]) => words.every((word) => texts[index].includes(word)));
    list.replaceChildren(el("p.dim", {}, counted(shown.length, "entry", "entries")), ...shown.map(([topic, index]) => contradiction(topic, index + 1)));
  };
  const q = query.get("q") || "";
  add(main, el("form.filters", { role: "search", submit: (event) => event.preventDefault() },
    el("label", {}, "search", el("input", { type: "search", value: q, placeholder: "function, system or answer", input: (event) => {
      replaceAddress(addressOf("contradictions", { q: event.target.value }));
      show(event.target.value);
    } }))), list);
  if (found.topics.length < found.number) {
    const left = found.number - found.topics.length;
    add(main, el("p.notice", {}, `${counted(left, "smaller one is", "smaller ones are")} left out here; `, el("code", {}, "stickler contradictions --all"), " shows them."));
  }
  show(q);
}

/** Returns an entry: its question, and each answer with those who give it. */
function contradiction(topic, number) {
  const asked = questionOf(topic.question);
  const engines = asked === null ? [] : engineAnswers(asked);
  const stated = topic.answers.map(([answer]) => answer);
  const others = [...new Set(engines.map(({ answer }) => answer))].filter((answer) => !stated.includes(answer));
  const ran = (answer) => engines.filter((one) => one.answer === answer)
    .map(({ engine, dialect }) => el("div", {}, el("strong", {}, engine), el("span.dim", {}, ` (${dialect}; ${hasCases() ? "this run" : "its newest run"})`)));
  const rows = [...topic.answers, ...others.map((answer) => [answer, []])]
    .map(([answer, by]) => [el("code", {}, answer), el("div", {}, by.map(statedBy), ran(answer))]);
  const more = topic.questions > 1
    ? `; the same sides on ${counted(topic.questions - 1, "question", "questions")} more, such as ${topic.others.slice(0, 2).join(" and ")}` : "";
  const title = topic.program ? topic.question : el("code", {}, topic.question);
  return el("section", { "aria-label": topic.question },
    el("h3", {}, `${number}. `, asked === null || !asked.address ? title : link(asked.address, title)),
    el("p.dim", {}, `${readable(topic.kind)}: ${counted(stated.length, "answer", "answers")}, ${counted(topic.systems, "system", "systems")}${more}`),
    topic.program ? opening("Program", () => el("pre", {}, topic.program), false) : null,
    table("Answers", ["answer", "by"], rows));
}

/** Returns who gives an answer, with a link to where. */
function statedBy({ system, kind, source, read, address }) {
  return el("div", {}, el("strong", {}, system), " ", outward(address, source), el("span.dim", {}, ` (${kind}; ${read})`));
}

/**
 * Returns the question of a text such as `implicit(INT,DINT)`, `bits(WORD,7)` or `REAL_TO_INT(REAL#2.5) : INT`; null where the page has no answers to it.
 * @returns {{number: number, met: function(string): string|undefined, address: string|null}|null} the number of the question, what the sources of a dialect
 *   answer, and where the page shows it
 */
function questionOf(text) {
  const data = conversions();
  if (data === null) return null;
  const { words, pairs, parts, dialects } = data.statements;
  const [, first, second] = /^(?:implicit|bits)\((\w+),(.+)\)$/.exec(text) || [];
  const accepted = (one) => (dialect) => ({ yes: "accepted", "=": "accepted", warn: "accepted", no: "rejected" })[one.stated[dialects.indexOf(dialect)]?.[0]];
  if (first !== undefined) {
    const isPair = text.startsWith("implicit");
    const list = isPair ? pairs : parts;
    const at = list.findIndex((one) => words[one.from] === first && words[one.to] === second);
    return at < 0 ? null
      : { number: at + (isPair ? 0 : pairs.length), met: accepted(list[at]), address: isPair ? addressOf("convert", { from: first, to: second }) : null };
  }
  const [, name, operands, result] = /^(\w+)\((.*)\) : (\w+)$/.exec(text) || [];
  for (const one of data.byName.get(name) || []) {
    const at = one.result === result ? Array.from({ length: one.calls }, (_, index) => index).find((index) => statedOf(one, index).operands.join(", ") === operands) : undefined;
    if (at !== undefined) {
      const { stated } = statedOf(one, at);
      return { number: one.first + at, met: (dialect) => stated[one.dialects.indexOf(dialects.indexOf(dialect))]?.value, address: addressOf(name) };
    }
  }
  return null;
}

/** Returns the answers to a question of the engines that ran; the reference has none, since it is no source, nor has an engine without a value. */
function engineAnswers({ number, met }) {
  const ran = conversions().columns.filter(({ engine, recording }) => recording === null && engine !== "reference");
  const answers = ran.map((column) => {
    const given = answerOf(column, number);
    if (given === undefined) return null;
    return { engine: column.engine, dialect: column.dialect, answer: given.state === "met" ? met(column.dialect) : given.text.replace(/^(rejected|accepted).*/, "$1") };
  });
  return answers.filter((answer) => answer !== null && answer.answer !== undefined);
}
