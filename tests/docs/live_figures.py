"""The live figures of the book, and scripts for what a reader does with them. For the tests in several browsers.

Each script is the body of an asynchronous function of `figure`; CHANGE takes `place`, too.
"""
import re

SECONDS_TO_LOAD = 30
FIGURE = re.compile(r"<figure [^>]*data-live=")

# What a figure shows, when all pictures are drawn.
STATE = """
const live = figure.live;
await live.drawSoon();
return live.facts.steps + (live.svg ?? live.shapes.join()) + live.numbers.textContent + live.plots.innerHTML
    + live.problem.textContent;
"""

# Begins the figure again.
BEGIN = """
const live = figure.live;
live.problem.textContent = '';
live.changed.clear();
await live.engine.ask('open', live.figure.dataset.live);
await live.list();
await live.drawSoon();
"""

# Changes control number `place`, and returns its name.
CHANGE = """
const control = figure.live.controls.querySelectorAll('input, select, button')[place];
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
// Answers come in order: this one after that of the change.
await figure.live.engine.ask('facts');
await figure.live.drawSoon();
return control.name;
"""


def figure_count(page):
    return len(FIGURE.findall(page.read_text(errors="replace")))


def pages_with_figures(folder):
    """Those with most figures first."""
    return sorted(filter(figure_count, sorted(folder.glob("*.html"))), key=figure_count, reverse=True)


def is_built(folder):
    """Whether the book has live figures. Prints what is missing."""
    if (folder / "live_engine.js").exists():
        return True
    print("the book has no live figures: they need emscripten, then ./cs550 docs")
    return False
