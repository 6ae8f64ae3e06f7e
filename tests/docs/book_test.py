#!/usr/bin/python3
"""Opens every page of the book from disk in headless browsers, at the width of a phone.

A page passes when the browser logs no error and no failed request, all formulas are rendered, nothing is
left as TeX or Markdown, all images are there and described, nothing is wider than the screen, no formula scrolls, nor
does any formula or listing at 1,280 pixels, and all links lead to something. Sections and figures have links to themselves,
and formulas have MathML. The search must find a word. Exit code 77: the book is not built.

    tests/docs/book_test.py build/docs/html [--code]

Without --code pages that hold nothing but code or names are left out, apart from their links; with it only they are opened.
"""
import re
import sys
import time
from functools import partial
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

from selenium.webdriver.common.by import By

from browsers import DESK, PHONE, errors_logged, in_browsers, show_on


class Links(HTMLParser):
    """The targets and the anchors of a page."""

    def __init__(self, text):
        super().__init__()
        self.targets, self.anchors = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for name in ("id", "name"):
            if values.get(name):
                self.anchors.add(values[name])
        target = values.get("href") if tag in ("a", "area", "link") else values.get("src")
        if target and not re.match(r"(https?|javascript|mailto|data):", target):
            self.targets.add(target)


def broken_links(folder):
    pages = {page.name: Links(page.read_text(errors="replace")) for page in sorted(folder.glob("*.html"))}
    for name, page in pages.items():
        for target in sorted(page.targets):
            file, _, anchor = unquote(target).partition("#")
            file = file.partition("?")[0] or name
            if not (folder / file).exists():
                yield f"{name}: links to {target}, which does not exist"
            elif anchor and file in pages and anchor not in pages[file].anchors:
                yield f"{name}: {target} has no such anchor"


# Calls back when MathJax is finished, and when images that scripts added after the page's load event are there or failed.
SETTLE = """
const done = arguments[0];
const ended = image => image.complete || new Promise(resolve => { image.onload = image.onerror = resolve; });
const images = () => Promise.all([...document.images].map(ended)).then(() => done(true));
if (window.MathJax && MathJax.Hub) MathJax.Hub.Queue(images); else images();
"""

# Breaks the formulas into lines again, for a screen of another width.
REFLOW = "if (window.MathJax && MathJax.Hub) MathJax.Hub.Queue(['Rerender', MathJax.Hub]);"

# What must fit, and scrolls.
SCROLLING = r"""
const FORMULAS = '.MathJax_SVG_Display, p.formulaDsp';
const scrolling = selector => [...document.querySelectorAll(`.contents :is(${selector})`)]
  .filter(part => part.scrollWidth > part.clientWidth + 1)
  .map(part => `scrolls: ${part.scrollWidth} of ${part.clientWidth} pixels, ${part.textContent.trim().slice(0, 80)}`);
"""

