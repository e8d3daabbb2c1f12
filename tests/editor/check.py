#!/usr/bin/env python3
"""Drives rust-analyzer over the sample crate, as an editor does, and checks what it knows of the
words of a description: hover, definition, references, rename and completion.

`python3 tests/editor/check.py`; rust-analyzer: `rustup component add rust-analyzer rust-src`.
"""

import json
import os
import pathlib
import queue
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parent.parent


class Server:
    """rust-analyzer, over its standard input and output."""

    def __init__(self, folder):
        self.process = subprocess.Popen(
            ["rust-analyzer"], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL)
        self.number = 0
        self.received = queue.Queue()
        self.quiet = False
        threading.Thread(target=self.read, daemon=True).start()
        capabilities = {
            "experimental": {"serverStatusNotification": True},
            "textDocument": {"hover": {"contentFormat": ["markdown"]}},
        }
        self.ask("initialize", {
            "processId": os.getpid(),
            "rootUri": folder.as_uri(),
            "capabilities": capabilities,
            "initializationOptions": {"checkOnSave": False, "cachePriming": {"enable": False}},
        })
        self.tell("initialized", {})

    def read(self):
        out = self.process.stdout
        while True:
            length = 0
            while line := out.readline().strip():
                if line.lower().startswith(b"content-length:"):
                    length = int(line.split(b":")[1])
            if length == 0:
                return
            self.received.put(json.loads(out.read(length)))

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.process.stdin.flush()

    def tell(self, method, params):
        self.send({"method": method, "params": params})

    def handle(self, message):
        """What the server says or asks of itself."""
        if message.get("method") == "experimental/serverStatus":
            status = message["params"]
            self.quiet = status["quiescent"]
            if status["health"] == "error":
                raise RuntimeError(status.get("message"))
        elif "id" in message and "method" in message:
            asked = message["params"].get("items", []) if message["params"] else []
            self.send({"id": message["id"], "result": [None] * len(asked) or None})

    def ask(self, method, params, seconds=600):
        self.number += 1
        self.send({"id": self.number, "method": method, "params": params})
        until = time.monotonic() + seconds
        while True:
            message = self.received.get(timeout=until - time.monotonic())
            if message.get("id") == self.number and "method" not in message:
                if "error" in message:
                    code = message["error"].get("code")
                    if code in (-32801, -32802):  # the content changed, or the server canceled it
                        time.sleep(0.5)
                        return self.ask(method, params, seconds)
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            self.handle(message)

    def wait(self, seconds=900):
        until = time.monotonic() + seconds
        while not self.quiet:
            self.handle(self.received.get(timeout=until - time.monotonic()))

    def end(self):
        self.process.kill()
        self.process.wait()


