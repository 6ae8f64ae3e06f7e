#!/usr/bin/env python3
"""Turns the chapters, the handouts and the given code into pages for Doxygen.

Reads book.txt, writes one Markdown file per page, the navigation (layout.xml) and the groups of the
reference (groups.dox). Every name that a page mentions in one of the forms below must exist: a figure,
a test, a known mistake, a source file, a citation. What does not is an error.

  $x$, $$x$$                       formulas
  ![alt](figures/name.svg "caption")   a numbered figure; the caption may hold formulas. A .png is taken
                                   by the viewer, and left out where that was not built
  {fig:name}                       its number, as a link
  {api:hill_climb()}               a function or type of the contract
  {src:engine/step.cpp}            the listing of a given file
  {test:Name}                      the listing of a visible graded test, at its first line
  {mutant:name}                    a known mistake of tests/mutants
  [@Key], [@Key, §2]               a citation; {ref:Key|label} defines it in the bibliography
"""
import argparse
import json
import re
import sys
from html import escape
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
CODE_OR_TEXT = re.compile(r"(^```.*?^```[^\n]*\n?|``[^`]+``|`[^`]+`)", re.M | re.S)
FIGURE = re.compile(r"!\[([^\]]*)\]\((?:figures/)?([\w-]+)\.(svg|png)(?:\s+\"(.*?)\")?\)", re.S)
BOLD = re.compile(r"\*\*(.+?)\*\*", re.S)
MATH = re.compile(r"\$\$(.+?)\$\$|\$([^$]+?)\$", re.S)


class Page:
    """A page in reading order. `number` is that of a chapter, or the letter-number of a handout."""

    def __init__(self, name, source, part):
        self.name, self.source, self.part = name, source, part
        self.number, self.title, self.text = "", "", ""
        self.is_reference = source is None

    @property
    def html(self):
        return f"group__{self.name}.html" if self.is_reference else f"{self.name}.html"

    @property
    def label(self):
        return f"{self.number} {self.title}" if self.number.isdigit() and self.name != "index" else self.title


