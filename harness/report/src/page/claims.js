// Claims: each section of each source, and how many of its cases the engines meet.

/** Adds up the results of several claims for one engine. */
function summed(claims, engine) {
  const sum = {};
  for (const claim of claims) {
    for (const [key, value] of Object.entries(claim.standings[engine])) sum[key] = (sum[key] || 0) + value;
  }
  return sum;
}

/** Returns the cell of an engine for a claim, in words and with a mark beside the colour. */
function standingCell(standing, address) {
  const judged = standing.passed + standing.failed;
  const words = [];
  if (judged > 0) {
    words.push(standing.failed === 0
      ? el("span.tag.pass", {}, `✓ ${grouped(standing.passed)}`)
      : el("span.tag.fail", {}, `✗ ${grouped(standing.passed)} of ${grouped(judged)}`));
  }
  if (standing.known > 0) words.push(el("span.tag.xfail", {}, `${grouped(standing.known)} known`));
  if (standing.differs > 0) words.push(verdictTag("differs", standing.differs));
  if (standing.open > 0) words.push(el("span.tag", {}, `${grouped(standing.open)} open`));
  if (standing.unsupported > 0) words.push(verdictTag("unsupported", standing.unsupported));
  if (standing.waiting > 0) words.push(verdictTag("waiting", standing.waiting));
  if (words.length === 0) words.push(el("span.dim", {}, "–"));
  const others = standing.failed + standing.differs + standing.unsupported + standing.waiting > 0;
  return el("td", {}, el("div.tags", {}, words, others ? link(address, "cases") : null));
}

/** Shows the claims by source. */
function showClaims(main, query) {
  const { claims, header } = run();
  const engines = engineNames();
  const bySource = new Map();
  for (const claim of claims) {
    if (!bySource.has(claim.source)) bySource.set(claim.source, []);
    bySource.get(claim.source).push(claim);
  }
  add(main, el("h2", {}, "Claims"), el("p.dim", {},
    "A claim is a section of a source. A compiler fails only what a standard or its own documents say; where it misses a rule of ",
    "Stickler or another system's document, it differs. Where no source in Stickler says what must happen, a case is open: it records, and asserts nothing."));
  if (claims.length === 0) add(main, el("p.notice", {}, "The run has no case."));
  for (const [key, list] of bySource) {
    const source = sourceOf(key);
    const title = el("span", {}, el("strong", {}, key), " ", el("span.tag", {}, source ? source.kind : "unknown source"), " ",
      relationOf(source) ? el("span.tag", {}, relationOf(source)) : null, " ",
      engines.map((engine, index) => [" ", summary(summed(list, index), engine)]));
    add(main, opening(title, () => [
      source ? el("p", {}, `${source.title}, ${source.publisher}`, source.read ? el("span.dim", {}, ` (read: ${source.read})`) : null) : null,
      table(`Sections of ${key}`, ["section", ...engines], list.map((claim) => [
        el("div", {}, outward(claim.address, claim.section || "the whole source"), limitation(source, claim.section)),
        ...claim.standings.map((standing, index) => standingCell(standing,
          addressOf("cases", { engine: engines[index], claim: `${claim.source}: ${claim.section}` }))),
      ])),
    ], query.get("source") === key));
  }
  if ((header.broken_files || []).length > 0) {
    add(main, el("div.notice", {}, "Case files that could not be read, whose cases are missing:",
      el("ul", {}, header.broken_files.map((file) => el("li.code", {}, file)))));
  }

  /** Returns what the section of a source says is not there yet. */
  function limitation(source, section) {
    const stated = source && source.limitations ? source.limitations[section] : undefined;
    return stated === undefined ? null : el("div.dim", {}, `It says what is not there yet: ${stated}`);
  }

  /** Returns what an engine does with a whole source, in a few words. */
  function summary(sum, engine) {
    const judged = sum.passed + sum.failed;
    const name = engines.length > 1 ? `${engine} ` : "";
    if (judged + sum.differs + sum.open + sum.unsupported + sum.waiting === 0) return null;
    if (judged === 0) return el("span.tag", {}, `${name}${sum.differs > 0 ? `${grouped(sum.differs)} differ` : "open"}`);
    return sum.failed === 0
      ? el("span.tag.pass", {}, `✓ ${name}${grouped(sum.passed)}`)
      : el("span.tag.fail", {}, `✗ ${name}${grouped(sum.passed)} of ${grouped(judged)}`);
  }
}
