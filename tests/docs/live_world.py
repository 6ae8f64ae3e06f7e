"""What the running World must do: settings, buttons, keys, drags, scenes, speed."""
import re
import subprocess
import time

from live_actions import POINTERS, drag, run, wait_for
from live_figures import BEGIN, CHANGE, STATE

STEPS_OF_A_WORLD = 20
LEAST_PICTURES = 15  # in 3 s, on a machine that does other things as well

# The flight of a thrown box, and the energy after it.
FLY = "await live.engine.ask('advance', 20); await live.drawSoon();"
SHOWN = "return live.shapes.join();"
KINETIC = "return live.facts.facts.find(([name]) => name === 'kinetic energy')[1];"

# Where a setting of the World has an effect, if not in the tower: in most scenes nothing bounces or is pushed out.
TOWER = "scene=stack10"
SCENE_OF_SETTING = {
    "baumgarte": "scene=wall contact_model=baumgarte",
    "max_push_speed": "scene=stack10 max_push_speed=0.001",
    "restitution_iterations": "scene=newton_cradle",
    "restitution_threshold": "scene=newton_cradle",
    "rotation": "scene=free_spin",
    "sleeping": "scene=incline",
    "slop": "scene=newton_cradle",
}
STEPS_OF_A_SETTING = 80
FINDS_NOTHING = "check_stages"  # in code that keeps every postcondition

# Begins the World with a description, and returns the names of its settings.
BEGIN_WORLD = """
const live = figure.live;
live.problem.textContent = '';
await live.engine.ask('open', place);
await live.list();
await live.drawSoon();
return [...live.controls.querySelectorAll('input, select, button')].map(control => control.name);
"""

# What the World shows after some steps. Plots are left out, since one of them is of times.
LATER = """
const live = figure.live;
await live.engine.ask('advance', place);
await live.drawSoon();
return live.shapes.join() + JSON.stringify(live.words) + live.numbers.textContent + live.problem.textContent;
"""

# What else a reader does. Each must change the picture of a world that has made a step.
ACTS_OF_A_READER = {
    "the button 'step'": "buttons.find(each => each.textContent === 'step').click();",
    "the button 'from the start'": "buttons.find(each => each.textContent === 'from the start').click();",
    "the button 'throw a box'": "buttons.find(each => each.textContent === 'throw a box').click();",
    "the list of scenes": "scene.selectedIndex += 1; scene.dispatchEvent(new Event('change'));",
    **{f"the key '{key}'": f"live.stage.dispatchEvent(new KeyboardEvent('keydown', {{key: '{key}'}}));"
       for key in ("ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-", "n", "t", " ")},
}
ACT = """
const live = figure.live;
const buttons = [...live.buttons.querySelectorAll('button')];
const scene = live.buttons.querySelector('select');
%s
await live.engine.ask('facts');
await live.drawSoon();
return live.shapes.join();
"""

# Changes the width of the figure, and returns those of the stage and its picture in pixels of the page.
RESIZE = """
const live = figure.live;
await live.drawSoon();
figure.style.width = `${place}px`;
await new Promise(resolve => setTimeout(resolve, 500));
await live.engine.ask('facts');
return [live.stage.clientWidth, live.canvas ? live.canvas.width / devicePixelRatio : live.size?.[0]];
"""

# Chooses a quality, changes one of its settings, and chooses another quality. Then the worker ends, and the setting is
# changed again.
QUALITIES = """
const live = figure.live;
live.changed.clear();
const shown = [];
for (const [name, value] of [['quality', 'game'], ['substeps', '8'], ['quality', 'accurate']]) {
  const input = live.controls.elements[name];
  input.value = value;
  await live.set(name, value);
  const {quality, substeps} = live.controls.elements;
  shown.push(`${quality.value} ${substeps.value}`);
}
const order = [...live.changed.keys()];
live.engine.stop('Stopped by the test');
await live.set('substeps', '9');
const last = [...live.changed.keys()];
await live.restart();
return [shown, order, last];
"""

# Overlays, a camera that follows and a setting of the scene, then another scene.
OTHER_SCENE = """
for (const [name, value] of [['impulses', 'on'], ['follow', 'on'], ['substeps', '9'], ['scene', 'stack10']]) {
  await live.set(name, value);
}
"""
DESCRIBED = "return await figure.live.engine.ask('describe');"

# A component of a vector moves, another one is beyond the end of its slider. Returns what the engine gets.
PART_OF_A_VECTOR = BEGIN + """
await live.set('gravity', '0,0,-80');
await live.list();
const [x] = live.controls.elements.gravity;
x.value = 1;
x.dispatchEvent(new Event('input'));
await live.engine.ask('facts');
return live.changed.get('gravity');
"""

