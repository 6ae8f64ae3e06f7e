"""Functions by name, cut from the sources that the book explains."""
import re

from book import ROOT


def find_function(place, name):
    """The code of a function and where it is from. `place` is a given file (engine/world/substep.cpp) or a lab
    (lab4): then the code is the reference's, or where that is absent the declaration in the lab's header.

    @return code, path of the file, whether it is the definition; None if there is no such function
    """
    if not re.fullmatch(r"lab\d+", place):
        return first_definition([ROOT / "framework" / place], name)
    solution = next(iter((ROOT / "solutions").glob(f"{place}_*")), None)
    if solution:
        return first_definition(sorted(solution.glob("*.cpp")), name)
    lab = next((ROOT / "labs").glob(f"{place}_*"))
    return declaration(ROOT / f"framework/include/cs550/{lab.name.split('_', 1)[1]}.hpp", name)


def first_definition(files, name):
    for file in files:
        if file.exists() and (code := definition(file.read_text(), name)):
            return code, file.relative_to(ROOT), True
    return None


def definition(text, name):
    """From the comment before the function to the brace at the line's start, or to the end of a one-line function."""
    start = re.compile(rf"(?:^//[^\n]*\n)*^[A-Za-z][^\n;={{}}]*?\b{re.escape(name)}\([^;{{}}]*\)[^;{{}}]*\{{", re.M)
    match = start.search(text)
    if not match:
        return None
    line_end = text.index("\n", match.end())
    if text[match.end():line_end].rstrip().endswith("}"):
        return text[match.start():line_end]
    return text[match.start():text.index("\n}\n", match.end()) + 2]


def declaration(header, name):
    match = re.search(rf"^[A-Za-z][^\n;{{}}]*?\b{re.escape(name)}\([^;]*\);", header.read_text(), re.M)
    return (match[0], header.relative_to(ROOT), False) if match else None
