// Translates one program after another, so that the compiler starts once: a JSON object a line comes in with `source`, and
// one goes out with what the compiler says and the C++ that it writes.
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const { compile } = await import(pathToFileURL(process.argv[2]).href);

function translated(source) {
    try {
        const { success, errors, cppCode, headerCode } = compile(source, {});
        const diagnostics = (errors ?? []).map(({ message, line, column, severity }) => ({
            message: String(message),
            line: line ?? 0,
            column: column ?? 0,
            severity: String(severity),
        }));
        return { success: success === true, errors: diagnostics, program: cppCode ?? "", header: headerCode ?? "" };
    } catch (error) {
        return { crash: String(error?.stack ?? error) };
    }
}

for await (const line of createInterface({ input: process.stdin })) {
    process.stdout.write(JSON.stringify(translated(JSON.parse(line).source)) + "\n");
}
