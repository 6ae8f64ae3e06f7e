#!/usr/bin/python3
"""Opens every page with a live figure from disk in Firefox.

A figure passes when it becomes alive at the first touch and a control changes its picture. No page may log an error.
docs.live checks everything else in Chromium. Exit code 77: Firefox or the library that speaks to it is not installed,
or the book has no live figures.

    tests/docs/firefox_test.py build/docs/html
"""
import importlib.util
import shutil
import sys
from pathlib import Path

from live_figures import BEGIN, CHANGE, SECONDS_TO_LOAD, figure_count, is_built, pages_with_figures

FIND = "const figure = document.getElementById(id);"
SCROLL_TO = FIND + "figure.scrollIntoView({block: 'center'}); return 'start' in figure.dataset;"

# Whether a figure is alive in time.
WAIT = FIND + """
const end = performance.now() + 1000 * seconds;
while (!figure.live && performance.now() < end) await new Promise(resolve => setTimeout(resolve, 20));
figure.live?.stopPlaying();
return Boolean(figure.live);
"""

PICTURE = FIND + "await figure.live.drawSoon(); return figure.live.svg ?? figure.live.shapes.join();"
COUNT_CONTROLS = FIND + "return figure.live.controls.querySelectorAll('input, select, button').length;"


def changes_picture(browser, figure):
    """Whether any control does. Settings of the World matter only when time goes on, so not each of them."""
    browser.run(FIND + BEGIN, id=figure)
    before = browser.run(PICTURE, id=figure)
    for place in range(browser.run(COUNT_CONTROLS, id=figure)):
        browser.run(FIND + CHANGE, id=figure, place=place)
        if browser.run(PICTURE, id=figure) != before:
            return True
    return False


def check_page(browser, page):
    browser.open(page)
    figures = browser.run("return [...document.querySelectorAll('figure[data-live]')].map(figure => figure.id)")
    for figure in figures:
        begins_alone = browser.run(SCROLL_TO, id=figure)
        if not begins_alone:
            browser.touch(f"#{figure} img")
        if not browser.run(WAIT, id=figure, seconds=SECONDS_TO_LOAD):
            yield f"{figure} does not become alive"
        elif not changes_picture(browser, figure):
            yield f"no control of {figure} changes its picture"
    yield from (f"Firefox logs: {error[:200]}" for error in browser.errors)
    browser.errors.clear()


def main():
    folder = Path(sys.argv[1]).resolve()
    if not shutil.which("firefox-esr") or not importlib.util.find_spec("websocket"):
        print("live figures are not tried in Firefox: ./cs550 doctor --install firefox installs what that needs")
        return 77
    if not is_built(folder):
        return 77
    from firefox import Firefox  # needs the library

    pages = pages_with_figures(folder)
    with Firefox() as browser:
        faults = [f"{page.name}: {fault}" for page in pages for fault in check_page(browser, page)]
    print("\n".join(faults))
    print(f"{sum(map(figure_count, pages))} live figures in Firefox, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
