#!/usr/bin/env python3
"""Puts the chapters and handouts of the built book behind each other: one page, to be printed as PDF."""
import re
import sys
from pathlib import Path

from book import read_order

HEAD = """<!DOCTYPE html><html lang="en-GB"><head><meta charset="utf-8"><title>CS550</title>
<link rel="stylesheet" href="doxygen.css"><link rel="stylesheet" href="book.css">
<script type="text/x-mathjax-config">MathJax.Hub.Config({extensions:["tex2jax.js","TeX/AMSmath.js",
"TeX/AMSsymbols.js"],jax:["input/TeX","output/SVG"]});</script>
<script src="mathjax/MathJax.js"></script></head><body class="print">
<h1 class="cover">CS550<br><small>A rigid-body physics engine in seven labs</small></h1>
"""


def contents_of(html):
    title = re.search(r'<div class="title">(.*?)</div>', html, re.S).group(1)
    body = re.search(r'<div class="contents">(.*)</div><!-- contents -->', html, re.S).group(1)
    body = re.sub(r'<div class="toc">.*?</div>', "", body, flags=re.S)
    body = re.sub(r"<nav class=\"pages\".*?</nav>", "", body, flags=re.S)
    body = re.sub(r"<script src=.*?</script>", "", body)  # figures stay as they are
    body = re.sub(r'href="[\w-]+\.html\?[^"]*"', "", body)  # to a state of a live figure
    body = re.sub(r"<details>.*?</details>", "", body, flags=re.S)  # hints give answers away
    return title, body


def main():
    html = Path(sys.argv[1]) / "html"
    chapters = [page for page in read_order() if page.source and page.name != "search"]
    names = {page.html for page in chapters}
    parts, entries = [], []
    for page in chapters:
        title, body = contents_of((html / page.html).read_text())
        # Links to pages that are printed lead inside, the others are text.
        body = re.sub(r'href="([\w-]+\.html)#([\w-]+)"', lambda m: f'href="#{m[2]}"' if m[1] in names else "", body)
        body = re.sub(r'href="([\w-]+)\.html"', lambda m: f'href="#page_{m[1]}"' if m[1] + ".html" in names else "", body)
        parts.append(f'<section class="page" id="page_{page.name}"><h1 class="title">{title}</h1>{body}</section>')
        entries.append(f'<li><a href="#page_{page.name}">{title}</a></li>')
    toc = f'<ul class="printed-contents">{"".join(entries)}</ul>'
    (html / "print.html").write_text(HEAD + toc + "".join(parts) + "</body></html>")


main()
