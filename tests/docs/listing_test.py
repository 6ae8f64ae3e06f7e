#!/usr/bin/python3
"""Tests of docs/tools/listing.py: functions that the book cuts from the sources."""
import re
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/tools"))
sys.dont_write_bytecode = True

import listing  # noqa: E402
from book import Page  # noqa: E402
from markup import Markup  # noqa: E402

SOURCE = """int helper(int a);

/// Adds.
int helper(int a) {
  if (a > 0) {
    return a;
  }
  return helper(-a);
}

int one() { return 1; }
"""


class Errors:
    """Stands in for a book."""

    def __init__(self):
        self.errors, self.settings, self.numbers = [], [], {}

    def error(self, page, message, line=None):
        self.errors.append(f"{page.source.name}:{line}: {message}")


class ListingTest(unittest.TestCase):
    def test_a_definition_has_its_comment_and_ends_at_its_brace(self):
        code = listing.definition(SOURCE, "helper")
        self.assertTrue(code.startswith("/// Adds.\nint helper(int a) {"))
        self.assertTrue(code.endswith("return helper(-a);\n}"))

    def test_a_function_may_be_one_line(self):
        self.assertEqual(listing.definition(SOURCE, "one"), "int one() { return 1; }")

    def test_given_code_is_named_by_its_file(self):
        code, file, is_definition = listing.find_function("engine/contacts/softness.cpp", "soft_contact")
        self.assertIn("omega / a1", code)
        self.assertEqual((str(file), is_definition), ("framework/engine/contacts/softness.cpp", True))

    def test_links_to_chapters_become_links_to_pages(self):
        text = Markup(Errors(), Page("chapter", ROOT / "docs/chapters/index.md", "")).convert(
            "[one](rigid_body.md), [its end](rigid_body.md#end), [live](world.html?live=x#fig_x)")
        self.assertEqual(text, "[one](rigid_body.html), [its end](rigid_body.html#end), [live](world.html?live=x#fig_x)")

    def test_chapters_link_to_each_other_as_files(self):
        for chapter in (ROOT / "docs/chapters").glob("*.md"):
            text = chapter.read_text()
            self.assertNotRegex(text, r"\]\([\w-]+\.html[#)]", chapter.name)
            for target in re.findall(r"\]\(([\w-]+\.md)", text):
                # A students' copy lacks the answers.
                self.assertTrue((chapter.parent / target).exists() or target == "answers.md", f"{chapter.name}: {target}")

    def test_without_the_reference_the_declaration_is_shown(self):
        root = listing.ROOT
        with tempfile.TemporaryDirectory() as copy:
            for folder in ("labs", "framework"):
                (Path(copy) / folder).symlink_to(root / folder)
            listing.ROOT = Path(copy)
            try:
                code, _, is_definition = listing.find_function("lab5", "clip_polygon")
            finally:
                listing.ROOT = root
        self.assertFalse(is_definition)
        self.assertTrue(code.startswith("ClipPolygon clip_polygon(") and code.endswith(");"))

    def test_a_name_that_does_not_exist_is_an_error_with_file_and_line(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Page("chapter", Path(folder) / "chapter.md", "")
            page.source.write_text("# Title\n\n{code:lab4 no_such_function}\n")
            book = Errors()
            Markup(book, page).convert(page.source.read_text())
        self.assertEqual(book.errors, ["chapter.md:3: {code:lab4 no_such_function} names no function that exists"])


if __name__ == "__main__":
    unittest.main()
