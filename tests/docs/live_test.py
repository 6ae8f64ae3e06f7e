#!/usr/bin/python3
"""Opens every live figure of the book from disk in a headless browser, at the width of a phone.

A figure passes when it loads, its first picture is the one that the book shows without JavaScript, every control
changes it, a link restores its state, nothing is wider than the screen and the browser logs no error. Prints
milliseconds per picture. Exit code 77: the book has no live figures, since emscripten is not installed.
"""
import re
import sys
import time
from pathlib import Path

from book_test import LOOK, look_at, start_browser

SECONDS_TO_LOAD = 30
STEPS_OF_A_WORLD = 20
WITHOUT_EFFECT = {("live_naive", "push")}  # nothing pushes back sideways where there is no friction
# Sines of another C library differ in the last bit, which decides here and there which piece of a curve is painted
# first. Measured: at most 0.04 %; a view turned by half a degree differs in 0.8 %.
MOST_DIFFERENT = 0.001  # share of the pixels

# What a figure shows, without pictures that are due.
STATE = """
const live = arguments[0].live;
if (live.pending) { cancelAnimationFrame(live.pending); live.draw(); }
return live.steps + live.svg + live.numbers.textContent + live.plots.innerHTML + live.problem.textContent;
"""

# Calls back with the share of the pixels in which two pictures differ visibly.
DIFFERENT = """
const [first, second, done] = arguments;
const pixels = svg => new Promise((resolve, reject) => {
  const image = new Image();
  image.onload = () => {
    const canvas = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height});
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    resolve(context.getImageData(0, 0, canvas.width, canvas.height).data);
  };
  image.onerror = reject;
  image.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(svg);
});
Promise.all([pixels(first), pixels(second)]).then(([a, b]) => {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2].some(k => Math.abs(a[i + k] - b[i + k]) > 32)) ++count;
  }
  done(a.length === b.length ? 4 * count / a.length : 1);
}, () => done(1));
"""

# Begins the figure again, changes control number arguments[1], and returns its name.
CHANGE = """
const live = arguments[0].live;
live.call('live_open', live.figure.dataset.live);
live.list();
live.draw();
const control = live.controls.querySelectorAll('input, select, button')[arguments[1]];
if (control.type === 'range') {
  const [low, high] = [Number(control.min), Number(control.max)];
  control.value = Number(control.value) > (low + high) / 2 ? low + 0.3 * (high - low) : low + 0.7 * (high - low);
  control.dispatchEvent(new Event('input'));
} else if (control.tagName === 'SELECT') {
  control.selectedIndex = (control.selectedIndex + 1) % control.options.length;
  control.dispatchEvent(new Event('change'));
} else {
  control.click();
}
return control.name;
"""


def wait_for(browser, figure):
    deadline = time.monotonic() + SECONDS_TO_LOAD
    while time.monotonic() < deadline:
        if browser.execute_script("return Boolean(arguments[0].live)", figure):
            return True
        time.sleep(0.05)
    return False


def check_controls(browser, figure):
    figure_name = figure.get_attribute("id").removeprefix("fig_")
    count = browser.execute_script(
        "return arguments[0].live.controls.querySelectorAll('input, select, button').length", figure)
    for number in range(count):
        browser.execute_script(
            "const live = arguments[0].live; live.problem.textContent = '';"
            "live.call('live_open', live.figure.dataset.live); live.draw();", figure)
        before = browser.execute_script(STATE, figure)
        name = browser.execute_script(CHANGE, figure, number)
        if browser.execute_script(STATE, figure) == before and (figure_name, name) not in WITHOUT_EFFECT:
            yield f"control {name} changes nothing"


def check_world(browser, figure):
    """Its settings matter when time goes on: every one is accepted, and the picture moves."""
    before = browser.execute_script(STATE, figure)
    browser.execute_script(f"for (let i = 0; i < {STEPS_OF_A_WORLD}; ++i) arguments[0].live.advance();", figure)
    if browser.execute_script(STATE, figure) == before:
        yield "nothing moves"
    faces = "return arguments[0].live.svg.match(/<polygon/g).length"
    before = browser.execute_script(faces, figure)
    browser.execute_script("const live = arguments[0].live; live.throwBox(); live.draw();", figure)
    if browser.execute_script(faces, figure) <= before:
        yield "the thrown box is not to be seen"


def check(browser, folder, figure):
    name = figure.get_attribute("id").removeprefix("fig_")
    browser.execute_script("arguments[0].querySelector('.live-start').click()", figure)
    if not wait_for(browser, figure):
        yield f"{name}: does not load: {figure.text[:200]}"
        return
    native = (folder / "figures" / f"{name}.svg").read_text()
    first = browser.execute_script("return arguments[0].live.svg", figure)
    different = 0 if first == native else browser.execute_async_script(DIFFERENT, first, native)
    if different > MOST_DIFFERENT:
        yield f"{name}: its first picture is not figures/{name}.svg"
    check_answers = check_world if figure.get_attribute("data-live").startswith("0") else check_controls
    for fault in check_answers(browser, figure):
        yield f"{name}: {fault}"
    loaded, drawn = browser.execute_script("return [arguments[0].live.loaded, arguments[0].live.milliseconds]", figure)
    equal = "equal to the byte" if first == native else f"{100 * different:.3f} % of the pixels differ"
    print(f"{name}: {equal}, loaded in {loaded:.0f} ms, {drawn:.1f} ms per picture, {len(native) / 1000:.0f} kB")


def check_link(browser, page, figure):
    """A link with a setting opens the figure with it."""
    name = figure.get_attribute("id").removeprefix("fig_")
    browser.execute_script("const live = arguments[0].live; live.call('live_open', live.figure.dataset.live);"
                           "live.changed.clear(); live.set('position', '0.1,0.2,1.5'); live.draw()", figure)
    expected = browser.execute_script(STATE, figure)
    link = browser.execute_script("return arguments[0].live.link.getAttribute('href')", figure)
    browser.get(page.as_uri() + link)
    figure = browser.find_element("id", f"fig_{name}")
    if not wait_for(browser, figure) or browser.execute_script(STATE, figure) != expected:
        yield f"{name}: {link} does not restore the state"


def main():
    folder = Path(sys.argv[1]).resolve()
    if not (folder / "live_engine.js").exists():
        print("the book has no live figures: they need emscripten, then ./cs550 docs")
        return 77
    faults, count = [], 0
    browser = start_browser()
    try:
        for page in sorted(folder.glob("*.html")):
            if not re.search(r"<figure [^>]*data-live=", page.read_text(errors="replace")):
                continue
            browser.get(page.as_uri())
            figures = browser.find_elements("css selector", "figure[data-live]")
            count += len(figures)
            for figure in figures:
                faults += check(browser, folder, figure)
            faults += [f"{page.name}, live: {fault}" for fault in browser.execute_script(LOOK)]
            if page.name == "separating_axis.html":
                faults += check_link(browser, page, figures[0])
            faults += [f"{page.name}: {fault}" for fault in look_at(browser, page)]
    finally:
        browser.quit()
    print("\n".join(faults))
    print(f"{count} live figures, {len(faults)} faults")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
