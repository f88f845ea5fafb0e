#!/usr/bin/env python3
"""Checks that the reference page of plot pages and views has every title of the programs: docs_pages.py ROOT."""

import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
SOURCES = {
    "adrplot/plot_pages.cpp": r'\b(?:history|motion|coordinates|components|land)\(\s*"([A-Z][^"]*)"|flanges\("([^"]*)"',
    "desktop/static_pages.cpp": r'page\.title = "([^"]*)"|\bpage\("([A-Z][^"]*)"\)',
    "desktop/heat_page.cpp": r'page\.title = "([^"]*)"',
    "agore/view_options.cpp": r'return "([A-Z3][^".:]*)";',
}


def plain(text):
    return " ".join(text.lower().replace("centre", "center").split())


def main():
    page = plain((ROOT / "resources/docs/reference/plot-pages.md").read_text())
    titles = []
    for name, pattern in SOURCES.items():
        found = {one for match in re.findall(pattern, (ROOT / name).read_text()) for one in ([match] if isinstance(match, str) else match) if one}
        if not found:
            sys.exit(f"{name}: no titles found; adapt the pattern in tests/cli/docs_pages.py")
        titles += [(name, title) for title in sorted(found)]
    missing = [f"plot-pages.md: '{title}' of {name} is missing" for name, title in titles if plain(title) not in page]
    print("\n".join([*missing, f"{len(titles)} titles, {len(missing)} missing"]))
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
