#!/usr/bin/python3
"""Opens every live figure of the book from disk in headless browsers, at the width of a phone.

A figure passes when it loads, its first picture is the one that the book shows without JavaScript, every control
changes it, a link restores its state, nothing is wider than the screen and the browser logs no error. In the World
every scene steps. Prints milliseconds per picture. Exit code 77: the book has no live
figures, since emscripten is not installed.

    tests/docs/live_test.py build/docs/html build/test/bin/cs550_demo
"""
import re
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

from book_test import LOOK, SETTLE
from browsers import errors_logged, in_browsers

SECONDS_TO_LOAD = 30
STEPS_OF_A_WORLD = 20
LEAST_PICTURES = 15  # in 3 s, on a machine that does other things as well
FIGURE = re.compile(r"<figure [^>]*data-live=")
WITHOUT_EFFECT = {("live_naive", "push")}  # nothing pushes back sideways where there is no friction
# Sines of another C library differ in the last bit, which decides here and there which piece of a curve is painted
# first. Measured: at most 0.04 %; a view turned by half a degree differs in 0.8 %.
MOST_DIFFERENT = 0.001  # share of the pixels

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

# The flight of a thrown box, and the energy after it.
FLY = "await live.engine.ask('advance', 20); await live.drawSoon();"
SHOWN = "return live.shapes.join();"
KINETIC = "return live.facts.facts.find(([name]) => name === 'kinetic energy')[1];"

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


def run(browser, script, figure, place=None):
    """What an asynchronous script returns. Raises the error that it throws."""
    result = browser.execute_async_script(
        "const [figure, place, done] = arguments; (async () => {" + script + "})()"
        ".then(value => done({value: value ?? null}), reason => done({problem: String(reason)}))", figure, place)
    if "problem" in result:
        raise RuntimeError(result["problem"])
    return result["value"]


def wait_for(browser, figure):
    deadline = time.monotonic() + SECONDS_TO_LOAD
    while time.monotonic() < deadline:
        if browser.execute_script("return Boolean(arguments[0].live)", figure):
            return True
        time.sleep(0.02)
    return False


def open_first(browser, page):
    """The first live figure of a page."""
    browser.get(page.as_uri())
    figure = browser.find_element("css selector", "figure[data-live]")
    browser.execute_script("arguments[0].querySelector('.live-start')?.click()", figure)
    if not wait_for(browser, figure):
        raise RuntimeError(f"{page.name}: the figure does not load: {figure.text[:200]}")
    run(browser, "figure.live.stopPlaying();" + BEGIN, figure)
    return figure


def check_controls(browser, figure):
    figure_name = figure.get_attribute("id").removeprefix("fig_")
    count = browser.execute_script(
        "return arguments[0].live.controls.querySelectorAll('input, select, button').length", figure)
    for number in range(count):
        run(browser, BEGIN, figure)
        before = run(browser, STATE, figure)
        name = run(browser, CHANGE, figure, number)
        if run(browser, STATE, figure) == before and (figure_name, name) not in WITHOUT_EFFECT:
            yield f"control {name} changes nothing"


def check_world(browser, figure):
    """Its settings matter when time goes on. The picture moves, a throw adds a body, a body can be picked."""
    run(browser, BEGIN, figure)
    before = run(browser, STATE, figure)
    run(browser, f"for (let i = 0; i < {STEPS_OF_A_WORLD}; ++i) await figure.live.advance();", figure)
    if run(browser, STATE, figure) == before:
        yield "nothing moves"
    alone = run(browser, BEGIN + FLY + KINETIC, figure)
    if run(browser, BEGIN + "await live.throwBox();" + FLY + KINETIC, figure) == alone:
        yield "a thrown box changes nothing"
    if run(browser, BEGIN + FLY + SHOWN, figure) == run(
            browser, BEGIN + "await live.set('follow', 'on'); await live.drawSoon();" + FLY + SHOWN, figure):
        yield "a camera that follows shows the same"
    run(browser, "await figure.live.set('follow', 'off')", figure)
    if "body" not in run(browser, "await figure.live.run('select_next');" + STATE, figure):
        yield "selecting the next body shows none"
    run(browser, "await figure.live.set('impulses', 'on'); await figure.live.advance()", figure)
    if not run(browser, "await figure.live.drawSoon(); return figure.live.legend.textContent", figure):
        yield "impulses have no legend"
    if run(browser, "return figure.live.plots.querySelectorAll('svg').length", figure) < 2:
        yield "plots are missing"
    if run(browser, "await figure.live.drawSoon(); return new Set(figure.live.canvas.getContext('2d')"
                    ".getImageData(0, 0, figure.live.canvas.width, figure.live.canvas.height).data).size", figure) < 8:
        yield "the canvas is empty"


