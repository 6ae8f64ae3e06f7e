"""What a reader does with a live figure, in a browser that selenium drives."""
import time

from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.actions.pointer_input import PointerInput
from selenium.webdriver.common.keys import Keys

from live_figures import BEGIN, SECONDS_TO_LOAD

POINTERS, KEYS = ["mouse", "touch"], "arrow keys"


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


def drag(browser, figure, device):
    """From the middle of a figure to the right and down, or by two arrow keys."""
    stage = figure.find_element("class name", "live-stage")
    browser.execute_script("arguments[0].scrollIntoView({block: 'center'}); arguments[0].focus();", stage)
    if device == KEYS:
        stage.send_keys(Keys.ARROW_RIGHT, Keys.ARROW_DOWN)
        return
    actions = ActionBuilder(browser, mouse=PointerInput(device, device))
    actions.pointer_action.move_to(stage).pointer_down().move_to(stage, 30, 20).pointer_up()
    actions.perform()


def open_first(browser, page):
    """The first live figure of a page."""
    browser.get(page.as_uri())
    figure = browser.find_element("css selector", "figure[data-live]")
    browser.execute_script("arguments[0].querySelector('.live-start')?.click()", figure)
    if not wait_for(browser, figure):
        raise RuntimeError(f"{page.name}: the figure does not load: {figure.text[:200]}")
    run(browser, "figure.live.stopPlaying();" + BEGIN, figure)
    return figure