class Book:
    def __init__(self, output):
        self.output = output
        self.errors = []
        self.pages = read_order()
        self.figures = figure_names()
        self.tests = visible_tests()
        self.mutants = known_mistakes()
        self.sources = given_sources(self.tests)
        self.citations = {}
        self.cited = set()
        self.figure_number = {}

    def error(self, page, message):
        self.errors.append(f"{page.source}: {message}")

    def number_pages(self):
        chapter = 0
        for page in self.pages:
            if page.is_reference:
                lab = lab_of_reference(page)
                page.title = f"Lab {lab}: the contract" if lab else "The given code: the contract"
                continue
            page.text = page.source.read_text()
            page.title = re.match(r"# (.*)", page.text).group(1)
            lab = re.match(r"lab(\d+)$", page.name)
            if lab:
                page.number = f"L{lab.group(1)}"
            elif page.name != "bibliography":
                page.number = str(chapter)
                chapter += 1
            figures = [name for _, name, kind, _ in FIGURE.findall(page.text) if self.is_there(name, kind)]
            for place, name in enumerate(figures, 1):
                key = page.name if name == "figure" else name
                if key in self.figure_number:
                    self.error(page, f"figure {key} stands twice in the book")
                self.figure_number[key] = (f"{page.number}.{place}", page)
        bibliography = next(page for page in self.pages if page.name == "bibliography")
        self.citations = dict(re.findall(r"\{ref:(\w+)\|([^}]+)\}", bibliography.text))

    def write(self):
        self.number_pages()
        for page in self.pages:
            if not page.is_reference:
                self.write_page(page)
        for name, source in self.sources.items():
            self.write_listing(name, source)
        self.write_layout()
        self.write_groups()
        shown = {name for page in self.pages for _, name, _, _ in FIGURE.findall(page.text)}
        unused = set(self.figures) - shown
        if unused:
            self.errors.append("figures that no page shows: " + ", ".join(sorted(unused)))
        never = set(self.citations) - self.cited
        if never:
            self.errors.append("never cited: " + ", ".join(sorted(never)))
        return self.errors

    # ------------------------------------------------------------------------------------ pages

    def write_page(self, page):
        body = page.text.split("\n", 1)[1]
        body = self.convert(page, body)
        name = "mainpage" if page.name == "index" else page.name
        heading = f"# {page.label} {{#{name}}}\n"
        text = f"{heading}\n[TOC]\n{body}\n\n{self.navigation(page)}\n"
        (self.output / f"{page.name}.md").write_text(text)

    def convert(self, page, text):
        text = FIGURE.sub(lambda m: self.figure(page, *m.groups()), text)
        text = re.sub(r"^## (L(\d)\.(\d) .*)$", r"## \1 {#L\2_\3}", text, flags=re.M)
        text = re.sub(r"<details><summary>(.*?)</summary>",
                      lambda m: raw(f"<details><summary>{self.inline_html(page, m[1])}</summary>"),
                      text, flags=re.S)
        text = text.replace("</details>", raw("</details>"))
        text = re.sub(r"\[`?([^\]`]+)`?\]\(([^)#]+)\)", lambda m: self.link(page, *m.groups()), text)
        pieces = re.split(r"(@htmlonly.*?@endhtmlonly)", text, flags=re.S)
        return "".join(piece if piece.startswith("@htmlonly") else self.convert_prose(page, piece) for piece in pieces)

    def convert_prose(self, page, text):
        # Doxygen knows no formula between asterisks, and leaves a gap before one in parentheses.
        text = BOLD.sub(lambda m: f"<b>{m[1]}</b>" if "$" in m[1] else m[0], text)
        text = re.sub(r"\(\$([^$()]+)\$\)", r"$(\1)$", text)
        pieces = CODE_OR_TEXT.split(text)
        return "".join(self.code(piece) if i % 2 else self.roles(page, MATH.sub(doxygen_math, piece), markdown_link)
                       for i, piece in enumerate(pieces))

    def code(self, piece):
        """A visible test or a contract header in code font is a link, in handouts too."""
        name = piece.strip("`")
        if piece.startswith("`") and name in self.tests:
            return markdown_link(name, self.test_address(name))
        return piece

    def roles(self, page, text, link):
        def role(match):
            kind, value = match.groups()
            try:
                return getattr(self, "role_" + kind)(value, link)
            except KeyError:
                self.error(page, f"{{{kind}:{value}}} names nothing that exists")
                return value

        def citation(match):
            key, place = match.groups()
            if key not in self.citations:
                self.error(page, f"[@{key}] is not in the bibliography")
                return key
            self.cited.add(key)
            return link(f"[{self.citations[key]}{place or ''}]", f"bibliography.html#{key}")

        text = re.sub(r"\{(fig|api|src|test|mutant|ref):([^}]+)\}", role, text)
        return re.sub(r"\[@(\w+)(,[^\]]*)?\]", citation, text)

    def role_fig(self, name, link):
        number, page = self.figure_number[name]
        return link(f"Figure {number}", f"{page.html}#fig_{name}")

    def role_api(self, name, link):
        if link is html_link:
            return f"<code>{escape(name)}</code>"
        return f'@ref cs550::{name.rstrip("()")} "{name}"'

    def role_src(self, name, link):
        self.sources[name]  # must exist
        return link(name, f"{listing_name(name)}.html")

    def role_test(self, name, link):
        return link(name, self.test_address(name))

    def role_mutant(self, name, _):
        if self.mutants and name not in self.mutants:
            raise KeyError(name)
        return f"<code>{name}</code>"

    def role_ref(self, value, _):
        key, label = value.split("|")
        return f'@anchor {key} <b>[{label}]</b>'

    def test_address(self, name):
        source, line = self.tests[name]
        return f"{listing_name(source)}.html#l{line:05}"

    def is_there(self, name, kind):
        """Pictures of the viewer may be missing; all others were made, or the build has ended."""
        return kind == "svg" or (self.output.parent / "figures" / f"{name}.png").exists()

    def figure(self, page, alt, name, kind, caption):
        if not self.is_there(name, kind):
            return "*A picture of the viewer belongs here; the viewer was not built with this book.*"
        key = page.name if name == "figure" else name
        if name != "figure" and name not in self.figures:
            self.error(page, f"figure {name} is not in figures.txt")
        number, _ = self.figure_number[key]
        text = self.inline_html(page, caption or alt + ".")
        return raw(f'<figure id="fig_{key}"><img src="figures/{key}.{kind}" alt="{escape(" ".join(alt.split()))}"/>'
                   f"<figcaption><b>Figure {number}.</b> {text}</figcaption></figure>")

    def inline_html(self, page, text):
        """Formulas, code, emphasis and the roles, as HTML."""
        text = escape(text, quote=False)
        text = MATH.sub(lambda m: rf"\({m.group(1) or m.group(2)}\)", text)
        text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
        text = re.sub(r"\*([^*]+)\*", r"<em>\1</em>", text)
        return self.roles(page, text, html_link)

    def link(self, page, text, target):
        """Links of handouts are paths in the repository: to headers of the contract, or to files there."""
        if re.match(r"https?:", target):
            return f"[{text}]({target})"
        name = Path(target).name
        if target.endswith(".hpp"):
            return f'@ref {name} "{name}"'
        if target.endswith(".cpp"):
            return f"`{name}`"
        if target.endswith(".md") or target.endswith(".html"):
            return f"[{text}]({Path(target).stem}.html)"
        self.error(page, f"a link to {target} leads out of the book")
        return text

    def navigation(self, page):
        place = self.pages.index(page)
        links = []
        if place > 0:
            before = self.pages[place - 1]
            links.append(f'<a rel="prev" href="{before.html}">← {escape(before.label)}</a>')
        if place + 1 < len(self.pages):
            after = self.pages[place + 1]
            links.append(f'<a rel="next" href="{after.html}">{escape(after.label)} →</a>')
        return raw(f'<nav class="pages" aria-label="Previous and next page">{"".join(links)}</nav>')

    # ------------------------------------------------------------------- what surrounds the pages

    def write_listing(self, name, source):
        # Doxygen finds an included file by the end of its path.
        text = f"# {name} {{#{listing_name(name)}}}\n\n@include{{lineno}} {source.relative_to(ROOT)}\n"
        (self.output / f"{listing_name(name)}.md").write_text(text)

    def write_layout(self):
        lines = ['<doxygenlayout version="1.0">', "<navindex>"]
        part = None
        for page in self.pages:
            if page.part != part:
                if part:
                    lines.append("</tab>")
                part = page.part
                if part:
                    lines.append(f'<tab type="usergroup" visible="yes" title="{escape(part)}">')
            if page.name != "index":
                lines.append(f'<tab type="user" visible="yes" url="@ref {page.name}" title="{escape(page.label)}"/>')
        if part:
            lines.append("</tab>")
        lines += ["</navindex>", "</doxygenlayout>"]
        (self.output / "layout.xml").write_text("\n".join(lines) + "\n")

    def write_groups(self):
        text = ["/** @namespace cs550\n * Everything of the project. */"]
        for page in self.pages:
            if page.is_reference:
                text.append(f"/** @defgroup {page.name} {page.title}\n * {about(page)}\n *\n"
                            f" * {self.navigation(page)} */")
        (self.output / "groups.dox").write_text("\n".join(text) + "\n")


