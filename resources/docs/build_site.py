#!/usr/bin/python3
"""Builds the documentation site without a network: stages the pages, generates the reference pages, runs Doxygen and Sphinx.

    build_site.py ADORE FOLDER [--test]

The generated pages come from the JSON output of the program ADORE. FOLDER receives source/ (staged pages), html/ and html/api/cpp/ (Doxygen).
The Python reference needs the module `adore` in the folder python/ of the same build. --test leaves out Sphinx, Doxygen and the Python
reference where they are missing. A link of a page to a missing file is an error. A link to a file outside the site (decisions, sources, data)
becomes the name of the file.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

DOCS = Path(__file__).resolve().parent
ROOT = DOCS.parents[1]
OUTSIDE = {"decisions"}


def output_of(adore, *words):
    return subprocess.run([adore, *words], capture_output=True, text=True, check=True).stdout


def cell(value):
    """Text of a table cell: Markdown must not read it as markup."""
    return re.sub(r"([|*_<>\[\]`\\$])", r"\\\1", " ".join(str(value).split()))


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def code(value):
    return f"`{value}`" if str(value) else ""


def run_options(adore):
    options = json.loads(output_of(adore, "run", "--list-options", "--json"))
    rows = [[code(o["name"]), code(o["default"]), cell(o["meaning"])] for o in options]
    return f"""# Run options

`adore run --opt NAME=VALUE` sets an option of a run; the file `ADORE.json` next to a deck sets it for all runs of the
deck. This page lists the {len(rows)} options that `adore run --list-options` prints.

{table(["option", "default", "meaning"], rows)}"""


def command_sections(command, path=()):
    name = " ".join([*path, command["name"]])
    text = f"## {name}\n\n{cell(command['help'])}\n\n"
    rows = []
    for option in command.get("options", []):
        names = ", ".join(code(n) for n in option["names"])
        value = "" if option["positional"] else code(option["value"])
        choices = ", ".join(code(word) for word in option.get("words", []))
        default = code(option["default"])
        rows.append([names, value, choices, default, cell(option["help"])])
    if rows:
        text += table(["option", "value", "choices", "default", "meaning"], rows) + "\n"
    for child in command.get("commands", []):
        text += command_sections(child, [*path, command["name"]])
    return text


def commands(adore):
    tree = json.loads(output_of(adore, "--completion", "json"))
    return "# Commands of adore\n\nThis page lists the commands and options that `adore --completion json` prints.\n\n" \
        + command_sections(tree)


def integrators(adore):
    records = json.loads(output_of(adore, "schema", "--format", "json"))["records"]
    variable = next(v for r in records for v in r["variables"] if v["name"] == "intMet")
    rows = [[code(o["code"]), cell(o["meaning"])] for o in variable["options"]]
    return f"""# Integrators

The deck variable `intMet` (record 1) selects the method. `adore run --integrator NAME` replaces it for one run.
{cell(variable["help"])} [Cost and accuracy](../what-accuracy-costs.md) compares the methods.

{table(["intMet", "method"], rows)}"""


def number(value, per):
    return "" if value is None else f"{value / per:.6g}"


def validity(_):
    ranges = json.loads((ROOT / "resources/validity.json").read_text())["ranges"]
    rows = []
    for r in ranges:
        bounds = f"{number(r['least'], r['per']) or '-∞'} to {number(r['most'], r['per']) or '∞'}"
        rows.append([code(r["id"]), cell(r["law"]), cell(r["quantity"]), bounds + (f" {cell(r['unit'])}" if r["unit"] else ""),
                     r["severity"], cell(r["consequence"]), cell(r["source"])])
    header = ["finding", "law", "quantity", "valid range", "severity", "consequence outside", "source"]
    return f"""# Validity register

Each law of the program has a range of validity. A run that leaves a range reports a finding with the name below.
*note* and *warning* do not stop a run. *untrusted* ends with exit code 3, *refused* with exit code 2. An infinite bound
is absent, or belongs to the data of the oil, medium or material. The register is `resources/validity.json`
({len(rows)} ranges).

