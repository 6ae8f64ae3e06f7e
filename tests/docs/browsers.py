"""Headless browsers for the tests of the book: as many as there are processors, each kept open for many pages."""
import os
import tempfile
from collections import deque
from concurrent.futures import ThreadPoolExecutor

from selenium import webdriver
from selenium.webdriver.chrome.options import Options

PHONE = (390, 844)
DESK = (1280, 800)
SECONDS_TO_ANSWER = 60


def start_browser(profile):
    options = Options()
    arguments = ["--headless=new", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
                 "--disable-component-update", "--disable-sync", f"--user-data-dir={profile}"]
    if os.geteuid() == 0:
        arguments.append("--no-sandbox")  # the browser refuses root otherwise
    for argument in arguments:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(options=options)
    show_on(browser, PHONE)
    browser.set_script_timeout(SECONDS_TO_ANSWER)
    return browser


def show_on(browser, screen):
    # A headless window cannot be narrower than 500 pixels, but the screen can.
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": screen[0], "height": screen[1], "deviceScaleFactor": 1, "mobile": screen == PHONE})


def in_browsers(tasks, most=os.cpu_count() or 1):
    """The results of the functions, in their order. Each is called with a browser; the first tasks begin first."""
    waiting = deque(enumerate(tasks))
    results = [None] * len(waiting)

    def work():
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
            browser = start_browser(profile)
            try:
                while True:
                    try:
                        number, task = waiting.popleft()
                    except IndexError:
                        return
                    results[number] = task(browser)
            except BaseException:
                waiting.clear()  # the other browsers need not go on
                raise
            finally:
                browser.quit()

    with ThreadPoolExecutor(most) as pool:
        for worker in [pool.submit(work) for _ in range(min(most, len(waiting)))]:
            worker.result()
    return results


def errors_logged(browser):
    """What the browser has logged since the last call."""
    for entry in browser.get_log("browser"):
        if entry["level"] in ("SEVERE", "WARNING"):
            yield f"the browser says: {entry['message'][:200]}"