def check(browser, folder, figure):
    name = figure.get_attribute("id").removeprefix("fig_")
    browser.execute_script("arguments[0].querySelector('.live-start')?.click()", figure)
    if not wait_for(browser, figure):
        yield f"{name}: does not load: {figure.text[:200]}"
        return
    run(browser, "figure.live.stopPlaying();" + BEGIN, figure)
    native = (folder / "figures" / f"{name}.svg").read_text()
    first = run(browser, "return (await figure.live.engine.ask('draw')).svg", figure)
    different = 0 if first == native else browser.execute_async_script(DIFFERENT, first, native)
    if different > MOST_DIFFERENT:
        yield f"{name}: its first picture is not figures/{name}.svg"
    check_answers = check_world if figure.get_attribute("data-live").startswith("0") else check_controls
    for fault in check_answers(browser, figure):
        yield f"{name}: {fault}"
    loaded, drawn = browser.execute_script("return [arguments[0].live.loaded, arguments[0].live.milliseconds]", figure)
    equal = "equal to the byte" if first == native else f"{100 * different:.3f} % of the pixels differ"
    print(f"{name}: {equal}, loaded in {loaded:.0f} ms, {drawn:.1f} ms per picture, {len(native) / 1000:.0f} kB")


def check_link(browser, figure):
    """A link with a setting opens the figure with it."""
    name = figure.get_attribute("id").removeprefix("fig_")
    run(browser, BEGIN + "await live.set('position', '0.1,0.2,1.5')", figure)
    expected = run(browser, STATE, figure)
    link = browser.execute_script("return arguments[0].live.link.getAttribute('href')", figure)
    browser.get(browser.current_url.partition("?")[0].partition("#")[0] + link)
    figure = browser.find_element("id", f"fig_{name}")
    if not wait_for(browser, figure) or run(browser, STATE, figure) != expected:
        yield f"{name}: {link} does not restore the state"


def check_end(browser, figure):
    """Code without an end is stopped, the figure reports that, and begins again."""
    endless = """
        const Engine = figure.live.engine.constructor;
        const code = new Blob(['onmessage = () => { for (;;); }']);
        try { await new Engine(URL.createObjectURL(code)).ask('advance', 1); } catch (reason) { return reason.message; }
        """
    if "endless loop" not in (run(browser, endless, figure) or ""):
        yield "an endless loop is not stopped"
    run(browser, "figure.live.engine.stop('Stopped by the test')", figure)
    run(browser, "await figure.live.advance()", figure)
    if "Stopped by the test" not in run(browser, "return figure.live.problem.textContent", figure):
        yield "a stopped engine is not reported"
    run(browser, "await figure.live.restart(); await figure.live.advance()", figure)
    if run(browser, "return figure.live.problem.textContent", figure):
        yield "a stopped figure does not begin again"


