#!/usr/bin/python3
"""Opens every page of the book from disk in one headless browser, at the width of a phone.

A page passes when the browser logs no error and no failed request, all formulas are rendered, nothing is
left as TeX or Markdown, all images are there and described, nothing is wider than the screen, and all links lead to
something. The search must find a word. Exit code 77: the book is not built.
"""
import os
import re
import sys
import tempfile
import time
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.common.by import By

PHONE = (390, 844)
SECONDS_TO_TYPESET = 60


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


def start_browser():
    options = Options()
    arguments = ["--headless=new", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
                 "--disable-component-update", "--disable-sync", f"--user-data-dir={tempfile.mkdtemp()}"]
    if os.geteuid() == 0:
        arguments.append("--no-sandbox")  # the browser refuses root otherwise
    for argument in arguments:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(options=options)
    # A headless window cannot be narrower than 500 pixels, but the screen can.
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": PHONE[0], "height": PHONE[1], "deviceScaleFactor": 1, "mobile": True})
    browser.set_script_timeout(SECONDS_TO_TYPESET)
    return browser


# Calls back when MathJax is finished.
TYPESET = """
const done = arguments[0];
if (window.MathJax && MathJax.Hub) MathJax.Hub.Queue(() => done(true)); else done(false);
"""

# The errors of the current page.
LOOK = r"""
const faults = [];
const walker = document.createTreeWalker(document.querySelector('.contents') || document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const parent = walker.currentNode.parentElement;
  if (parent.closest('script, style, .fragment, code, .MathJax_Preview')) continue;
  const tex = walker.currentNode.data.match(/\\\(|\\\[|\\[a-z]+\{|\$[^$\s][^$]*\$/);
  if (walker.currentNode.data.includes('**')) faults.push('raw Markdown: ' + walker.currentNode.data.trim().slice(0, 80));
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
return faults;
"""


def look_at(browser, page):
    browser.get(page.as_uri())
    browser.execute_async_script(TYPESET)
    yield from browser.execute_script(LOOK)
    for entry in browser.get_log("browser"):
        if entry["level"] in ("SEVERE", "WARNING"):
            yield f"the browser says: {entry['message'][:200]}"


def search_works(browser, folder):
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
            return True
        time.sleep(0.1)
    return False


def text_search_works(browser, folder):
    """A word that is no name leads to a section of a chapter, and formulas around it are shown without TeX."""
    browser.get((folder / "search.html").as_uri() + "?q=polhode")
    passages = browser.find_elements(By.CSS_SELECTOR, "#text_search li")
    links = [passage.find_element(By.TAG_NAME, "a").get_attribute("href") for passage in passages]
    return any("rigid_body.html#" in link for link in links) and not any("\\(" in each.text for each in passages)


def main():
    folder = Path(sys.argv[1]).resolve()
    if not (folder / "index.html").exists():
        print("the book is not built: ./cs550 docs")
        return 77
    faults = list(broken_links(folder))
    pages = sorted(folder.glob("*.html"))
    browser = start_browser()
    try:
        for page in pages:
            faults += [f"{page.name}: {fault}" for fault in look_at(browser, page)]
        if not search_works(browser, folder):
            faults.append("index.html: the search does not find hill_climb")
        if not text_search_works(browser, folder):
            faults.append("search.html: the text search does not find polhode")
    finally:
        browser.quit()
    print("\n".join(faults))
    print(f"{len(pages)} pages, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
