#!/usr/bin/env python3
"""Checks that the shipped programs and libraries have the hardening of cmake/Hardening.cmake.

    hardening.py BUILD PROGRAM...

Of each ELF file: position-independent, RELRO, bound at the start (BIND_NOW), no executable stack, no segment that is writable and executable, the
guard of the stack and checked functions of the C library are used; the first instruction of `main` is a jump target (ENDBR64). Of each source
of the programs in BUILD/compile_commands.json: the options of the compiler. An ELF header does not tell these of each object.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

OPTIONS = ["-fstack-protector-strong", "-fstack-clash-protection", "-fcf-protection=full", "-D_FORTIFY_SOURCE=3"]
PARTS = ("core", "cli", "desktop", "adrplot", "agore", "adrinput")


def readelf(option, file):
    return subprocess.run(["readelf", "-W", option, file], capture_output=True, text=True, check=True).stdout


def faults_of_elf(file):
    header, segments, dynamic, symbols = (readelf(option, file) for option in ("-h", "-l", "-d", "--dyn-syms"))
    if not re.search(r"Type:\s+DYN", header):
        yield "not position-independent"
    if "GNU_RELRO" not in segments:
        yield "no RELRO"
    if not re.search(r"BIND_NOW|FLAGS_1\).*\bNOW\b", dynamic):
        yield "symbols are not bound at the start"
    stack = re.search(r"GNU_STACK(?:\s+0x\w+){5}\s+(\w+)", segments)
    if stack is None or "E" in stack[1]:
        yield "executable stack"
    if re.search(r"LOAD.*\sRWE\s", segments):
        yield "a segment is writable and executable"
    if "__stack_chk_fail" not in symbols:
        yield "no guard of the stack"
    if not re.search(r"__\w+_chk@", symbols):
        yield "no checked function of the C library"
    main = re.search(r"^\s*\d+: ([0-9a-f]+)\s+\d+ FUNC\s+GLOBAL \S+\s+\d+ main$", readelf("--syms", file), re.MULTILINE)
    if main and "INTERP" in segments:
        address = int(main[1], 16)
        for kind, offset, virtual, size in re.findall(r"^\s*(LOAD)\s+0x(\w+) 0x(\w+) 0x\w+ 0x(\w+)", segments, re.MULTILINE):
            begin = int(virtual, 16)
            if kind and begin <= address < begin + int(size, 16):
                with open(file, "rb") as data:
                    data.seek(int(offset, 16) + address - begin)
                    if data.read(4) != b"\xf3\x0f\x1e\xfa":
                        yield "main does not begin with ENDBR64"


def main():
    build, *programs = sys.argv[1:]
    failed = 0
    for file in programs:
        faults = list(faults_of_elf(file))
        print(f"{Path(file).name}: {'; '.join(faults) or 'hardened'}")
        failed += bool(faults)
    commands = json.loads((Path(build) / "compile_commands.json").read_text())
    root = Path(__file__).resolve().parents[1]
    count = 0
    for entry in commands:
        file = Path(entry["file"])
        if not file.is_relative_to(root) or file.suffix != ".cpp" or file.relative_to(root).parts[0] not in PARTS:
            continue
        count += 1
        missing = [option for option in OPTIONS if option not in entry["command"]]
        if missing:
            print(f"{file.relative_to(root)}: compiled without {' '.join(missing)}")
            failed += 1
    print(f"{count} sources, {len(programs)} programs and libraries, {failed} faults")
    return 1 if failed or not count else 0


sys.exit(main())
