#!/usr/bin/python3
"""Opens every live figure of the book from disk in headless browsers, at the width of a phone.

A figure passes when it loads, its first picture is the one that the book shows without JavaScript, every control
and every drag changes it, a link restores its state, the step control shows the engine's step, nothing is wider than
the screen and the browser logs no error. In the World every scene steps, and every setting, button and key has an
effect. Prints milliseconds per picture. Exit code 77: the book has no live figures, since emscripten is not installed.

    tests/docs/live_test.py build/docs/html build/test/bin/cs550_demo
"""
import sys
from functools import partial
from pathlib import Path

from book_test import LOOK, SETTLE
from browsers import errors_logged, in_browsers
from live_actions import KEYS, POINTERS, drag, open_first, run, wait_for
from live_figures import BEGIN, CHANGE, STATE, figure_count, is_built, pages_with_figures
from live_play import check_begin_again, check_pace, check_play, check_problems
from live_pointer import check_pointer
from live_walk import PAGES_WITH_WALKS, check_long_walk, check_space, check_walk
from live_world import (check_acts, check_other_scene, check_quality, check_scenes, check_settings, check_speed,
                        check_vector, check_width, check_world)

WITHOUT_EFFECT = {("live_naive", "push")}  # nothing pushes back sideways where there is no friction
# Sines of another C library differ in the last bit, which decides here and there which piece of a curve is painted
# first. Measured: at most 0.04 %; a view turned by half a degree differs in 0.8 %.
MOST_DIFFERENT = 0.001  # share of the pixels

PAGES_WITH_DRAGS = ["hill_climbing", "gauss_map", "contact_generation"]  # an arrow, two bodies, two bodies

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


def check_drags(browser, figure):
    """What a reader can choose to drag follows mouse, finger and arrow keys."""
    for way in run(browser, "return [...figure.live.drags.options].map(option => option.value)", figure):
        for device in POINTERS + [KEYS]:
            run(browser, BEGIN + "live.drags.value = place;", figure, way)
            before = run(browser, STATE, figure)
            drag(browser, figure, device)
            changes = run(browser, STATE, figure) != before
            settings = run(browser, "return [...figure.live.changed.keys()].length", figure)
            if not changes or settings != (way != "orbit"):
                yield f"{way} by {device} changes {'the picture' if changes else 'no picture'} and {settings} settings"


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
    """A link opens the figure with a setting, and with a body where it was dragged."""
    name = figure.get_attribute("id").removeprefix("fig_")
    run(browser, BEGIN + "await live.set('position', '0.1,0.2,1.5'); live.drags.value = 'move 0';", figure)
    drag(browser, figure, "mouse")
    expected = run(browser, STATE, figure)
    link = browser.execute_script("return arguments[0].live.link.getAttribute('href')", figure)
    browser.get(browser.current_url.partition("?")[0].partition("#")[0] + link)
    figure = browser.find_element("id", f"fig_{name}")
    if not wait_for(browser, figure) or run(browser, STATE, figure) != expected:
        yield f"{name}: {link} does not restore the state"


def check_start_link(folder, browser):
    """A link to the figure that plays by itself restores its settings, too."""
    page = (folder / "index.html").as_uri()
    browser.get(page)
    figure = browser.find_element("css selector", "figure[data-start]")
    if not wait_for(browser, figure):
        return [f"index.html: the figure does not begin: {figure.text[:200]}"]
    name = figure.get_attribute("id")
    run(browser, "const live = figure.live; live.stopPlaying(); await live.set('substeps', '9'); await live.drawSoon();",
        figure)
    browser.get(page + browser.execute_script("return arguments[0].live.link.getAttribute('href')", figure))
    figure = browser.find_element("id", name)
    settings = wait_for(browser, figure) and run(
        browser, "return [...figure.live.changed, [figure.live.controls.elements.substeps.value]].join(';')", figure)
    return [] if settings == "substeps,9;9" else [f"index.html: a link with substeps=9 restores {settings}"]


# The engine's script is not there at the first try.
MISSING_ENGINE = """
const {append} = document.head;
document.head.append = script => {
  document.head.append = append;
  script.src = 'absent.js';
  append.call(document.head, script);
};
"""


def check_second_try(page, browser):
    """An engine that could not be loaded is loaded at the next try."""
    browser.get(page.as_uri())
    figure = browser.find_element("css selector", "figure[data-live]")
    browser.execute_script(MISSING_ENGINE + "arguments[0].querySelector('.live-start').click()", figure)
    run(browser, "while (figure.classList.contains('live-loading')) await new Promise(next => setTimeout(next, 20));",
        figure)
    message = figure.find_element("class name", "live-start").text
    list(errors_logged(browser))  # it says that the file is absent
    browser.execute_script("arguments[0].querySelector('.live-start').click()", figure)
    if "cannot be loaded" not in message or not wait_for(browser, figure):
        return [f"{page.name}: after '{message}' another try does not load the engine"]
    return []


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
    if not is_built(folder):
        return 77
    pages = pages_with_figures(folder)
    world = folder / "world.html"
    tasks = [partial(check_first, world, partial(check_scenes, demo=demo)), partial(check_first, world, check_end)]
    tasks += [partial(check_page, folder, page) for page in pages]
    tasks += [partial(check_first, folder / f"{page}.html", check_drags) for page in PAGES_WITH_DRAGS]
    tasks += [partial(check_first, folder / "separating_axis.html", check_link)]
    tasks += [partial(check_first, folder / f"{page}.html", check_walk) for page in PAGES_WITH_WALKS]
    tasks += [partial(check_first, folder / "rigid_body.html", check_long_walk)]
    tasks += [partial(check_first, page, check_play) for page in (world, folder / "hill_climbing.html")]
    tasks += [partial(check_first, folder / "separating_axis.html", check_begin_again)]
    tasks += [partial(check_first, folder / "separating_axis.html", check_space)]
    tasks += [partial(check_first, world, check_settings), partial(check_first, world, check_acts)]
    tasks += [partial(check_first, world, check_pointer), partial(check_first, world, check_pace)]
    tasks += [partial(check_first, folder / "hill_climbing.html", each) for each in (check_problems, check_width)]
    tasks += [partial(check_start_link, folder), partial(check_second_try, folder / "hill_climbing.html")]
    tasks += [partial(check_first, world, check_quality), partial(check_first, world, check_width)]
    tasks += [partial(check_first, world, check_other_scene), partial(check_first, world, check_vector)]
    faults = sum(in_browsers(tasks), [])
    # Alone, since it counts pictures per second.
    faults += sum(in_browsers([partial(check_first, world, check_speed)]), [])
    count = sum(map(figure_count, pages))
    print("\n".join(faults))
    print(f"{count} live figures, {len(faults)} faults")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