{table(header, rows)}"""


def channels(adore, folder):
    """Channels and columns of a short run of each example: as `adore show` lists them."""
    found_channels, columns = {}, {}
    for kind in ("ball", "tapered"):
        deck = folder / f"{kind}.txt"
        deck.write_text(output_of(adore, "new", kind))
        output_of(adore, "run", str(deck), "--out", str(folder / kind), "--until", "0.01rev", "--quiet", "--progress", "none")
        for channel in json.loads(output_of(adore, "show", str(folder / kind / "RESULTS.h5"), "--json"))["channels"]:
            found_channels.setdefault(channel["id"], channel)
        for sol in sorted((folder / kind).glob("SOL[1-7]")):
            shown = json.loads(output_of(adore, "show", str(sol), "--json"))
            columns.setdefault(f"{shown['kind']}", [(c["id"], c["label"], c["unit"]) for c in shown["channels"]])
    rows = [[code(c["id"]), cell(c["label"]), cell(c["unit"])] for c in found_channels.values()]
    text = f"""# Channels and columns

A channel is a quantity that a run stores, under one name in all files. `adore show FILE` lists those of a file with
their extremes. This page lists the channels of short runs of the ball and the tapered example. Other decks can have
more, such as the routines of the user. [Files and plots](../outputs.md) describes the layout of the files.

## RESULTS.h5

{len(rows)} channels at full precision, SI units.