class Page:
    """The source, as an editor has it open."""

    def __init__(self, server, path):
        self.server, self.path, self.uri = server, path, path.as_uri()
        self.version, self.text = 1, path.read_text()
        server.tell("textDocument/didOpen", {"textDocument": {
            "uri": self.uri, "languageId": "rust", "version": 1, "text": self.text}})

    def change(self, text):
        self.version += 1
        self.text = text
        self.server.tell("textDocument/didChange", {
            "textDocument": {"uri": self.uri, "version": self.version},
            "contentChanges": [{"text": text}]})

    def at(self, marked):
        """The position of `|` in a piece of the source that occurs once."""
        piece = marked.replace("|", "")
        assert self.text.count(piece) == 1, f"{marked}: {self.text.count(piece)} times"
        before = self.text[:self.text.index(piece) + marked.index("|")]
        return {"line": before.count("\n"), "character": len(before) - before.rfind("\n") - 1}

    def ask(self, method, marked, **others):
        return self.server.ask(f"textDocument/{method}", {
            "textDocument": {"uri": self.uri}, "position": self.at(marked), **others})

    def hover(self, marked):
        answer = self.ask("hover", marked)
        return answer["contents"]["value"] if answer else ""

    def line(self, place):
        """The line of a location, or the name of another file."""
        uri = place.get("targetUri") or place["uri"]
        span = place.get("targetSelectionRange") or place["range"]
        if uri != self.uri:
            return uri.rsplit("/", 1)[1]
        return self.text.splitlines()[span["start"]["line"]].strip()

    def definition(self, marked):
        answer = self.ask("definition", marked) or []
        places = answer if isinstance(answer, list) else [answer]
        return sorted({self.line(place) for place in places})

    def references(self, marked):
        found = self.ask("references", marked, context={"includeDeclaration": True}) or []
        here = [place["range"] for place in found if place["uri"] == self.uri]
        return len({json.dumps(span, sort_keys=True) for span in here})

    def rename(self, marked, name):
        """The source, renamed."""
        answer = self.ask("rename", marked, newName=name)
        edits = dict(answer.get("changes") or {})
        for change in answer.get("documentChanges") or []:
            edits.setdefault(change["textDocument"]["uri"], []).extend(change["edits"])
        assert set(edits) == {self.uri}, f"{marked}: other files are renamed: {set(edits)}"
        lines = self.text.splitlines(keepends=True)
        starts = [sum(map(len, lines[:number])) for number in range(len(lines) + 1)]
        place = lambda at: starts[at["line"]] + at["character"]
        spans = {(place(edit["range"]["start"]), place(edit["range"]["end"]), edit["newText"])
                 for edit in edits[self.uri]}
        text = self.text
        for start, end, new in sorted(spans, reverse=True):
            text = text[:start] + new + text[end:]
        return text

    def completion(self, marked):
        answer = self.ask("completion", marked) or []
        items = answer["items"] if isinstance(answer, dict) else answer
        return {re.split(r"[(…!\s]", item["label"])[0] for item in items}


FAILED = []


def expect(what, holds, seen):
    print("ok    " if holds else "FAILED", what)
    if not holds:
        FAILED.append(what)
        print("       seen:", seen)


def hovers(page):
    cases = {
        "mo|tion: spatial": "coordinates of the body",
        "motion: spat|ial": "attitude",
        "mass: 85[k|g]": "Gram",
        "inertia: princ|ipal(12": "moments of inertia about the body axes",
        "outputs: [en|ergy],\n});\n\nrigid_system": "Kinetic and potential energy",
        "relative = velo|city - wind": "velocity of G",
        "relative.no|rm()": "length of a vector",
        "body(0, 0, thr|ust)": "thrust",
        "(offs|et, 0, -0.6": "offset",
        "at(noz|zle)": "Point",
        "400[N]).si|n()": "function of a scalar",
        "shoulder = revo|lute(": "hinge",
        "revolute(upp|er.tip": "BodyOfSystem",
        "upper.t|ip, lower": "Point",
        "elbow.ang|le).on": "angle",
        "elbow.angle).o|n(elbow)": "acts on",
        "mas|s: 1.2": "mass",
    }
    for marked, words in cases.items():
        text = page.hover(marked)
        expect(f"hover of {marked!r}", words in text, text)


def definitions(page):
    cases = {
        "body(0, 0, thr|ust)": "inputs: [thrust[N]",
        "(offs|et, 0, -0.6": "params: [offset",
        "at(noz|zle)": "points: [nozzle",
        "rel|ative.norm()": "locals: [relative",
        "upp|er.hinge),": "upper {",
        "lower.hin|ge),": "lower {",
        "elb|ow.angle).on": "elbow = revolute",
        "- spe|ed) / lag": "states: [speed",
        "ProbeInput { thr|ust: 400.0": "inputs: [thrust[N]",
        "state.elb|ow.angle": "elbow = revolute",
        "motion: spat|ial": "words.rs",
    }
    for marked, line in cases.items():
        found = page.definition(marked)
        holds = len(found) == 1 and (found[0].startswith(line) or line == found[0])
        expect(f"definition of {marked!r}", holds, found)
    found = page.definition("probe.accel|eration(")
    expect("definition of acceleration", "rigid_body!(Probe {" in found, found)


def references(page):
    cases = {
        "inputs: [thr|ust[N]": 5,
        "params: [off|set": 2,
        "points: [noz|zle": 2,
        "locals: [rel|ative": 3,
        "        elb|ow = revolute": 4,
        "upp|er {": 3,
        "spe|ed = (": 4,
    }
    for marked, count in cases.items():
        found = page.references(marked)
        expect(f"references of {marked!r}", found == count, found)