MARKS = """
const marks = [...figure.live.legend.querySelectorAll('.live-mark')];
return [...new Set(marks.map(mark => getComputedStyle(mark).backgroundColor))];
"""


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
    if run(browser, MARKS, figure) != ["rgb(255, 255, 255)"]:
        yield "colours of the legend have another background than the picture"
    if run(browser, "return figure.live.plots.querySelectorAll('svg').length", figure) < 2:
        yield "plots are missing"
    if run(browser, "await figure.live.drawSoon(); return new Set(figure.live.canvas.getContext('2d')"
                    ".getImageData(0, 0, figure.live.canvas.width, figure.live.canvas.height).data).size", figure) < 8:
        yield "the canvas is empty"


def check_settings(browser, figure):
    """Each setting of the World changes what is seen later, in a scene where it matters."""
    shown = {}
    for place, name in enumerate(run(browser, BEGIN_WORLD, figure, f"0 {TOWER}")):
        world = f"0 {SCENE_OF_SETTING.get(name, TOWER)}"
        run(browser, BEGIN_WORLD, figure, world)
        if world not in shown:
            shown[world] = run(browser, LATER, figure, STEPS_OF_A_SETTING)
            run(browser, BEGIN_WORLD, figure, world)
        run(browser, CHANGE, figure, place)
        if run(browser, LATER, figure, STEPS_OF_A_SETTING) == shown[world] and name != FINDS_NOTHING:
            yield f"setting {name} of '{world}' changes nothing"


def check_quality(browser, figure):
    """A quality changes other settings: the inputs show them, and the link sets them in the reader's order."""
    run(browser, BEGIN_WORLD, figure, f"0 {TOWER}")
    shown, order, last = run(browser, QUALITIES, figure)
    if [each.split()[0] for each in shown] != ["game", "custom", "accurate"] or len(set(shown)) < 3:
        yield f"the inputs show {shown} for game, 8 substeps, and accurate"
    if order != ["substeps", "quality"] or last != ["quality", "substeps"]:
        yield f"the link sets {order}, and {last} after a change while the engine was stopped"


def check_other_scene(browser, figure):
    """A scene begins with its own settings, also the present one. The link keeps what the page has kept."""
    run(browser, BEGIN_WORLD, figure, f"0 {TOWER}")
    own = run(browser, DESCRIBED, figure)
    run(browser, BEGIN_WORLD, figure, f"0 {TOWER} contact_hertz=25")
    run(browser, "await figure.live.set('scene', 'stack10')", figure)
    if run(browser, DESCRIBED, figure) != own:
        yield "the present scene, chosen again, keeps changed settings"
    run(browser, BEGIN + OTHER_SCENE + "await live.drawSoon();", figure)
    expected = run(browser, DESCRIBED, figure)
    link = browser.execute_script("return arguments[0].live.link.getAttribute('href')", figure)
    name = figure.get_attribute("id")
    browser.get(browser.current_url.partition("?")[0].partition("#")[0] + link)
    figure = browser.find_element("id", name)
    if not wait_for(browser, figure) or run(browser, DESCRIBED, figure) != expected:
        yield f"{link} does not restore the settings"


def check_vector(browser, figure):
    """A slider of a vector changes only its own component."""
    if not (gravity := run(browser, PART_OF_A_VECTOR, figure)).endswith(",0,-80"):
        yield f"after a change of x, gravity is {gravity}"


def check_acts(browser, figure):
    """Each button and key of the World changes what is seen, and a drag takes a body."""
    for name, act in ACTS_OF_A_READER.items():
        run(browser, BEGIN_WORLD, figure, f"0 {TOWER}")
        before = run(browser, "await figure.live.advance();" + ACT % "", figure)
        if run(browser, ACT % act, figure) == before:
            yield f"{name} changes nothing"
    for device in POINTERS:
        run(browser, BEGIN_WORLD, figure, f"0 {TOWER}")
        drag(browser, figure, device)
        numbers = run(browser, "const live = figure.live; live.stopPlaying(); await live.drawSoon();"
                               "return live.numbers.textContent;", figure)
        if "body" not in numbers:
            yield f"a drag by {device} takes no body"


def check_width(browser, figure):
    """A figure that stands still is drawn again for another width of the page."""
    for width in (300, 350):
        widths = run(browser, RESIZE, figure, width)
        if widths != [width, width]:
            yield f"at {width} pixels, the stage and its picture are {widths} wide"


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
