#!/usr/bin/env python3
"""structure_leaks.py SOLUTIONS GIVEN CONTRACT...: given code must not repeat the structure of a reference.

Renaming variables does not hide a copied algorithm. Both sides become tokens: names of the contract stay,
other names become I, numbers N, strings S, and punctuation without meaning is dropped. A run of 5 tokens
that holds two functions or members of the contract is a clue. A leak is a window of 120 tokens of given
code in which clues of one lab's reference cover at least 40.

SOLUTIONS is the folder of the references, GIVEN a folder of given code, each CONTRACT a folder of code
that everyone may see (headers and starters): its clues count as public.
"""
import collections
import pathlib
import re
import sys

RUN = 5
WINDOW = 120
MOST = 39

# Reviewed and found harmless.
INNOCENT = {
    "framework/engine/world/substep.cpp": "calls the labs' functions on its constraints",
    "framework/engine/contacts/cold_start.cpp": "states the formula of v_n, which the handout gives",
    "framework/engine/body_sweeps.cpp": "is what the fast form of lab 1 replaces, and calls lab 1 itself",
    "framework/engine/contacts/contact_passes.cpp": "is what the fast form of lab 7 replaces, and calls lab 7 itself",
    "framework/engine/world/rigid_body.cpp": "turns velocities into momenta, as the fast sweeps do",
    "framework/engine/world/momentum_audit.cpp": "adds up impulses along n, u and v, as the header of L7.5 states",
    "framework/serialisation/contract_archive.hpp": "lists the members of every type",
    "framework/serialisation/byte_archive.hpp": "reads and writes one type after the other",
    "docs/live/world_canvas.cpp": "collects the corners of the faces towards the camera",
    "docs/figures/collision_tables.cpp": "samples separations along arcs",
    "docs/figures/mass_figures.cpp": "picks the face towards the reader",
}

TOKEN = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|[A-Za-z_]\w*|\.?\d[\w.]*|->|[-+*/!=<>]=|&&|\|\||\+\+|--|[^\s\w]')
COMMENT = re.compile(r"//[^\n]*|^\s*#[^\n]*", re.MULTILINE)
WORD = re.compile(r"[A-Za-z_]\w*")
KEYWORDS = set("if else for while do return struct continue true false constexpr using namespace void int bool "
               "float double const auto static_cast std size_t switch case break static inline".split())
DROPPED = {"const", "auto", "static_cast", "std", "size_t", "switch", "case", "break"} | set("(){};&:<>")
# Names too common to be evidence, although headers use them.
COMMON = KEYWORDS | {"cs550", "include", "size", "vector", "begin", "end", "push_back"}


def code_files(folder):
    return sorted(f for f in pathlib.Path(folder).rglob("*") if f.suffix in (".cpp", ".hpp"))


def contract_names(files):
    """Functions and members that headers declare; single letters are local names."""
    names = {"cross", "dot", "norm", "normalized"}
    for file in files:
        names |= set(WORD.findall(COMMENT.sub("", file.read_text(encoding="utf-8"))))
    return {n for n in names if len(n) > 1 and n[0].islower()} - COMMON


def tokens(file, names):
    """Pairs of a normalised token and its line."""
    result = []
    blanked = COMMENT.sub("", file.read_text(encoding="utf-8"))
    for number, line in enumerate(blanked.split("\n"), 1):
        for token in TOKEN.findall(line):
            if token in DROPPED:
                continue
            if token[0] in "\"'":
                token = "S"
            elif token[0].isdigit() or (token[0] == "." and len(token) > 1):
                token = "N"
            elif WORD.fullmatch(token) and token not in names and token not in KEYWORDS:
                token = "I"
            result.append((token, number))
    return result


def clues(stream, names):
    """Places and runs of tokens that name at least two functions or members of the contract."""
    for i in range(len(stream) - RUN + 1):
        run = tuple(token for token, _ in stream[i:i + RUN])
        if sum(token in names for token in run) >= 2:
            yield i, run


def worst_window(stream, covered):
    """How many tokens of the fullest window are covered, and its first and last line."""
    best, start, count = 0, 0, 0
    for i, is_covered in enumerate(covered):
        count += is_covered - (covered[i - WINDOW] if i >= WINDOW else 0)
        if count > best:
            best, start = count, max(0, i - WINDOW + 1)
    return best, stream[start][1], stream[min(start + WINDOW, len(stream)) - 1][1]


def main(solutions, given, *contract):
    public_files = [file for folder in contract for file in code_files(folder)]
    headers = [file for file in public_files if file.suffix == ".hpp"]
    names = contract_names(headers)
    public = {run for file in public_files for _, run in clues(tokens(file, names), names)}

    labs = collections.defaultdict(set)
    for file in code_files(solutions):
        for _, run in clues(tokens(file, names), names):
            if run not in public:
                labs[run].add(file.relative_to(solutions).parts[0])
    if len(labs) < 500:
        sys.exit(f"{solutions} has only {len(labs)} clues: there is nothing to look for")

    root = pathlib.Path(given)
    leaks = []
    for file in code_files(root / "framework") + code_files(root / "docs"):
        place = str(file.relative_to(root))
        if place in INNOCENT or file in public_files:
            continue
        stream = tokens(file, names)
        covered = {}
        for i, run in clues(stream, names):
            for lab in labs.get(run, ()):
                covered.setdefault(lab, [0] * len(stream))[i:i + RUN] = [1] * RUN
        for lab, marks in covered.items():
            count, first, last = worst_window(stream, marks)
            if count > MOST:
                leaks.append(f"{place}:{first}-{last} repeats {count} tokens of the reference of {lab}")
    for leak in leaks:
        print(leak)
    if leaks:
        sys.exit("Call the student's functions instead; if the code is harmless, add it to INNOCENT in " + __file__)


if __name__ == "__main__":
    main(*sys.argv[1:])
