#!/usr/bin/python3
"""Tests of docs/tools/make_search.py: the text that the search finds. No book needs to be built."""
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/tools"))
sys.dont_write_bytecode = True

from make_search import Sections  # noqa: E402

# As Doxygen writes it.
PAGE = """<html><body><div class="header"><div class="title">1 Title</div></div>
<div class="contents">
<div class="toc"><h3>Table of Contents</h3><ul><li class="level1"><a href="#end">The end</a></li></ul>
<div>deeper</div></div>
<div class="textblock"><p>First <img src="a.svg" alt="not text"> words.</p>
<script src="permalinks.js">code();</script>
<h1><a class="anchor" id="end"></a>
The end</h1><p>Last words.</p>
 <nav class="pages" aria-label="Previous and next page"><a rel="next" href="b.html">2 Other page</a></nav> <p>After.</p>
</div></div><!-- contents -->
<div>Footer</div></body></html>"""


class SearchTest(unittest.TestCase):
    def setUp(self):
        self.sections = [(anchor, heading.strip(), " ".join(text.split()))
                         for anchor, heading, text in Sections(PAGE, "1 Title").found]

    def test_sections_have_their_anchor_heading_and_text(self):
        self.assertEqual(self.sections, [("", "1 Title", "First words."), ("#end", "The end", "Last words. After.")])

    def test_tables_of_contents_and_links_to_other_pages_are_not_text(self):
        everything = str(self.sections)
        for word in ("Table of Contents", "deeper", "Other page", "code()", "Footer"):
            self.assertNotIn(word, everything)


if __name__ == "__main__":
    unittest.main()
