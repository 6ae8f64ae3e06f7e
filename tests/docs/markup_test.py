#!/usr/bin/python3
"""Tests of docs/tools/markup.py: the forms of a page, and what is refused. No book needs to be built."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/tools"))
sys.dont_write_bytecode = True

from book import Book, Page  # noqa: E402
from markup import Markup  # noqa: E402


class BookWithoutPictures(Book):
    """The book as if all pictures were drawn."""

    def __init__(self):
        super().__init__(ROOT / "no_such_folder" / "figures")

    def is_there(self, name, kind):
        return True

    def figure_width(self, key, kind):
        return 640


class MarkupTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.book = BookWithoutPictures()

    def convert(self, text):
        """The text as Doxygen takes it, and its errors without the folder of the page."""
        self.book.errors = []
        with tempfile.TemporaryDirectory() as folder:
            page = Page("chapter", Path(folder) / "chapter.md", "")
            page.source.write_text(text)
            converted = Markup(self.book, page).convert(text)
        return converted, [error.removeprefix(f"{folder}/") for error in self.book.errors]

    def test_pages_of_the_book_have_no_errors(self):
        book = BookWithoutPictures()
        for page in book.pages:
            if not page.is_reference:
                Markup(book, page).convert(page.text.split("\n", 1)[1])
        self.assertEqual(book.errors, [])

    def test_a_misspelt_form_is_an_error_with_file_line_and_the_known_forms(self):
        for form in ("{tests:Foo}", "{figure:pipeline}", "{Default:substeps}", "{defaults:substeps}", "{apis:Real}",
                     "{Measured:date}", "{code: lab4 overlap}", "{code lab4 overlap}"):
            _, errors = self.convert(f"# Title\n\nFirst.\nThen {form} follows.\n")
            self.assertEqual(len(errors), 1, form)
            self.assertTrue(errors[0].startswith(f"chapter.md:4: {form} "), errors[0])
            self.assertIn("measured", errors[0])

    def test_a_listing_inside_of_a_sentence_is_an_error(self):
        _, errors = self.convert("See {code:lab4 overlap} there.\n")
        self.assertEqual(len(errors), 1)
        self.assertIn("a paragraph of its own", errors[0])

    def test_a_misspelt_form_in_a_caption_or_summary_is_an_error(self):
        for text in ('![A box](figures/pipeline.svg "See {tests:a & b}")\n',
                     "<details><summary>See {tests:a & b}</summary>Text.</details>\n"):
            _, errors = self.convert(text)
            self.assertEqual(len(errors), 1, text)
            self.assertTrue(errors[0].startswith("chapter.md:1: {tests:a & b} "), errors[0])

    def test_code_and_formulas_may_look_like_forms(self):
        text = ("`{tests:Foo}` and ``{tests:`Foo`}``, $\\text{if {a b}}$, $$\\max_{edges of a}$$\n\n"
                "```cpp\nint a{int: 1};\n```\n\n"
                '![A box](figures/pipeline.svg "Code `{a: 1}` and $\\text{if so}$")\n'
                "<details><summary>`{a: 1}`, $x_{a b}$</summary>Text.</details>\n")
        self.assertEqual(self.convert(text)[1], [])

    def test_a_quote_does_not_end_code(self):
        self.assertEqual(self.convert("Type `ctest -R '^a'`, ``b 'c' d`` or `e`.\n"),
                         ("Type ``ctest -R '^a'``, ``b 'c' d`` or `e`.\n", []))

    def test_a_caption_names_functions_and_types_that_exist(self):
        for name in ("hill_climb()", "Pose", "Real"):
            converted, errors = self.convert(f"<details><summary>Call {{api:{name}}}</summary>Text.</details>\n")
            self.assertEqual(errors, [])
            self.assertIn(f"<code>{name}</code>", converted)
        for text in ("<details><summary>\nCall {api:no_such_function()}</summary>Text.</details>\n",
                     '![A\nbox](figures/pipeline.svg "Call {api:no_such_function()}")\n'):
            self.assertEqual(self.convert(text)[1],
                             ["chapter.md:2: {api:no_such_function()} names nothing that exists"])


if __name__ == "__main__":
    unittest.main()