# The errors of the current page, as on a phone.
LOOK = SCROLLING + r"""
const faults = [];
const walker = document.createTreeWalker(document.querySelector('.contents') || document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const parent = walker.currentNode.parentElement;
  if (parent.closest('script, style, .fragment, code, .MathJax_Preview')) continue;
  const tex = walker.currentNode.data.match(/\\\(|\\\[|\\[a-z]+\{|\$[^$\s][^$]*\$/);
  if (/\*\*|(^|[\s"(])\*[A-Za-z]+\*($|[\s").,:;])/.test(walker.currentNode.data)) faults.push('raw Markdown: ' + walker.currentNode.data.trim().slice(0, 80));
  if (tex) faults.push('raw TeX: ' + walker.currentNode.data.trim().slice(0, 80));
}
// MathJax draws invalid formulas as red text.
for (const error of document.querySelectorAll('.MathJax_Error, .MathJax_SVG [fill="rgb(204, 0, 0)"]')) {
  faults.push('formula: ' + error.textContent);
}
for (const image of document.images) {
  if (!image.complete || image.naturalWidth === 0) faults.push('image does not load: ' + image.getAttribute('src'));
  if (image.closest('figure') && (image.alt || '').length < 20) faults.push('figure without a description: ' + image.getAttribute('src'));
}
const scroller = document.getElementById('doc-content');
for (const part of [document.documentElement, scroller]) {
  if (part && part.scrollWidth > part.clientWidth + 1) {
    const wide = [...document.querySelectorAll('.contents *')].find(e => e.getBoundingClientRect().right > innerWidth + 1
                                                                     && !e.closest('svg, table, .fragment, .formulaDsp, .MathJax_SVG_Display'));
    faults.push('wider than the screen: ' + part.scrollWidth + ' of ' + part.clientWidth + ' pixels'
                + (wide ? ', ' + wide.outerHTML.slice(0, 100) : ''));
  }
}
// Pages of the book, not Doxygen's own: links for citing, and MathML for screen readers.
if (document.querySelector('nav.pages')) {
  const links = new Set([...document.querySelectorAll('.permalink')].map(link => link.getAttribute('href')));
  for (const place of document.querySelectorAll('.contents :is(h1, h2, h3) > a.anchor, .contents figure[id]')) {
    if (!links.has('#' + place.id)) faults.push('no permalink to ' + place.id);
  }
  const silent = [...document.querySelectorAll('.MathJax_SVG')].filter(formula => !formula.querySelector('math'));
  if (silent.length > 0) faults.push(`formulas without MathML: ${silent.length}, the first is ${silent[0].id}`);
}
return faults.concat(scrolling(FORMULAS));
"""


def look_at(page, browser):
    browser.get(page.as_uri())
    browser.execute_async_script(SETTLE)
    faults = browser.execute_script(LOOK)
    show_on(browser, DESK)
    browser.execute_script(REFLOW)
    browser.execute_async_script(SETTLE)
    faults += browser.execute_script(SCROLLING + "return scrolling('div.fragment, ' + FORMULAS);")
    faults += errors_logged(browser)
    show_on(browser, PHONE)
    return [f"{page.name}: {fault}" for fault in faults]


def search_works(folder, browser):
    """The search by names finds a function."""
    browser.get((folder / "index.html").as_uri())
    field = browser.find_element(By.ID, "MSearchField")
    field.click()
    field.send_keys("hill_climb")
    deadline = time.monotonic() + 10
    while time.monotonic() < deadline:
        frames = browser.find_elements(By.CSS_SELECTOR, "#MSearchResultsWindow iframe")
        if frames and frames[0].is_displayed():
            browser.switch_to.frame(frames[0])
            text = browser.execute_script("return document.body ? document.body.innerText : ''")
            browser.switch_to.default_content()
        else:
            text = browser.execute_script("return document.getElementById('MSearchResultsWindow').innerText")
        if "hill_climb" in text:
            return []
        time.sleep(0.1)
    return ["index.html: the search does not find hill_climb"]


def text_search_works(folder, browser):
    """A word that is no name leads to a section of a chapter, and formulas around it are shown without TeX."""
    browser.get((folder / "search.html").as_uri() + "?q=polhode")
    passages = browser.find_elements(By.CSS_SELECTOR, "#text_search li")
    links = [passage.find_element(By.TAG_NAME, "a").get_attribute("href") for passage in passages]
    if any("rigid_body.html#" in link for link in links) and not any("\\(" in each.text for each in passages):
        return []
    return ["search.html: the text search does not find polhode"]


def is_code(page):
    """Made by Doxygen of code and names alone: no text, formula or figure that somebody wrote."""
    return page.name.startswith(("src_", "dir_")) or page.name.endswith(("_source.html", "-members.html"))


def main():
    folder, code = Path(sys.argv[1]).resolve(), "--code" in sys.argv
    if not (folder / "index.html").exists():
        print("the book is not built: ./cs550 docs")
        return 77
    pages = sorted(filter(lambda page: is_code(page) == code, folder.glob("*.html")),
                   key=lambda page: page.stat().st_size, reverse=True)
    tasks = [partial(look_at, page) for page in pages]
    if not code:
        tasks += [partial(search_works, folder), partial(text_search_works, folder)]
    faults = list(broken_links(folder)) + sorted(sum(in_browsers(tasks), []))
    print("\n".join(faults))
    print(f"{len(pages)} pages, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
