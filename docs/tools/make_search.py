#!/usr/bin/env python3
"""Writes search_text.js: the text of every chapter and handout, by section, for the page that searches it."""
import argparse
import json
import re
from html.parser import HTMLParser
from pathlib import Path

from book import Book

FORMULA = re.compile(r"\\\(.*?\\\)|\\\[.*?\\\]", re.S)
VOID = {"img", "br", "input", "hr", "link", "meta", "area", "source", "wbr", "col"}
SKIPPED = {("div", "toc"), ("nav", "pages")}


class Sections(HTMLParser):
    """The sections of a page: [anchor, heading, text]."""

    def __init__(self, html, title):
        super().__init__()
        self.found = [["", title, ""]]
        self.depth = 0  # inside of the contents; 0 outside
        self.skipped = 0  # depth of the table of contents or the links to other pages; 0 outside
        self.heading = False
        self.feed(html)

    @property
    def is_text(self):
        return self.depth and not self.skipped

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag == "div" and values.get("class") == "contents":
            self.depth = 1
        elif self.depth and tag not in VOID:
            self.depth += 1
        if self.depth and not self.skipped and (tag, values.get("class")) in SKIPPED:
            self.skipped = self.depth
        if self.is_text and tag in ("h1", "h2", "h3"):
            self.found.append(["", "", ""])
            self.heading = True
        if self.heading and tag == "a" and values.get("id"):
            self.found[-1][0] = "#" + values["id"]

    def handle_endtag(self, tag):
        if self.depth and tag not in VOID:
            self.depth -= 1
        if self.depth < self.skipped:
            self.skipped = 0
        if tag in ("h1", "h2", "h3"):
            self.heading = False

    def handle_data(self, data):
        if self.is_text and self.lasttag not in ("script", "style"):
            self.found[-1][1 if self.heading else 2] += data


def readable(formula):
    """A formula in TeX without its delimiters, spaces, braces and backslashes."""
    return re.sub(r"\\[,;! ]|[{}\\]", "", formula[2:-2])


def passages(book, folder):
    for page in book.pages:
        if page.is_reference or page.name == "search":
            continue
        for anchor, heading, text in Sections((folder / page.html).read_text(), page.label).found:
            text = re.sub(r"\s+", " ", FORMULA.sub(lambda formula: readable(formula[0]), text)).strip()
            name = page.label if not anchor else f"{page.label}: {heading.strip()}"
            if text:
                yield {"address": page.html + anchor, "heading": name, "text": text}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("docs", type=Path, help="folder with html/ and figures/")
    docs = parser.parse_args().docs
    text = json.dumps(list(passages(Book(docs / "figures"), docs / "html")), ensure_ascii=False)
    (docs / "html" / "search_text.js").write_text(f"const bookText = {text};\n")


if __name__ == "__main__":
    main()
