// The page of a site: what conversions do on the newest run of each engine, without the cases of these runs.

/** Shows the engines of the site, each with the page of its run. */
function showSiteHead() {
  document.title = "Conversion functions";
  document.getElementById("top").replaceChildren(
    el("h1", {}, "Conversion functions"),
    el("p", {}, link("../index.html", "All engines")),
    el("ul.engines", {}, run().header.engines.map(({ name, version, dialects }) => el("li", {}, el("strong", {}, originLink(name, "")), " ", el("span.dim", {}, version),
      el("div.dim", { title: dialects.join(", ") }, dialectNames(dialects).join(", "))))));
}

/** Returns the name of an engine, which leads to a view of the page of its run where a site has that page. */
function originLink(origin, view, label = engineLabel(origin)) {
  const page = engineOf(origin)?.page;
  return page ? link(`${page}#${view}`, label) : label;
}

/** Shows every function with the numbers of its values, and of those on which documents or engines depart from each other. */
function showFunctions(main) {
  const data = conversions();
  const engines = engineNames();
  add(main, el("p", {}, "What each function gives for boundary values and for the values of the suite's cases: by the documents of each dialect, on the newest run of each engine, and on recorded compilers. ",
    el("em", {}, "Differ"), " counts the values for which the documents of two dialects state different results; below an engine stand those for which it gives something else than the source of its dialect."));
  if (data === null) return;
  main.prepend(systemChoice());
  const rows = [...data.byName].sort(([one], [other]) => (one < other ? -1 : 1)).map(([name, tables]) => {
    const calls = tables.flatMap((one) => Array.from({ length: one.calls }, (_, index) => ({ stated: statedOf(one, index).stated, question: one.first + index })));
    const differing = calls.filter(({ stated }) => new Set(stated.filter((known) => known !== null).map((known) => known.value)).size > 1);
    const departing = engines.map((engine) => calls.filter(({ question }) =>
      data.columns.some((column) => column.engine === engine && answerOf(column, question)?.state === "other")).length);
    return [el("th", { scope: "row" }, link(addressOf(name), name)), numberCell(calls.length), numberCell(differing.length),
      ...departing.map((number) => (number === 0 ? el("td.number.dim", {}, "–") : el("td.number", {}, el("span.tag.fail", {}, `✗ ${number}`))))];
  });
  add(main, table("Conversion functions", ["Function", ...["Values", "Differ", ...engines].map((head) => el("th.number", {}, engineLabel(head)))], rows));
}
