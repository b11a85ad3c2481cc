// The page itself: its head, its parts, and the way from an address to a part.

/** The parts of the page, in their order, each with the function that shows it. A part without a label has no entry of its own. */
const VIEWS = [
  { name: "functions", label: "Functions", show: showFunctions, of: "site" },
  { name: "explorer", label: "Conversions", show: showExplorer },
  { name: "convert", label: null, current: "explorer", show: showExplorer },
  { name: "matrix", label: "Matrices", show: showMatrices },
  { name: "bits", label: "Bits", show: showBits },
  { name: "contradictions", label: "Contradictions", show: showContradictions },
  { name: "claims", label: "Claims", show: showClaims, of: "run" },
  { name: "causes", label: "Causes", show: showCauses, of: "run" },
  { name: "cases", label: "Cases", show: showCases, of: "run" },
  { name: "case", label: null, current: "cases", show: showCase, of: "run" },
  { name: "observations", label: "Observations", show: showObservations, of: "run" },
].filter((view) => view.of === undefined || (view.of === "run") === hasCases());

/** Shows the engines, the versions and the totals of the run. */
function showHead() {
  const { header, footer } = run();
  const total = header.engines.map((engine) => engineLabel(engine.name)).join(", ");
  document.title = `Stickler: ${total}`;
  const seconds = (footer.duration_ms / 1000).toFixed(1);
  const searched = footer.causes_ms ? `, and ${(footer.causes_ms / 1000).toFixed(1)} s for the causes` : "";
  const parts = [
    header.shard ? `part ${header.shard} of a run` : "",
    (header.filters || []).length > 0 ? `only cases that fit ${header.filters.join(", ")}` : "",
    (header.dialects || []).length > 0 ? `only ${header.dialects.join(", ")}` : "",
  ].filter((part) => part !== "");
  document.getElementById("top").replaceChildren(
    el("h1", {}, `Structured Text conversions: ${total}`),
    el("p.dim", {}, `Stickler ${header.stickler}, cases ${header.suite}; ${header.started}; `,
      `${counted(header.cases, "case", "cases")} in ${seconds} s${searched}`, parts.length > 0 ? `; ${parts.join("; ")}` : ""),
    el("ul.engines", {}, footer.engines.map(engineCard)),
    (header.broken_files || []).length > 0
      ? el("p.notice", {}, `${counted(header.broken_files.length, "mistake", "mistakes")} in case files: some cases are missing. `, link("#claims", "Which ones"))
      : "");
}

/** Returns the card of an engine: its version, and how often each verdict came. */
function engineCard({ name, totals }) {
  const engine = engineOf(name);
  const verdicts = Object.entries(totals).filter(([verdict, number]) => number > 0 || verdict === "pass");
  return el("li", {}, el("strong", {}, engineLabel(name)), " ", el("span.dim", {}, engine ? engine.version : ""),
    el("div.tags", {}, verdicts.map(([verdict, number]) =>
      (verdict === "pass" ? verdictTag(verdict, number) : link(addressOf("cases", { engine: name, verdict }), verdictTag(verdict, number))))),
    engine ? el("div.dim", { title: engine.dialects.join(", ") }, dialectNames(engine.dialects).join(", ")) : null);
}

/** Shows the list of the parts, with the current one marked. */
function showViews(current) {
  document.getElementById("views").replaceChildren(el("ul", {}, VIEWS.filter((view) => view.label !== null).map((view) =>
    el("li", {}, el("a", { href: `#${view.name}`, "aria-current": view.name === current ? "page" : null }, view.label)))));
}

/** Shows the part that the address names; the first one shows functions, and says so where there is none of that name. */
function showAddress() {
  const { view, query } = parseAddress(location.hash);
  if (view === "main") return;
  const found = VIEWS.find((one) => one.name === view) || (view === "" ? VIEWS[0] : VIEWS.find((one) => one.name === "explorer"));
  const main = document.getElementById("main");
  main.replaceChildren();
  showViews(found.current || found.name);
  found.show(main, query, view);
  main.dataset.view = found.name;
}

/** Shows the page whose data was unpacked. */
function showPage() {
  window.addEventListener("hashchange", () => {
    showAddress();
    // A keyboard goes on from the part that was opened.
    if (!location.hash.startsWith("#main")) document.getElementById("main").focus({ preventScroll: true });
    window.scrollTo(0, 0);
  });
  if (hasCases()) showHead();
  else showSiteHead();
  showAddress();
}

unpackData().then(showPage, (error) => document.getElementById("main").replaceChildren(
  `This page needs a browser that unpacks gzip, as those of 2023 and later do; summary.md tells most of a run. (${error.message})`));
