#!/usr/bin/env python3
"""Checks the language of all texts: banned phrases and spelling.

    check_language.py ROOT            checks; exit code 1 with a list of the faults
    check_language.py ROOT --list DIR texts with banned phrases below DIR
    check_language.py ROOT --measure  occurrences by kind of text
    check_language.py ROOT --spelling codespell over strings, pages and comments; exit code 77 without codespell

banned_phrases.toml has the phrases, exceptions.toml the exceptions with their reasons and the number of remaining texts,
dictionary.txt the words of the trade that codespell does not know. resources/docs/developer/language.md describes the rules.
"""

import collections
import re
import shutil
import subprocess
import sys
from pathlib import Path

try:
    import tomllib
except ImportError:
    print("language: Python 3.11 or later is needed")
    sys.exit(77)

import texts

HERE = Path(__file__).resolve().parent
ROOMS = ("adrinput", "adrplot", "agore", "cli", "core", "desktop", "resources", "tests")
# Pages that commands write: their texts are checked as strings of the program or its data.
GENERATED = {"calculators.md", "deck-reference.md", "experiments.md", "features.md", "findings.md", "friction-torque.md", "modes-agree.md"}
# Data in which sentences are quoted: the phrases themselves, corpora of damaged inputs.
NOT_SCANNED = ("tests/language/", "tests/fuzz/corpus/")


class Rules:
    def __init__(self):
        data = tomllib.loads((HERE / "banned_phrases.toml").read_text())
        self.phrases = data["phrase"]
        for phrase in self.phrases:
            phrase["regex"] = re.compile(phrase["pattern"], re.IGNORECASE)
        self.names = data["names"]
        self.name_regex = re.compile(self.names["pattern"])
        data = tomllib.loads((HERE / "exceptions.toml").read_text())
        self.exceptions = data.get("exception", [])
        self.remaining = data["remaining"]
        self.spelling = data["spelling"]
        self.used = set()

    def found_in(self, file, text):
        """[(phrase, matched words)] of a text, without exceptions."""
        text = " ".join(text.split())
        found = [(p, m[0]) for p in self.phrases for m in p["regex"].finditer(text)]
        for number, exception in enumerate(self.exceptions):
            if found and exception["file"] == file and exception["text"] in text:
                self.used.add(number)
                return []
        return found


def examples(rules):
    """Faults of the examples of each phrase: the test of the patterns."""
    faults = []
    for phrase in rules.phrases:
        if not phrase["regex"].search(phrase["fails"]):
            faults.append(f"banned_phrases.toml: '{phrase['pattern']}' does not match its example '{phrase['fails']}'")
        if phrase["regex"].search(phrase["passes"]):
            faults.append(f"banned_phrases.toml: '{phrase['pattern']}' matches the correct text '{phrase['passes']}'")
    faults += [f"banned_phrases.toml: [names] does not match '{n}'" for n in rules.names["fails"] if not rules.name_regex.search(n)]
    faults += [f"banned_phrases.toml: [names] matches '{n}'" for n in rules.names["passes"] if rules.name_regex.search(n)]
    faults += [f"exceptions.toml: {e['file']}: an exception needs a reason" for e in rules.exceptions if len(e.get("reason", "")) < 10]
    return faults


def files_of(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True)
    names = listed.stdout.split("\n") if listed.returncode == 0 else [str(p.relative_to(root)) for p in root.rglob("*")]
    for name in sorted(filter(None, names)):
        if not name.startswith((*NOT_SCANNED, "build/", "out/")) and (root / name).is_file():
            yield name


def collect(root):
    """{kind: [(file, line, text)]}: strings, docs, comments, tests (their names), identifiers (once each)."""
    found, names = collections.defaultdict(list), {}
    for name in files_of(root):
        path = root / name
        if path.suffix in texts.CPP:
            source = path.read_text(errors="replace")
            strings = texts.strings_of_cpp(source)
            if name.startswith("tests/"):
                starts = {source.count("\n", 0, m.start(1)) + 1 for m in re.finditer(r"\b(?:TEST_CASE|SECTION)\(\s*(\")", source)}
                found["tests"] += [(name, line, text) for line, text in strings if line in starts]
            else:
                found["strings"] += [(name, line, text) for line, text in strings]
            found["comments"] += [(name, line, text) for line, text in texts.comments_of_cpp(source)]
            for word in re.findall(r"\b[A-Za-z_]\w*\b", texts.TOKEN.sub(" ", source)):
                names.setdefault(word, (name, 1, word))
        elif path.suffix == ".py":
            source = path.read_text()
            found["strings"] += [(name, line, text) for line, text in texts.strings_of_python(source)]
            found["comments"] += [(name, line, text) for line, text in texts.comments_of_python(source)]
        elif path.suffix == ".json" and name.startswith("resources/") and name.count("/") == 1:
            found["strings"] += [(name, line, text) for line, text in texts.strings_of_json(path.read_text())]
        elif path.suffix == ".md" and path.name not in GENERATED and not name.startswith("tests/"):
            found["docs"] += [(name, line, text) for line, text in texts.paragraphs(texts.prose_of_markdown(path.read_text()))]
        elif path.suffix == ".sh":
            lines = path.read_text().split("\n")
            found["strings"] += [(name, n, line) for n, line in enumerate(lines, 1) if re.search(r"^[^#]*[\"'A-Za-z ]{20}", line)]
        elif path.name == "CMakeLists.txt":
            source = path.read_text()
            found["tests"] += [(name, source.count("\n", 0, m.start()) + 1, m[1]) for m in re.finditer(r'add_test\(NAME "([^"]*)"', source)]
    found["names"] = list(names.values())
    return found