def renames(page, folder):
    """Each rename, at a definition and at a use, and all of them build."""
    cases = [
        ("inputs: [thr|ust[N]", "thrust", "push"),
        ("body(0, 0, thr|ust)", "thrust", "push"),
        ("ProbeInput { thr|ust: 400.0", "thrust", "push"),
        ("(offs|et, 0, -0.6", "offset", "shift"),
        ("at(noz|zle)", "nozzle", "exit"),
        ("rel|ative.norm()", "relative", "airspeed"),
        ("elb|ow.angle).on", "elbow", "knee"),
        ("upp|er.tip, lower", "upper", "arm"),
        ("- spe|ed) / lag", "speed", "turning"),
    ]
    for marked, old, new in cases:
        renamed = page.rename(marked, new)
        wanted = re.sub(rf"\b{old}\b", new, page.text)
        expect(f"rename of {marked!r}", renamed == wanted, renamed)
    renamed = re.sub(r"\bthrust\b", "push", page.text)
    (folder / "src/lib.rs").write_text(renamed)
    built = subprocess.run(["cargo", "check", "--quiet"], cwd=folder, capture_output=True)
    expect("a renamed description builds", built.returncode == 0, built.stderr.decode())


def completions(page):
    """Words that are being written."""
    whole = page.text
    cases = [
        ("    outputs: [energy],\n});\n\nrigid_system", "    pot|\n    outputs: [energy],\n});\n\nrigid_system",
         {"potentials"}, {"thrust"}),
        ("motion: spatial", "motion: spa|", {"spatial", "fixed_point"}, {"thrust", "mass"}),
        ("mass: 85[kg]", "mass: 85[k|]", {"kg", "kN"}, {"thrust"}),
        ("outputs: [energy],\n});\n\nrigid_system", "outputs: [energy, mom|],\n});\n\nrigid_system",
         {"momentum", "balance"}, {"mass_matrix"}),
        ("body(0, 0, thrust)", "body(0, 0, thr|)",
         {"thrust", "offset", "drag", "relative", "nozzle", "velocity"}, {"norm"}),
        ("relative.norm()", "relative.no|", {"norm", "norm_squared"}, {"thrust"}),
        ("shoulder = revolute(", "shoulder = rev|(", {"revolute", "weld"}, {"thrust"}),
        ("revolute(upper.tip", "revolute(upper.ti|", {"tip", "hinge"}, {"torque"}),
        ("(torque - 0.1", "(tor| - 0.1", {"torque", "elbow", "upper"}, {"norm"}),
    ]
    for old, marked, there, absent in cases:
        assert whole.count(old) == 1, old
        page.change(whole.replace(old, marked.replace("|", "")))
        found = page.completion(marked)
        expect(f"completion of {marked!r}", there <= found and not absent & found, sorted(found)[:60])
    page.change(whole)


def main():
    if shutil.which("rust-analyzer") is None:
        sys.exit("rust-analyzer is not installed: rustup component add rust-analyzer rust-src")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary).resolve() / "sample"
        shutil.copytree(HERE / "sample", folder, ignore=shutil.ignore_patterns("target"))
        manifest = folder / "Cargo.toml"
        path = (REPOSITORY / "runtime").as_posix()
        manifest.write_text(manifest.read_text().replace("../../../runtime", path))
        shutil.copy(REPOSITORY / "Cargo.lock", folder)
        shutil.copy(REPOSITORY / "rust-toolchain.toml", folder)
        os.environ.setdefault("CARGO_TARGET_DIR", (REPOSITORY / "target").as_posix())
        server = Server(folder)
        try:
            page = Page(server, folder / "src/lib.rs")
            server.wait()
            hovers(page)
            definitions(page)
            references(page)
            completions(page)
            renames(page, folder)
        finally:
            server.end()
    if FAILED:
        sys.exit(f"{len(FAILED)} failed")


if __name__ == "__main__":
    main()
