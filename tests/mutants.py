#!/usr/bin/env python3
"""Breaks nagata3.h in one place at a time and runs the tests: they must notice.

A mutant is the header with one operator or one number changed in the body of a function. Each
file of tests is built against it and run by itself, in double, then in float, until one of them
fails, crashes or hangs. A mutant that does not compile does not count; another one is drawn. The
draw is by a hash of the changed line, so that it stays the same where the header stays the same.
tests/mutants.txt lists the mutants that cannot be told from the header, each with the reason.
Exit status 1: another mutant survived, or a line of that list fits none.
"""

import argparse
import concurrent.futures
import functools
import hashlib
import itertools
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
ALLOWED = ROOT / "tests/mutants.txt"
PRECISIONS = ("-UNAGATA3_FLOAT", "-DNAGATA3_FLOAT")
SWAPS = {
    "+": "-", "-": "+", "*": "/", "/": "*", "%": "/", "+=": "-=", "-=": "+=", "*=": "/=",
    "/=": "*=", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||",
    "||": "&&", "!": "", "&": "|", "|": "&", "<<": ">>", ">>": "<<",
}
TOKEN = re.compile(r"->|\+\+|--|<<=|>>=|<<|>>|[-+*/%&|<>=!]=|&&|\|\||\w+(?:\.\w*)?|\S")
LEVELS = ("-O0", "-O1")
FLAGS = "-std=c99 -w -Itests -fsanitize=bounds -fsanitize-undefined-trap-on-error -x c".split()
TYPE = r"\b(?:n3i?_\w+|int|char|unsigned|const)"


def functions(text):
    """(name, offset, body) of every function; comments and directives do not belong to a body."""
    blank = functools.partial(re.sub, r"[^\n]", " ")
    text = re.sub(r"/\*.*?\*/", lambda m: blank(m.group()), text, flags=re.S)
    text = re.sub(r"^[ \t]*#(?:.*\\\n)*.*$", lambda m: blank(m.group()), text, flags=re.M)
    end = 0
    for head in re.finditer(r"\b(n3i?_\w+)\s*\([^;{}]*\)\s*\{", text):
        if head.start() < end:
            continue
        depth, end = 1, head.end()
        while depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        yield head.group(1), head.end(), text[head.end() : end - 1]


def declares(before, token):
    """The token is part of a declaration: a pointer's star or an array's size."""
    if token == "*":
        return re.search(TYPE + r"\s*$", before)
    statement = re.split(r"[;{}]", before)[-1].strip()
    declared = re.search(r"(,|" + TYPE + r")\s*\w+(\[\w*\])*\[$", statement)
    return token.isdigit() and declared and re.match(r"(static\s+)?" + TYPE, statement)


def places(text):
    """(function, offset, old, new) of everything that can be changed."""
    for name, offset, body in functions(text):
        for match in TOKEN.finditer(body):
            token = match.group()
            new = str(int(token) + 1) if token.isdigit() else SWAPS.get(token)
            if new is not None and not declares(body[: match.start()], token):
                yield name, offset + match.start(), token, new


class Mutant:
    def __init__(self, text, place):
        name, offset, old, new = place
        number = text.count("\n", 0, offset)
        self.text = text[:offset] + new + text[offset + len(old) :]
        line = re.sub(r"/\*.*?\*/", "", self.text.split("\n")[number])
        self.key = name + ": " + " ".join(line.split())
        self.line = number + 1
        self.title = f"nagata3.h:{number + 1}: {old} to {new or 'nothing'} in {self.key}"


