// Translates one program after another, so that the compiler starts once: a JSON object a line comes in with `source`, and
// one goes out with what the compiler says and the C++ that it writes.
import { readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const { compile, loadStlibFromString } = await import(pathToFileURL(process.argv[2]).href);

// The libraries that the command line of the compiler adds by itself: those that the package has beside the compiler.
const folder = join(dirname(process.argv[2]), "../libs");
const files = (await readdir(folder).catch(() => [])).filter((name) => name.endsWith(".stlib")).sort();
const libraries = await Promise.all(files.map((name) => readFile(join(folder, name), "utf8").then(loadStlibFromString)));

// Returns where a diagnostic stands, from 1; line 0 where it does not say. Of a character that it does not know the compiler
// tells the offset alone.
function place(source, { message, line, column }) {
    const offset = /\bat offset: (\d+)/.exec(message);
    if (line || !offset) return { line: line ?? 0, column: column ?? 0 };
    const lines = source.slice(0, Number(offset[1])).split("\n");
    return { line: lines.length, column: lines.at(-1).length + 1 };
}

function translated(source) {
    try {
        const { success, errors, warnings, cppCode, headerCode } = compile(source, { libraries, headerFileName: "program.hpp" });
        const diagnostics = [...(errors ?? []), ...(warnings ?? [])].map((told) => ({
            message: String(told.message),
            ...place(source, told),
            severity: String(told.severity),
        }));
        return { success: success === true, diagnostics, program: cppCode ?? "", header: headerCode ?? "" };
    } catch (error) {
        return { crash: String(error?.stack ?? error) };
    }
}

// A message that quotes half of a character would be no valid JSON.
const whole = (_, value) => (typeof value === "string" ? value.toWellFormed?.() ?? value : value);

for await (const line of createInterface({ input: process.stdin })) {
    process.stdout.write(JSON.stringify(translated(JSON.parse(line).source), whole) + "\n");
}
