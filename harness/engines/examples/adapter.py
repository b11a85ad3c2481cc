#!/usr/bin/env python3
"""An adapter in one page. It takes the commands `stickler check` and `stickler eval` for a compiler and its run-time
system; put your own in their place, and what they print into DIAGNOSTIC, FAULT and values().

    stickler engine --validate python3 harness/engines/examples/adapter.py     does it keep to the protocol?
    stickler run --engine 'cmd:python3 harness/engines/examples/adapter.py'    the conformance suite

The environment variable STICKLER says where the program is; otherwise it is sought on PATH.
"""
import json, os, re, subprocess, sys, tempfile

COMPILER = os.environ.get("STICKLER", "stickler")
HELLO = {
    "type": "hello", "protocol": 1, "name": "example", "version": "1.0", "grade": "code",
    "dialects": ["ironplc-ed2", "ironplc-ed3", "ironplc-rusty", "matiec", "plcnext"],
    "abilities": ["check", "execute", "scans"],
}
DIAGNOSTIC = re.compile(r"^error\[(\w+)\]: (.*)\n *--> .*:(\d+):(\d+)$", re.MULTILINE)
FAULT = re.compile(r":(\d+): the program stops with the fault ([a-z-]+)")


def call(command, request, *options):
    """Calls the compiler on the program of a request, in a folder that is removed afterwards."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "program.st")
        with open(file, "w", encoding="utf-8", newline="") as stream:
            stream.write(request["source"])
        words = [COMPILER, command, file, "--dialect", request["dialect"], *options]
        ended = subprocess.run(words, capture_output=True, encoding="utf-8", errors="replace")
    if ended.returncode not in (0, 1, 2):
        # A crash is no rejection. An adapter that ends tells one best, with the compiler's last words on stderr.
        sys.exit(f"exit code {ended.returncode}: {ended.stderr}")
    return ended


def rejected(ended):
    """The reply of a compiler that did not accept a program."""
    found = [
        {"code": code, "message": message, "line": int(line), "column": int(column)}
        for code, message, line, column in DIAGNOSTIC.findall(ended.stdout + ended.stderr)
    ]
    if found:
        return {"type": "rejected", "diagnostics": found}
    return {"type": "error", "message": ended.stderr.strip()}


def check(request):
    ended = call("check", request)
    return {"type": "accepted"} if ended.returncode == 0 else rejected(ended)


def run(request):
    if request.get("clock") or request.get("set"):
        return {"type": "unsupported", "reason": "neither a clock nor values between scans"}
    last = request.get("scans", 1)
    reply = {"type": "executed", "values": {}}
    # The program runs once for each scan after which somebody wants to look.
    for scans in sorted({last} | {asked.get("after", last) for asked in request.get("observe", [])}):
        asked = [a for a in request.get("observe", []) if a.get("after", last) == scans]
        ended = call("eval", request, "--scans", str(scans), *(f"--observe={a['name']}" for a in asked))
        fault = FAULT.search(ended.stderr)
        if fault:
            reply.update(type="faulted", line=int(fault[1]), fault=fault[2])
        elif ended.returncode != 0:
            return rejected(ended)
        values = dict(line.split(" = ", 1) for line in ended.stdout.splitlines())
        for a in asked:
            if a["name"] in values:
                key = f"{a['name']}@{a['after']}" if "after" in a else a["name"]
                reply["values"][key] = values[a["name"]]
    return reply


def answer(line):
    """The reply to one line; nothing where the conversation is over."""
    try:
        request = json.loads(line)
        verb = request["type"]
    except (ValueError, KeyError, TypeError):
        return {"type": "error", "message": "this line is no request"}
    if verb == "bye":
        return None
    if verb == "hello":
        return HELLO
    verbs = {"check": check, "run": run}
    reply = verbs[verb](request) if verb in verbs else {"type": "error", "message": f"no `{verb}` here"}
    return {**reply, "id": request["id"]} if "id" in request else reply


for line in sys.stdin:
    reply = answer(line)
    if reply is None:
        break
    print(json.dumps(reply), flush=True)
