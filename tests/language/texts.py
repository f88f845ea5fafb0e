"""Texts of the project that a person reads: string literals of C++ and Python sources, pages in Markdown, and names of tests.

Each text is a tuple (file, line, text). Adjacent string literals are one text. Placeholders ({}, %1, \\n) stay in it.
"""

import io
import json
import re
import tokenize

CPP = (".cpp", ".hpp", ".h", ".c")
# A comment, a raw string, a string, a character, or an #include: whichever starts first.
TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^\s()\\]*)\((.*?)\)\1"|"((?:[^"\\\n]|\\.)*)"|(?<![0-9A-Fa-f])\'(?:[^\'\\\n]|\\.)+\'|^\s*#\s*include[^\n]*', re.DOTALL | re.MULTILINE
)
ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\", "'": "'"}


def unescaped(text):
    return re.sub(r"\\(.)", lambda m: ESCAPES.get(m[1], m[0]), text, flags=re.DOTALL)


def strings_of_cpp(source):
    """(line, text) of each string literal; literals with only white space and comments between them are one."""
    found, start, text, end = [], None, "", 0
    for match in TOKEN.finditer(source):
        literal = match[2] if match[2] is not None else unescaped(match[3]) if match[3] is not None else None
        between = source[end : match.start()].strip()
        if start is not None and (between or literal is None and not match[0].startswith(("/", '"'))):
            found.append((start, text))
            start, text = None, ""
        if literal is not None:
            start = start if start is not None else source.count("\n", 0, match.start()) + 1
            text += literal
        end = match.end()
    return found + ([(start, text)] if start is not None else [])


def comments_of_cpp(source):
    """(line, text) of each comment; comments of consecutive lines are one."""
    found = []
    for match in TOKEN.finditer(source):
        if not match[0].startswith(("//", "/*")):
            continue
        line, text = source.count("\n", 0, match.start()) + 1, match[0].lstrip("/*! ").rstrip("*/ ")
        if found and found[-1][0] + found[-1][1].count("\n") + 1 == line and not source[source.rfind("\n", 0, match.start()) + 1 : match.start()].strip():
            found[-1] = (found[-1][0], found[-1][1] + "\n" + text)
        else:
            found.append((line, text))
    return found


def strings_of_python(source):
    """(line, text) of each string; adjacent strings are one. Docstrings are included."""
    found, joined = [], False
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.STRING:
            text = re.sub(r'^[A-Za-z]*("""|\'\'\'|"|\')(.*)\1$', r"\2", token.string, flags=re.DOTALL)
            if joined:
                found[-1] = (found[-1][0], found[-1][1] + text)
            else:
                found.append((token.start[0], text))
            joined = True
        elif token.type not in (tokenize.NL, tokenize.COMMENT):
            joined = False
    return found


def comments_of_python(source):
    return [(t.start[0], t.string.lstrip("# ")) for t in tokenize.generate_tokens(io.StringIO(source).readline) if t.type == tokenize.COMMENT]


def strings_of_json(source):
    """(line, text) of each string value."""
    found = re.finditer(r'("(?:[^"\\]|\\.)*")(\s*:)?', source)
    return [(source.count("\n", 0, m.start()) + 1, json.loads(m[1])) for m in found if not m[2]]


def prose_of_markdown(source):
    """(line, text) of each line outside code blocks, without inline code and link targets."""
    found, fenced = [], False
    for number, line in enumerate(source.split("\n"), 1):
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced and not line.startswith("    "):
            line = re.sub(r"`[^`]*`", "`x`", line)
            line = re.sub(r"\]\([^)]*\)", "]", line)
            if line.strip():
                found.append((number, line))
    return found


def paragraphs(lines):
    """Consecutive lines as one text, so that a phrase is found across a line break; list items and table rows stay apart."""
    found = []
    for number, line in lines:
        apart = re.match(r"\s*([-*|#]|\d+\.)", line)
        if found and not apart and found[-1][2] + 1 == number:
            found[-1] = (found[-1][0], found[-1][1] + " " + line.strip(), number)
        else:
            found.append((number, line, number))
    return [(number, text) for number, text, _ in found]


def words_of(text):
    return re.findall(r"[A-Za-z][A-Za-z'-]+", text)
