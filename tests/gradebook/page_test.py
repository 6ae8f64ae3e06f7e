#!/usr/bin/python3
"""page_test.py PROGRAM ROOT SCRATCH: the overview of a class and the feedback pages, in a headless browser.

A class that a fake has graded is opened at 400 and 1280 pixels, in light and dark. A page passes when the browser
logs nothing, nothing is wider than the screen, all text stands out from its background, all links lead to a file, and
no script of a student runs.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.options import Options

PROGRAM, ROOT, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:4])
FAKE = Path(__file__).parent / "fake_grade_lab.sh"
HOSTILE = "<script>document.title='hacked'</script><img src=x onerror=\"document.title='hacked'\">"

# What is wrong with the page that is shown, in words.
LOOK = r"""
const faults = [];
if (document.title === 'hacked') faults.push('a script of a student was run');
if (document.documentElement.scrollWidth > innerWidth + 1) {
  faults.push('wider than the screen: ' + document.documentElement.scrollWidth + ' of ' + innerWidth + ' pixels');
}
const luminance = colour => {
  const [r, g, b] = colour.match(/[\d.]+/g).slice(0, 3).map(x => x / 255)
      .map(x => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const background = element => {
  for (; element; element = element.parentElement) {
    const colour = getComputedStyle(element).backgroundColor;
    if (colour !== 'rgba(0, 0, 0, 0)') return colour;
  }
  return 'rgb(255, 255, 255)';
};
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const parent = walker.currentNode.parentElement;
  if (!walker.currentNode.data.trim()) continue;
  const style = getComputedStyle(parent);
  const text = luminance(parent.closest('svg') ? style.fill : style.color);
  const back = luminance(background(parent));
  const contrast = (Math.max(text, back) + 0.05) / (Math.min(text, back) + 0.05);
  // https://www.w3.org/TR/WCAG21/#contrast-minimum
  if (contrast < 4.5) faults.push(`contrast ${contrast.toFixed(1)}: ${walker.currentNode.data.trim().slice(0, 40)}`);
}
return faults;
"""
LINKS = "return [...document.links].map(link => link.href)"


def quoted(field):
    return '"' + field.replace('"', '""') + '"'


def make_class(folder):
    """Forty students; one of them hostile."""
    for i in range(40):
        lab = folder / "class" / f"student{i:02}" / "labs"
        fails = "// fake: fails FirstOfEqualVerticesWins\n" if i % 3 else ""
        for name, text in (("lab1_integration/integration.cpp", f"// {i}"),
                           ("lab3_hill_climbing/hill_climbing.cpp", fails + f"// {i}"),
                           ("lab5_clipping/clipping.cpp", "// fake: no compile" if i % 7 == 0 else f"// {i % 20}")):
            (lab / name).parent.mkdir(parents=True)
            (lab / name).write_text(text)
        if i == 0:
            (lab / "lab3_hill_climbing" / "<script>document.title='hacked'<").mkdir()
            (lab / "lab3_hill_climbing" / "<script>document.title='hacked'<" / "script>.txt").write_text("")
    rows = [f"student{i:02}," + quoted(HOSTILE if i == 0 else f"Student Number {i}") for i in range(42)]
    (folder / "roster.csv").write_text("id,name\n" + "\n".join(rows) + "\n")
    (folder / "course.toml").write_text("title = \"Rigid bodies <script>document.title='hacked'</script>\"\n")
    subprocess.run([PROGRAM, "--judge", FAKE, folder / "class", "--out", folder / "out", "--roster",
                    folder / "roster.csv", "--course", folder / "course.toml", "--milestones"], check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "CS550_ROOT": str(ROOT)})
    return folder / "out"


def start_browser():
    options = Options()
    arguments = ["--headless=new", "--disable-gpu", "--no-first-run", "--disable-background-networking",
                 "--disable-component-update", "--disable-sync", f"--user-data-dir={tempfile.mkdtemp()}"]
    if os.geteuid() == 0:
        arguments.append("--no-sandbox")  # the browser refuses root otherwise
    for argument in arguments:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(options=options)


def look_at(browser, page, width, scheme):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600})
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia",
                            {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    browser.get(page.as_uri())
    browser.execute_script("document.querySelectorAll('details').forEach(part => part.open = true)")
    yield from browser.execute_script(LOOK)
    for entry in browser.get_log("browser"):
        yield f"the browser says: {entry['message'][:200]}"


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    out = make_class(SCRATCH)
    pages = [out / "class.html", out / "feedback/student00.html", out / "feedback/student01.html"]
    faults = []
    browser = start_browser()
    try:
        for page in pages:
            for width in (400, 1280):
                for scheme in ("light", "dark"):
                    faults += [f"{page.name}, {width} pixels, {scheme}: {fault}"
                               for fault in look_at(browser, page, width, scheme)]
                    if len(sys.argv) > 4:
                        browser.save_screenshot(f"{sys.argv[4]}/{page.stem}-{width}-{scheme}.png")
        browser.get(pages[0].as_uri())
        links = browser.execute_script(LINKS)
        if len(links) < 40:
            faults.append(f"class.html has {len(links)} links, expected one per student or more")
        faults += [f"class.html: {link} does not exist" for link in links
                   if not Path(link.removeprefix("file://")).exists()]
        if len({json.loads(file.read_text())["hash"] for file in (out / "records").iterdir()}) < 20:
            faults.append("the class was not graded")
    finally:
        browser.quit()
    print("\n".join(faults))
    print(f"{len(pages)} pages, {len(faults)} faults")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