class Tests:
    """The files of tests; one at a time, with empty tables in place of the others."""

    def __init__(self, folder, compiler, samples, sources):
        self.folder, self.compiler = folder, compiler
        self.environment = dict(os.environ, N3_SAMPLES=str(samples))
        texts = {source: (ROOT / source).read_text() for source in sources}
        table = {s: re.search(r"^const test_case (\w+)\[", t, re.M) for s, t in texts.items()}
        self.tables = {found.group(1): source for source, found in table.items() if found}
        self.shared = [source for source in sources if not table[source]]
        self.kills = {name: [] for name in self.tables}
        self.level, self.limit = {}, {}
        for name, source in self.tables.items():
            others = "".join(
                f"const test_case {t}[] = {{{{0, 0}}}};\n" for t in self.tables if t != name
            )
            (folder / f"{name}.c").write_text(f'#include "{ROOT}/{source}"\n{others}')

    def compile(self, include, *arguments):
        command = [*self.compiler, f"-I{include}", *FLAGS, *map(str, arguments)]
        return subprocess.run(command, cwd=ROOT, capture_output=True).returncode == 0

    def build(self, include, table, level, precision):
        """The program of one file of tests, None where it does not compile."""
        program = include / f"{table}{level}{precision}"
        objects = []
        for source in self.shared:
            objects.append(include / f"{pathlib.Path(source).stem}{level}{precision}.o")
            if not objects[-1].exists():
                self.compile(include, level, precision, "-c", source, "-o", objects[-1])
        arguments = [self.folder / f"{table}.c", "-x", "none", *objects, "-o", program, "-lm"]
        return program if self.compile(include, level, precision, *arguments) else None

    def passes(self, program, limit):
        try:
            done = subprocess.run([program], cwd=ROOT, env=self.environment, timeout=limit,
                                  capture_output=True)
        except subprocess.TimeoutExpired:
            return False
        return done.returncode == 0

    def choose_levels(self, text):
        """Takes the faster level for each file, in double, and returns the files that fail."""
        failed = []
        include = self.folder / "unchanged"
        include.mkdir()
        (include / "nagata3.h").write_text(text)
        for table in self.tables:
            seconds = {}
            for level in LEVELS:
                start = time.monotonic()
                program = self.build(include, table, level, PRECISIONS[0])
                middle = time.monotonic()
                if not program or not self.passes(program, None):
                    failed.append(table)
                seconds[level] = time.monotonic() - start
                self.limit[table, level] = 20 + 10 * (time.monotonic() - middle)
            self.level[table] = min(LEVELS, key=seconds.get)
        return failed

    def order(self, line):
        """The tables, first those that have killed most mutants near the line."""

        def kills_nearby(table):
            return sum(1 / (50 + abs(kill - line)) for kill in self.kills[table])

        return sorted(self.tables, key=kills_nearby, reverse=True)

    def survives(self, mutant):
        """True, False, or None where the mutant does not compile."""
        with tempfile.TemporaryDirectory(dir=self.folder) as name:
            include = pathlib.Path(name)
            (include / "nagata3.h").write_text(mutant.text)
            for precision in PRECISIONS:
                for table in self.order(mutant.line):
                    level = self.level[table]
                    program = self.build(include, table, level, precision)
                    if program is None:
                        return None
                    if not self.passes(program, self.limit[table, level]):
                        self.kills[table].append(mutant.line)
                        return False
        return True


def allowed():
    """The explained mutants: lines 'function: the changed line  # reason'."""
    if not ALLOWED.exists():
        return set()
    lines = [line for line in ALLOWED.read_text().splitlines() if line.strip() and line[0] != "#"]
    return {line.partition("  # ")[0].strip() for line in lines}


def survivors(mutants, tests, count, jobs):
    """The survivors among the first count mutants that compile, and how many there were."""
    found, tried, mutants = [], 0, iter(mutants)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        while tried < count:
            batch = [m for m, _ in zip(mutants, range(count - tried))]
            if not batch:
                break
            for mutant, survived in zip(batch, pool.map(tests.survives, batch)):
                tried += survived is not None
                if survived:
                    found.append(mutant)
                    print("survived", mutant.title, flush=True)
    return found, tried


def arguments():
    parser = argparse.ArgumentParser(description="Break nagata3.h; the tests must notice.")
    parser.add_argument("sources", nargs="+", help="the tests' C files")
    parser.add_argument("--count", type=int, default=60, help="mutants to try (60)")
    parser.add_argument("--all", action="store_true", help="try every one")
    parser.add_argument("--seed", type=int, default=1, help="which ones (1)")
    parser.add_argument("--jobs", type=int, default=2, help="at the same time (2)")
    parser.add_argument("--samples", type=int, default=1000, help="N3_SAMPLES of the tests (1000)")
    parser.add_argument("--lines", default="1-", help="FIRST-LAST, only in these of nagata3.h")
    return parser.parse_args()


def main():
    options = arguments()
    text = (ROOT / "nagata3.h").read_text()
    mutants = [Mutant(text, place) for place in places(text)]
    explained = allowed()
    stale = explained - {mutant.key for mutant in mutants}
    for key in sorted(stale):
        print(f"{ALLOWED.name}: there is no such mutant: {key}")
    first, _, last = options.lines.partition("-")
    mutants = [m for m in mutants if int(first) <= m.line <= int(last or len(text))]
    if not options.all:
        mutants.sort(key=lambda m: hashlib.sha1(f"{options.seed} {m.key}".encode()).digest())
    count = len(mutants) if options.all else options.count
    with tempfile.TemporaryDirectory() as name:
        compiler = shlex.split(os.environ.get("CC", "cc"))
        tests = Tests(pathlib.Path(name), compiler, options.samples, options.sources)
        failed = tests.choose_levels(text)
        if failed:
            sys.exit(f"mutants.py: on the header as it is, these fail: {' '.join(failed)}")
        found, tried = survivors(mutants, tests, count, options.jobs)
    unexplained = [mutant for mutant in found if mutant.key not in explained]
    print(f"{tried} of {len(mutants)} mutants: {tried - len(found)} killed, {len(found)} survived, "
          f"{len(found) - len(unexplained)} of them explained")
    sys.exit(1 if unexplained or stale else 0)


if __name__ == "__main__":
    main()