def room_of(kind, name):
    folder = name.split("/")[0]
    return {"docs": "docs", "comments": "comments", "tests": "test_names"}.get(kind) or (folder if folder in ROOMS else "scripts")


def occurrences(rules, found):
    """{room: [(file, line, words, instead)]}"""
    hits = collections.defaultdict(list)
    for kind in ("strings", "docs", "tests", "comments"):
        for file, line, text in found[kind]:
            if len(texts.words_of(text)) < 2:
                continue
            for phrase, words in rules.found_in(file, text):
                hits[room_of(kind, file)].append((file, line, words, phrase["instead"]))
    for file, line, word in found["names"]:
        if rules.name_regex.search(word):
            hits["names"].append((file, line, word, "a name by its role"))
    return hits


def measure(rules, found, hits):
    words = {kind: sum(len(texts.words_of(text)) for _, _, text in found[kind]) for kind in ("strings", "docs", "comments", "tests")}
    strings = {room: h for room, h in hits.items() if room not in ("docs", "comments", "test_names", "names")}
    count = sum(len(h) for h in strings.values())
    long = [t for t in found["strings"] if len(texts.words_of(t[2])) >= 6]
    faulty = sum(bool(rules.found_in(file, text)) for file, _, text in long)
    print(f"strings: {count} occurrences in {len(found['strings'])} texts ({words['strings']} words)")
    print(f"strings of six words and more: {faulty} of {len(long)} texts")
    for room, kind in (("docs", "docs"), ("comments", "comments"), ("test_names", "tests")):
        print(f"{room}: {len(hits[room])} occurrences, {1000 * len(hits[room]) / max(1, words[kind]):.2f} per 1,000 words ({words[kind]} words)")
    print(f"names: {len(hits['names'])} of {len(found['names'])} identifiers, {1000 * len(hits['names']) / len(found['names']):.2f} per 1,000")


def spelling(rules, found):
    if not shutil.which("codespell"):
        print("language: codespell is not installed (./setup.sh --tests)")
        return 77
    places, lines = [], []
    for kind in ("strings", "docs", "tests", "comments"):
        for file, line, text in found[kind]:
            text = " ".join(re.sub(r"`[^`]*`|\b\w*[_/.]\w+\b|\b[a-z]+[A-Z]\w*\b", " ", text).split())
            if len(texts.words_of(text)) >= 2:
                places.append((kind, file, line))
                lines.append(text)
    command = ["codespell", "--builtin", "clear,rare,en-GB_to_en-US", "-I", HERE / "dictionary.txt", "-"]
    output = subprocess.run(command, input="\n".join(lines), capture_output=True, text=True).stdout
    faults = collections.defaultdict(set)
    for match in re.finditer(r"^(\d+): .*\n\s+(.*)$", output, re.MULTILINE):
        kind, file, line = places[int(match[1]) - 1]
        faults[room_of(kind, file)].add(f"{file}:{line}: {match[2]}")
    wrong = False
    for room in sorted({*faults, *rules.spelling}):
        count, allowed = len(faults[room]), rules.spelling.get(room, 0)
        if count > allowed:
            wrong = True
            print("\n".join([*sorted(faults[room]), f"{room}: {count} spelling faults, {allowed} allowed"]))
        elif count < allowed:
            print(f"language: {room} has {count} spelling faults; lower spelling.{room} = {allowed} in exceptions.toml")
    print(f"language: {sum(len(f) for f in faults.values())} spelling faults in {len(lines)} texts")
    return 1 if wrong else 0


def main():
    root = Path(sys.argv[1]).resolve()
    rules, found = Rules(), collect(root)
    if "--spelling" in sys.argv:
        return spelling(rules, found)
    hits = occurrences(rules, found)
    if "--list" in sys.argv:
        folder = sys.argv[sys.argv.index("--list") + 1]
        for room in hits.values():
            for file, line, words, instead in room:
                if file.startswith(folder):
                    print(f"{file}:{line}: '{words}' → {instead}")
        return 0
    if "--measure" in sys.argv:
        measure(rules, found, hits)
        return 0
    faults = examples(rules)
    for room in sorted({*hits, *rules.remaining}):
        count, allowed = len(hits[room]), rules.remaining.get(room, 0)
        if count > allowed:
            faults += [f"{file}:{line}: '{words}' → {instead}" for file, line, words, instead in hits[room][-40:]]
            faults.append(f"{room}: {count} banned phrases, {allowed} allowed")
        elif count < allowed:
            print(f"language: {room} has {count} banned phrases; lower remaining.{room} = {allowed} in exceptions.toml")
    faults += [f"exceptions.toml: {e['file']}: no text needs the exception '{e['text']}'" for n, e in enumerate(rules.exceptions) if n not in rules.used]
    for fault in faults:
        print(fault)
    print(f"language: {len(faults)} faults; {len(rules.phrases)} phrases, {sum(len(t) for t in found.values())} texts")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
