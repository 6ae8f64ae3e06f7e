"""A live figure that plays: what happens when it is stopped, when its code fails or crashes, when it begins again."""
from live_actions import run
from live_figures import BEGIN

PAUSE = "await new Promise(resolve => setTimeout(resolve, 500));"

# A double click on "stop". Returns how many loops run afterwards, and after "stop".
LOOPS = """
const live = figure.live;
let running = 0;
for (const name of ['playWorld', 'playWalk']) {
  const play = live[name];
  live[name] = async (...values) => {
    ++running;
    await play.apply(live, values);
    --running;
  };
}
live.play();
""" + PAUSE + """
live.play();
live.play();
""" + PAUSE + """
const after = [running, live.isPlaying];
live.play();
""" + PAUSE + """
return [...after, running];
"""

# The engine refuses everything. Returns whether the figure still plays, its problem, and what nobody catches.
FAILURE = """
const live = figure.live;
const uncaught = [];
addEventListener('unhandledrejection', ({reason}) => uncaught.push(String(reason)));
live.play();
""" + PAUSE + """
live.engine.ask = () => Promise.reject(new Error('Failed by the test'));
""" + PAUSE + """
const found = [live.isPlaying, live.problem.textContent, uncaught.join()];
delete live.engine.ask;
return found;
"""

# A worker that crashes. Returns the message and whether the engine is stopped.
CRASH = """
const Engine = figure.live.engine.constructor;
const answer = "postMessage({id: data.id, problem: 'the code crashed: by the test', crashed: true})";
const engine = new Engine(URL.createObjectURL(new Blob([`onmessage = ({data}) => ${answer}`])));
try {
  await engine.ask('advance', 1);
} catch (reason) {
  return [reason.message, Boolean(engine.stopped)];
}
"""

BUTTONS = "return [...figure.live.buttons.querySelectorAll('button')].filter(each => each.checkVisibility())" \
          ".map(each => each.textContent);"

BEGIN_AGAIN = """
const live = figure.live;
[...live.buttons.querySelectorAll('button')].find(each => each.textContent === 'begin again').click();
const end = performance.now() + 10000;
while (!live.again.hidden && performance.now() < end) await new Promise(resolve => setTimeout(resolve, 50));
await live.engine.ask('facts');
await live.drawSoon();
await live.list();
return [live.problem.textContent, live.vectors.get('position')];
"""


def check_play(browser, figure):
    """A double click on "stop" leaves one loop. A failure of the code ends it, and the button shows that."""
    if (loops := run(browser, LOOPS, figure)) != [1, True, 0]:
        yield f"after a double click on 'stop': loops, 'plays' and loops after 'stop' are {loops}"
    playing, problem, uncaught = run(browser, FAILURE, figure)
    if playing or problem != "Failed by the test" or uncaught:
        yield f"code that fails leaves a figure that {'plays' if playing else 'stops'} with '{problem}', and '{uncaught}'"
    crash = run(browser, CRASH, figure)
    if crash != ["the code crashed: by the test", True]:
        yield f"a crash leaves the message and a stopped engine: {crash}"


def check_begin_again(browser, figure):
    """A figure without steps that has been stopped begins again, with a setting that was changed meanwhile.

    A drag that the stopped engine refuses is no uncaught error, which the browser would log.
    """
    if "begin again" in run(browser, BUTTONS, figure):
        yield "'begin again' is offered before anything has been stopped"
    run(browser, "const live = figure.live; live.engine.stop('Stopped by the test');"
                 "live.drags.value = 'move 0'; live.dragByKey(1, 0);"
                 "await live.set('position', '0.1,0.2,1.5')", figure)
    if "begin again" not in run(browser, BUTTONS, figure):
        yield "'begin again' is not offered"
    problem, position = run(browser, BEGIN_AGAIN, figure)
    moved = [round(float(each), 6) for each in position.split(",")]
    if problem or moved != [0.1, 0.2, 1.5] or "begin again" in run(browser, BUTTONS, figure):
        yield f"a stopped figure does not begin again: position {position}, {problem}"

# Plays for two seconds of a clock that passes with the pictures, `place` of them per second. Returns the steps.
STEPS_IN_TWO_SECONDS = """
const live = figure.live;
const {now} = performance;
const frame = window.requestAnimationFrame;
let [time, pictures] = [now.call(performance), 0];
performance.now = () => time;
window.requestAnimationFrame = callback => setTimeout(() => {
  time += 1000 / place;
  ++pictures;
  callback(time);
});
live.play();
while (pictures < 2 * place) await new Promise(resolve => setTimeout(resolve, 5));
live.play();
performance.now = now;
window.requestAnimationFrame = frame;
await live.drawSoon();
return Number(live.facts.facts.find(([name]) => name === 'step')[1]);
"""
RATES = (30, 50, 60, 75, 144)  # pictures per second

# What the figure shows while the code reports a problem, when it does no more, and after a refusal.
PROBLEMS = """
const live = figure.live;
await live.drawSoon();
const shown = ['Reported by the test', ''].map(problem => {
  live.facts = {...live.facts, problem};
  live.show();
  return live.problem.textContent;
});
live.fail(new Error('Refused by the test'));
live.show();
return [...shown, live.problem.textContent];
"""


def check_pace(browser, figure):
    """A world passes as fast as the clock, whatever the number of pictures per second."""
    for rate in RATES:
        steps = run(browser, BEGIN + STEPS_IN_TWO_SECONDS.replace("const live = figure.live;", ""), figure, rate)
        # The last picture that was asked for may be missing, and pictures may have passed meanwhile.
        if abs(steps - 120) > 5:
            yield f"at {rate} pictures per second, {steps} steps of 1/60 s are made in 2 s"


def check_problems(browser, figure):
    """A problem is shown as long as the code has it."""
    shown = run(browser, PROBLEMS, figure)
    if shown != ["Reported by the test", "", "Refused by the test"]:
        yield f"a problem, none and a refusal show {shown}"
