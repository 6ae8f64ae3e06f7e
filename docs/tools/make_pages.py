#!/usr/bin/env python3
"""Turns the chapters, the handouts and the given code into pages for Doxygen.

Reads book.txt, writes one Markdown file per page, the navigation (layout.xml) and the groups of the reference
(groups.dox). The forms that a page may use stand in markup.py.
"""
import argparse
import sys
from html import escape
from pathlib import Path

from book import FIGURE, ROOT, Book, listing_name
from markup import Markup, raw


def write_page(book, page, output):
    """Returns the keys that the page cites."""
    markup = Markup(book, page)
    body = markup.convert(page.text.split("\n", 1)[1])
    name = "mainpage" if page.name == "index" else page.name
    heading = f"# {page.label} {{#{name}}}\n"
    if "<figure id=" in body and " data-live=" in body:
        body += raw('<script src="live.js" defer></script>')
    if page.name == "search":
        body += raw('<script src="search_text.js" defer></script><script src="text_search.js" defer></script>')
    body += raw('<script src="permalinks.js" defer></script>')
    text = f"{heading}\n[TOC]\n{body}\n\n{navigation(book, page)}\n"
    (output / f"{page.name}.md").write_text(text)
    return markup.cited


def navigation(book, page):
    place = book.pages.index(page)
    links = []
    if place > 0:
        before = book.pages[place - 1]
        links.append(f'<a rel="prev" href="{before.html}">← {escape(before.label)}</a>')
    if place + 1 < len(book.pages):
        after = book.pages[place + 1]
        links.append(f'<a rel="next" href="{after.html}">{escape(after.label)} →</a>')
    return raw(f'<nav class="pages" aria-label="Previous and next page">{"".join(links)}</nav>')


def write_listing(name, source, output):
    # Doxygen finds an included file by the end of its path.
    text = f"# {name} {{#{listing_name(name)}}}\n\n@include{{lineno}} {source.relative_to(ROOT)}\n"
    (output / f"{listing_name(name)}.md").write_text(text)


def write_layout(book, output):
    lines = ['<doxygenlayout version="1.0">', "<navindex>"]
    part = None
    for page in book.pages:
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
    (output / "layout.xml").write_text("\n".join(lines) + "\n")


def write_groups(book, output):
    text = ["/** @namespace cs550\n * Everything of the project. */"]
    for page in book.pages:
        if page.is_reference:
            text.append(f"/** @defgroup {page.name} {page.title}\n * {about(page)}\n *\n"
                        f" * {navigation(book, page)} */")
    (output / "groups.dox").write_text("\n".join(text) + "\n")


def about(page):
    """The first line of a reference page; a sentence, since Doxygen makes its summary of it."""
    if page.lab:
        return f"What lab {page.lab} defines, and the values that it takes and returns."
    return "What the labs are given: bodies, shapes, contacts, the world, scenes."


def find_unused(book, cited):
    shown = {name for page in book.pages for _, name, _, _ in FIGURE.findall(page.text)}
    unused = set(book.figures) - shown
    if unused:
        book.errors.append("figures that no page shows: " + ", ".join(sorted(unused)))
    never = set(book.citations) - cited
    if never:
        book.errors.append("never cited: " + ", ".join(sorted(never)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output", type=Path, help="folder for the pages; the figures are beside it")
    output = parser.parse_args().output
    output.mkdir(parents=True, exist_ok=True)
    for old in output.iterdir():
        old.unlink()

    book = Book(output.parent / "figures")
    cited = set()
    for page in book.pages:
        if not page.is_reference:
            cited |= write_page(book, page, output)
    for name, source in book.sources.items():
        write_listing(name, source, output)
    write_layout(book, output)
    write_groups(book, output)
    find_unused(book, cited)
    for error in book.errors:
        print(error, file=sys.stderr)
    return 1 if book.errors else 0


if __name__ == "__main__":
    sys.exit(main())