def check_scenes(browser, figure, demo):
    """Every shipped scene steps, and to the bits of the native engine. Prints milliseconds."""
    equal, scenes = [], run(browser, "return [...figure.querySelector('[name=scene]').options].map(each => each.value)",
                            figure)
    for scene in scenes:
        run(browser, f"await figure.live.set('scene', '{scene}')", figure)
        start = time.monotonic()
        run(browser, f"await figure.live.engine.ask('advance', {STEPS_OF_A_WORLD})", figure)
        step = 1000 * (time.monotonic() - start) / STEPS_OF_A_WORLD
        start = time.monotonic()
        run(browser, "await figure.live.drawSoon()", figure)
        drawn = 1000 * (time.monotonic() - start)
        if problem := run(browser, "return figure.live.problem.textContent", figure):
            yield f"scene {scene}: {problem}"
        live = run(browser, f"return figure.live.engine.ask('hash', '{scene}', {STEPS_OF_A_WORLD})", figure)
        command = [demo, scene, "--sleeping", "off", "--steps", str(STEPS_OF_A_WORLD), "--no-picture"]
        native = re.search(r"state hash\s+(\w+)", subprocess.run(command, capture_output=True, text=True).stdout)
        equal += [scene] if native and live == native[1] else []
        print(f"scene {scene}: {step:.1f} ms per step, {drawn:.0f} ms per picture and plots")
    print(f"hashes after {STEPS_OF_A_WORLD} steps equal the native ones in {len(equal)} of {len(scenes)} scenes")
    for scene in sorted(set(scenes) - set(equal)):
        yield f"scene {scene}: its hash after {STEPS_OF_A_WORLD} steps is not that of the native engine"


def check_speed(browser, figure):
    """Two hundred boxes move smoothly."""
    run(browser, "await figure.live.set('scene', 'wall')", figure)
    steps, pictures = run(browser, """
        const live = figure.live;
        const before = live.pictures;
        live.play();
        await sleep(3000);
        const pictures = live.pictures - before;
        live.play();
        await live.drawSoon();
        const steps = live.facts.facts.find(([name]) => name === 'step')[1];
        return [Number(steps), pictures];
        """.replace("sleep(", "new Promise(resolve => setTimeout(resolve, ").replace("3000)", "3000))"), figure)
    print(f"wall: {steps / 3:.0f} steps and {pictures / 3:.0f} pictures per second")
    if pictures < LEAST_PICTURES:
        yield f"the wall moves in jerks: {pictures} pictures in 3 s"


def check_page(folder, page, browser):
    """All live figures of a page, and the page with all of them."""
    browser.get(page.as_uri())
    faults = []
    for figure in browser.find_elements("css selector", "figure[data-live]"):
        faults += check(browser, folder, figure)
    browser.execute_async_script(SETTLE)
    faults += [f"{page.name}, live: {fault}" for fault in browser.execute_script(LOOK)]
    return faults + [f"{page.name}: {fault}" for fault in errors_logged(browser)]


def check_first(page, check_more, browser):
    """One more check of the first live figure of a page."""
    faults = list(check_more(browser, open_first(browser, page))) + list(errors_logged(browser))
    return [f"{page.name}: {fault}" for fault in faults]


def main():
    folder, demo = Path(sys.argv[1]).resolve(), sys.argv[2]
    if not (folder / "live_engine.js").exists():
        print("the book has no live figures: they need emscripten, then ./cs550 docs")
        return 77
    pages = [page for page in folder.glob("*.html") if FIGURE.search(page.read_text(errors="replace"))]
    pages.sort(key=lambda page: len(FIGURE.findall(page.read_text(errors="replace"))), reverse=True)
    world = folder / "world.html"
    tasks = [partial(check_first, world, partial(check_scenes, demo=demo)), partial(check_first, world, check_end)]
    tasks += [partial(check_page, folder, page) for page in pages]
    tasks += [partial(check_first, folder / "separating_axis.html", check_link)]
    faults = sum(in_browsers(tasks), [])
    # Alone, since it counts pictures per second.
    faults += sum(in_browsers([partial(check_first, world, check_speed)]), [])
    count = sum(len(FIGURE.findall(page.read_text(errors="replace"))) for page in pages)
    print("\n".join(faults))
    print(f"{count} live figures, {len(faults)} faults")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