{table(["channel", "label", "unit"], rows)}
"""
    for kind, found in columns.items():
        text += f"## {kind[0].upper() + kind[1:]}\n\n{len(found)} columns, in the order of the file; deck units.\n\n"
        text += table(["channel", "label", "unit"], [[code(a), cell(b), cell(c)] for a, b, c in found]) + "\n"
    return text


GENERATED = {"run-options": run_options, "commands": commands, "integrators": integrators, "validity": validity}


def with_links_inside(text, page, pages):
    """Links of `page` that stay within the site; others become the name of the file. Missing targets are errors."""
    def replace(match):
        label, target = match[1], match[2].partition("#")[0]
        if re.match(r"[a-z]+:", match[2]) or not target:
            return match[0]
        path = Path(os.path.normpath(page.parent / target))
        if path in pages or path.is_relative_to(DOCS / "reference") and path.stem in {*GENERATED, "channels", "python-api"}:
            return match[0]
        if not path.exists():
            sys.exit(f"{page.relative_to(ROOT)}: the link to '{match[2]}' has no target")
        if path.is_relative_to(DOCS) and path.suffix in {".png", ".bib"}:
            return match[0]
        return f"{label} (`{path.relative_to(ROOT)}`)"

    parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
    return "".join(part if part.startswith("```") else re.sub(r"(?<!\!)\[([^\]]*)\]\(\s*([^)\s]+)\)", replace, part) for part in parts)


def add_pages_without_a_place(source):
    """Pages that no toctree names appear in the developer guide; Sphinx would report them."""
    named = {"index"}
    for page in source.rglob("*.md"):
        for block in re.findall(r"^```{toctree}\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL):
            named |= {os.path.normpath(page.parent.relative_to(source) / line) for line in block.split() if not line.startswith(":")}
    others = sorted({str(page.relative_to(source).with_suffix("")) for page in source.rglob("*.md")} - named)
    if others:
        print(f"docs: no index page lists {', '.join(others)}")
        lines = [f"- [{name}](../{name}.md)" for name in others]
        toctree = ["", "```{toctree}", ":hidden:", "", *(f"../{name}" for name in others), "```", ""]
        with open(source / "developer/index.md", "a") as guide:
            guide.write("\n".join(["", "## Other pages", "", *lines, *toctree]))


PYTHON_MODULES = {"adore": "Package", "adore.deck": "Decks", "adore.run": "Runs", "adore.results": "Results", "adore.pictures": "Pictures",
                  "adore.calc": "Calculators", "adore.inverse": "Inverse calculations", "adore.routines": "User routines", "adore.schema": "Deck schema", "adore.units": "Units",
                  "adore.errors": "Errors"}


def python_reference(built):
    """The page of autodoc; without the compiled module, a page that states how to get it."""
    title = "# Python API\n\n"
    if not built:
        return title + "This site was built without the Python module. Run `./run.sh`, then `./docs.sh`. In Python, `help(adore)` shows the docstrings.\n"
    parts = [title + "Docstrings of the module `adore`. [Python tour](../python-tour.md) has examples.\n"]
    for module, heading in PYTHON_MODULES.items():
        members = "no-members" if module == "adore" else "members"
        parts.append(f"## {heading}: `{module}`\n\n```{{eval-rst}}\n.. automodule:: {module}\n   :{members}:\n```\n")
    return "\n".join(parts)


def public_headers():
    text = (ROOT / "cmake/InstallLibrary.cmake").read_text()
    names = re.search(r"set\(ADORE_PUBLIC_HEADERS\s+([^)]*)\)", text)[1].split()
    return [ROOT / "core" / name for name in names]


def run_doxygen(html):
    folder = html / "api/cpp"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    settings = (DOCS / "Doxyfile").read_text() + f'''
INPUT = {" ".join(f'"{header}"' for header in public_headers())}
STRIP_FROM_PATH = "{ROOT / "core"}"
OUTPUT_DIRECTORY = "{folder}"
'''
    if subprocess.run(["doxygen", "-"], input=settings, text=True).returncode != 0:
        sys.exit("docs: Doxygen reported warnings; the C++ reference is not valid")


def stage(adore, source):
    shutil.rmtree(source, ignore_errors=True)
    pages = {p for p in DOCS.rglob("*.md") if not OUTSIDE & set(p.relative_to(DOCS).parts)}
    for path in sorted([*pages, DOCS / "conf.py", DOCS / "references.bib", *DOCS.rglob("*.png")]):
        to = source / path.relative_to(DOCS)
        to.parent.mkdir(parents=True, exist_ok=True)
        if path in pages:
            to.write_text(with_links_inside(path.read_text(), path, pages))
        else:
            shutil.copyfile(path, to)
    for name, make in GENERATED.items():
        (source / f"reference/{name}.md").write_text(make(adore))
    with tempfile.TemporaryDirectory() as folder:
        (source / "reference/channels.md").write_text(channels(adore, Path(folder)))
    python = Path(adore).absolute().parents[1] / "python"
    built = any(python.glob("adore/_core*.so"))
    if built:
        os.environ["ADORE_PYTHON_FOLDER"] = str(python)
    (source / "reference/python-api.md").write_text(python_reference(built))
    add_pages_without_a_place(source)
    return len(pages) + len(GENERATED) + 2


def main():
    adore, folder = sys.argv[1], Path(sys.argv[2]).resolve()
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    count = stage(adore, folder / "source")
    print(f"docs: {count} pages, {len(GENERATED) + 2} of them generated")
    if "--test" in sys.argv[3:] and not (find_spec("sphinx") and find_spec("myst_parser")):
        print("docs: Sphinx and MyST are not installed (./setup.sh --docs); only the pages were staged")
        return
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", folder / "source", folder / "html"]
    if subprocess.run(command).returncode != 0:
        sys.exit("docs: Sphinx reported warnings; the site is not valid")
    if shutil.which("doxygen"):
        run_doxygen(folder / "html")
    elif "--test" in sys.argv[3:]:
        print("docs: Doxygen is not installed (./setup.sh --docs); the C++ reference is missing")
    else:
        sys.exit("docs: Doxygen is not installed. Run ./setup.sh --docs.")
    print(f"docs: open {folder}/html/index.html")


if __name__ == "__main__":
    main()