# ------------------------------------------------------------------------------------ what there is


def read_order():
    pages, part = [], ""
    for line in (DOCS / "book.txt").read_text().splitlines():
        if line.startswith("#") or not line.strip():
            continue
        if line.startswith("Part:"):
            part = line.removeprefix("Part:").strip()
            continue
        name, _, source = line.partition(" ")
        pages.append(Page(name, DOCS / source.strip() if source.strip() else None, part))
    return pages


def lab_of_reference(page):
    return re.sub(r"\D", "", page.name)


def about(page):
    """The first line of a reference page; a sentence, since Doxygen makes its summary of it."""
    lab = lab_of_reference(page)
    if lab:
        return f"What lab {lab} defines, and the values that it takes and returns."
    return "What the labs are given: bodies, shapes, contacts, the world, scenes."


def figure_names():
    lines = (DOCS / "figures" / "figures.txt").read_text().splitlines()
    return [line.split()[0] for line in lines if line.strip() and not line.startswith("#")]


def visible_tests():
    """Name → (file without tests/, line) of every graded test that students see."""
    tests = {}
    for file in sorted((ROOT / "tests").glob("lab*/*.cpp")):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            match = re.match(r"GRADED_TEST\(Lab\d+, (\w+),", line)
            if match:
                tests[match.group(1)] = ("tests/" + str(file.relative_to(ROOT / "tests")), number)
    return tests


def known_mistakes():
    names = set()
    for file in (ROOT / "tests" / "mutants").glob("lab*.json"):
        names |= {mutant["name"] for mutant in json.loads(file.read_text())["mutants"]}
    return names


def given_sources(tests):
    """Listings: the engine, and the files of the visible graded tests. Never a solution."""
    engine = {f"engine/{file.name}": file for file in sorted((ROOT / "framework" / "engine").glob("*.?pp"))}
    tested = {file: ROOT / file for file, _ in sorted(set(tests.values()))}
    return engine | tested


def listing_name(name):
    return "src_" + re.sub(r"\W", "_", name)


# ------------------------------------------------------------------------------------------ forms


def raw(html):
    return f"@htmlonly {html} @endhtmlonly"


def doxygen_math(match):
    display, inline = match.groups()
    return rf"\f[{display}\f]" if display else rf"\f${inline}\f$"


def markdown_link(text, address):
    return f'<a href="{address}">{escape(text)}</a>'


def html_link(text, address):
    """For text that is HTML already."""
    return f'<a href="{address}">{text}</a>'


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output", type=Path, help="folder for the pages")
    output = parser.parse_args().output
    output.mkdir(parents=True, exist_ok=True)
    for old in output.iterdir():
        old.unlink()
    errors = Book(output).write()
    for error in errors:
        print(error, file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
