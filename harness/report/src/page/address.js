// Addresses behind `#`: a view, and what was chosen in it, such as `#cases?engine=ironplc&verdict=fail`.

/**
 * Parses what stands behind `#`.
 * @returns {{view: string, query: URLSearchParams}}
 */
function parseAddress(hash) {
  const text = hash.replace(/^#/, "");
  const at = text.indexOf("?");
  const view = at < 0 ? text : text.slice(0, at);
  let name = view;
  try { name = decodeURIComponent(view); } catch { /* A broken escape is shown as it is. */ }
  return { view: name, query: new URLSearchParams(at < 0 ? "" : text.slice(at + 1)) };
}

/**
 * Returns the address of a view. Choices that are empty are left out.
 * @param {string} view
 * @param {Object<string, string|number>} choices
 */
function addressOf(view, choices) {
  const query = new URLSearchParams();
  for (const [key, value] of Object.entries(choices || {})) {
    if (value !== "" && value !== null && value !== undefined) query.set(key, value);
  }
  const text = query.toString();
  return `#${encodeURIComponent(view)}${text === "" ? "" : `?${text}`}`;
}

/** Puts an address into the browser's line without leaving the view, and without an entry in its history for each letter. */
function replaceAddress(address) {
  history.replaceState(null, "", address);
}
