"""Mouse, finger and wheel on the World: what the engine is asked when the events come at awkward times."""
from live_actions import run
from live_figures import BEGIN

# Sends events that no device has made, and notes what the engine is asked. `press` is answered late, by `answer`.
EVENTS = BEGIN + """
const {stage} = live;
const asked = [];
const ask = live.run;
let answer = '';
const wait = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));
live.run = async (name, ...values) => {
  asked.push([name, ...values]);
  if (name !== 'press') return ask.call(live, name, ...values);
  await wait(100);
  return answer;
};
const {setPointerCapture} = stage;
stage.setPointerCapture = () => {};  // there is no pointer to capture
const {left, top} = stage.getBoundingClientRect();
const send = (type, x, button, buttons) => stage.dispatchEvent(new PointerEvent(
    type, {pointerId: 7, button, buttons, clientX: left + x, clientY: top + 10}));
const turn = (deltaX, deltaY) => stage.dispatchEvent(new WheelEvent('wheel', {deltaX, deltaY, cancelable: true}));
"""
# Returns what was asked.
ASKED = """
await wait(200);
live.stopPlaying();
live.run = ask;
stage.setPointerCapture = setPointerCapture;
return asked;
"""

OTHER_BUTTON = EVENTS + "send('pointerdown', 10, 2, 2); send('pointermove', 40, -1, 2);" + ASKED
# The button was let go over a menu of the browser.
LOST = EVENTS + "send('pointerdown', 10, 0, 1); await wait(200); send('pointermove', 40, -1, 0);" \
                "send('pointermove', 80, -1, 0);" + ASKED
MOVES = "send('pointerdown', 10, 0, 1); send('pointermove', 40, -1, 1); send('pointermove', 70, -1, 1); await wait(200);"
BODY = EVENTS + "answer = 'body';" + MOVES + "send('pointerup', 70, 0, 0);" + ASKED
NO_BODY = EVENTS + MOVES + "send('pointerup', 70, 0, 0);" + ASKED
# Let go before the engine has answered.
FLICK = EVENTS + "answer = 'body'; send('pointerdown', 10, 0, 1); send('pointerup', 10, 0, 0);" + ASKED
WHEEL = EVENTS + "stage.focus(); turn(100, 0); turn(0, 5); turn(0, -500);" + ASKED


def names(asked):
    return [each[0] for each in asked]


def check_pointer(browser, figure):
    """A press begins a pull or a turn of the view, not one after the other. Only the first button counts."""
    if asked := run(browser, OTHER_BUTTON, figure):
        yield f"the second button asks for {asked}"
    if (asked := names(run(browser, LOST, figure))) != ["press"]:
        yield f"a pointer that was let go elsewhere asks for {asked}"
    if (asked := names(run(browser, BODY, figure))) != ["press", "pull", "release"]:
        yield f"a drag that begins while the engine is busy asks for {asked}"
    asked = run(browser, NO_BODY, figure)
    if names(asked) != ["press", "orbit"] or abs(asked[1][1] + 60 * 0.008) > 1e-6:
        yield f"a drag of 60 pixels beside all bodies asks for {asked}"
    if (asked := names(run(browser, FLICK, figure))) != ["press", "release"]:
        yield f"a short press on a body asks for {asked}"
    factors = [round(each[1], 6) for each in run(browser, WHEEL, figure)]
    if factors != [round(1.1 ** 0.05, 6), round(1 / 1.1, 6)]:
        yield f"a wheel that turns sideways, by 5 pixels and by five notches zooms by {factors}"
