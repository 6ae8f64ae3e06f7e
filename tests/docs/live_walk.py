"""The steps of a live figure: the control shows the engine's step, the link keeps it, and space goes a step further."""
from live_actions import run, wait_for
from live_figures import BEGIN, STATE

PAGES_WITH_WALKS = ["rigid_body", "hill_climbing", "contact_generation"]

# What the control shows, what the link holds, and what the engine has.
STEPS = """
const live = figure.live;
await live.drawSoon();
const range = live.controls.elements.step;
const setting = JSON.parse(await live.engine.ask('describe')).find(({name}) => name === 'step');
const link = new URLSearchParams(live.link.getAttribute('href').split('#')[0]).get('set');
return {range: range.value, output: range.parentElement.querySelector('output').textContent, last: range.max,
        link: link.match(/step=([^;]*)/)?.[1] ?? '', engine: String(setting.value), most: setting.most};
"""
CLICK = "await figure.live.drawSoon(); [...figure.live.buttons.querySelectorAll('button')]" \
        ".find(each => each.textContent === place).click(); await figure.live.engine.ask('facts');"
PLAY_A_LITTLE = """
figure.live.play();
await new Promise(resolve => setTimeout(resolve, 300));
figure.live.stopPlaying();
await new Promise(resolve => setTimeout(resolve, 300));
"""
# The walk becomes longer than the setting goes.
LONG = BEGIN + "await live.set('h', '0.001'); await live.set('seconds', '20'); await live.drawSoon();"
TO_THE_END = """
const range = figure.live.controls.elements.step;
range.value = range.max;
range.dispatchEvent(new Event('input'));
"""

PRESS_SPACE = """
const stage = figure.live.stage;
const isOthers = stage.dispatchEvent(new KeyboardEvent('keydown', {key: ' ', cancelable: true}));
await figure.live.drawSoon();
return [isOthers, stage.getAttribute('aria-label')];
"""


def agrees(steps):
    return steps["range"] == steps["output"] == steps["link"] == steps["engine"]


def check_walk(browser, figure):
    """Buttons move the control, its text and the link to where the engine is, and the link restores the step."""
    first = run(browser, BEGIN + STEPS.replace("const live = figure.live;", ""), figure)
    if first["engine"] == "-1" and (first["output"], first["range"]) != ("last", first["last"]):
        yield f"the last step is shown as {first}"
    for act, script in (("from the start", CLICK), ("step", CLICK), ("step", CLICK), ("play", PLAY_A_LITTLE)):
        run(browser, script, figure, act)
        steps = run(browser, STEPS, figure)
        if not agrees(steps):
            yield f"after '{act}' the step is {steps}"
    name = figure.get_attribute("id").removeprefix("fig_")
    expected = run(browser, STATE, figure)
    link = browser.execute_script("return arguments[0].live.link.getAttribute('href')", figure)
    browser.get(browser.current_url.partition("?")[0].partition("#")[0] + link)
    figure = browser.find_element("id", f"fig_{name}")
    if not wait_for(browser, figure) or run(browser, STATE, figure) != expected:
        yield f"{name}: {link} does not restore the step"


def check_space(browser, figure):
    """Where there are no steps, space scrolls the page as elsewhere, and the figure's description does not name it."""
    scrolls, description = run(browser, PRESS_SPACE, figure)
    if not scrolls or "space" in description:
        yield f"a figure without steps {'leaves' if scrolls else 'takes'} the space bar; its description: {description}"


def check_long_walk(browser, figure):
    """The control ends where the engine refuses the setting."""
    run(browser, LONG, figure)
    if (steps := run(browser, STEPS, figure))["output"] != "last" or int(steps["last"]) != steps["most"]:
        yield f"a long walk ends with {steps}"
    run(browser, TO_THE_END, figure)
    if not agrees(steps := run(browser, STEPS, figure)):
        yield f"at the end of the control the step is {steps}"
    run(browser, CLICK, figure, "step")
    steps = run(browser, STEPS, figure)
    if steps["engine"] != str(steps["most"] + 1) or steps["link"] != str(steps["most"]):
        yield f"behind the end of the control the step is {steps}"
    if problem := run(browser, "return figure.live.problem.textContent", figure):
        yield f"a long walk is refused: {problem}"
