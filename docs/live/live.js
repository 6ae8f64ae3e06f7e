// Figures that answer: the static picture is replaced by one that the engine draws anew, at the reader's first touch.
// A link restores every setting.
const TURN = 0.008; // rad per pixel
const KEY_DRAG = 15; // pixels per key
const ZOOM = 1.1; // per key or notch of the wheel
const FRAME = 1000 / 30; // ms between steps of a walk that plays
const NARROW = 520; // pixels
const LAST_STEP = -1; // as a setting
const MOST_STEPS = 3; // of a world between two pictures; a slower machine plays in slow motion
const NUMBERS_EVERY = 100; // ms, while a world runs
const PLOTS_EVERY = 300; // ms, while a world runs

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** The setting of the shown step. Pages without a walk have none. */
const stepOf = described => described.find(({name}) => name === 'step');
const short = number => String(Number(Number(number).toPrecision(4)));
const sleep = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));
const nextFrame = () => new Promise(resolve => requestAnimationFrame(resolve));

/** Tells how many steps of a world are due, so that it keeps pace with the clock at any number of pictures per second. */
class Pace {
  /** @param length of a step in ms */
  constructor(length) {
    this.length = length;
    this.last = performance.now();
  }

  /** The steps since the last ones. Rounded, so that a picture each 16 or 17 ms shows one step; the rest is kept. */
  take() {
    const now = performance.now();
    const due = Math.round((now - this.last) / this.length);
    this.last = due > MOST_STEPS ? now : this.last + due * this.length;
    return Math.min(due, MOST_STEPS);
  }
}

class LiveFigure {
  /** Begins with a description, as data-live has it, and settings as pairs. */
  static async open(figure, settings) {
    const live = new LiveFigure(figure);
    await live.begin(settings);
    return live;
  }

  constructor(figure) {
    this.figure = figure;
    this.name = figure.id.replace(/^fig_/, '');
    this.changed = new Map();
    this.pictures = 0;
    this.loops = 0;
    this.reported = '';
  }

  /** In a new worker, with the settings. */
  async begin(settings) {
    this.engine = await Engine.start();
    await this.engine.ask('open', this.figure.dataset.live);
    this.facts = JSON.parse(await this.engine.ask('facts'));
    if (!this.stage) this.build();
    this.again.hidden = true;
    try {
      for (const [name, value] of settings) await this.set(name, value);
      await this.list();
      await this.drawSoon();
    } catch (reason) {  // of code that crashes with these settings
      this.fail(reason);
    }
  }

  /** Asks the engine for a change, and draws. What is refused is shown. */
  async run(name, ...values) {
    try {
      const answer = await this.engine.ask(name, ...values);
      this.drawSoon();
      return answer;
    } catch (reason) {
      this.fail(reason);
      return '';
    }
  }

  /** Whatever failed, playing on would fail again. */
  fail(reason) {
    this.problem.textContent = reason.message;
    this.stopPlaying();
    this.again.hidden = !this.engine.stopped;
  }

  build() {
    this.stage = element('div', {className: 'live-stage', tabIndex: 0});
    this.stage.setAttribute('role', 'group');
    this.stage.setAttribute('aria-roledescription', 'live figure');
    this.plots = element('div', {className: 'live-plots'});
    this.numbers = element('dl', {className: 'live-facts'});
    this.numbers.setAttribute('aria-live', 'polite');
    this.problem = element('p', {className: 'live-problem'});
    this.problem.setAttribute('role', 'alert');
    this.legend = element('ul', {className: 'live-legend'});
    this.controls = element('form', {className: 'live-controls', onsubmit: event => event.preventDefault()});
    this.link = element('a', {textContent: 'link to this state'});
    this.buttons = element('p', {className: 'live-buttons'});
    this.figure.querySelector('img').replaceWith(this.stage);
    this.figure.querySelector('.live-start').remove();
    const settings = this.facts.canvas
        ? element('details', {className: 'live-settings'}, element('summary', {textContent: 'Settings'}), this.controls)
        : this.controls;
    const below = this.facts.canvas ? [settings, this.plots] : [this.plots, settings];
    this.stage.after(this.buttons, this.problem, this.legend, this.numbers, ...below);
    this.stage.addEventListener('keydown', event => this.key(event));
    this.addButtons();
    if (this.facts.canvas) {
      this.canvas = element('canvas');
      this.canvas.setAttribute('role', 'img');
      this.stage.append(this.canvas);
    }
    new ResizeObserver(() => this.fitsStage() || this.drawSoon()).observe(this.stage);
    listenToPointers(this);
  }

  addButtons() {
    const button = (text, act) => element('button', {type: 'button', textContent: text, onclick: act});
    this.addDrags();
    this.playing = button('play', () => this.play());
    this.again = button('begin again', () => this.restart());
    this.walks = this.facts.walks;
    if (this.walks) {
      const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
      this.buttons.append(button('step', () => this.advance()), ...(still ? [] : [this.playing]),
                          button('from the start', () => this.restart()));
    } else {
      this.buttons.append(this.again);
    }
    if (this.facts.canvas) this.buttons.append(button('throw a box', () => this.throwBox()));
    this.buttons.append(this.link);
  }

  /** What a drag and the arrow keys do: turn the view, or move or turn what the page lets the reader drag. */
  addDrags() {
    const ways = this.facts.handles.flatMap(({name, turns}, handle) =>
        ['move', ...(turns ? ['turn'] : [])].map(way => ({text: `${way} ${name}`, value: `${way} ${handle}`})));
    const options = [{text: 'turn the view', value: 'orbit'}, ...ways].map(each => element('option', each));
    this.drags = element('select', {}, ...options);
    if (ways.length > 0) this.buttons.append(element('label', {}, 'drag and arrow keys ', this.drags));
  }

  /** A way on the screen in pixels does what the reader has chosen. */
  drag(right, up) {
    const [way, handle] = this.drags.value.split(' ');
    if (way === 'orbit') return this.run('orbit', -right * TURN, -up * TURN);
    const perPixel = way === 'turn' ? TURN : 2 / this.stage.getBoundingClientRect().height;
    return this.run(way, Number(handle), right * perPixel, up * perPixel);
  }

  /** After a drag the settings that it has changed are shown, and belong to the link. */
  async endDrag() {
    if (this.drags.value === 'orbit') return;
    const before = this.vectors;
    try {
      await this.list();
      for (const [name, value] of this.vectors) {
        if (before.get(name) !== value) this.remember(name, value);
      }
      this.drawSoon();
    } catch (reason) {
      this.fail(reason);
    }
  }

  /** A figure that has been stopped gets a new worker. */
  restart() {
    this.problem.textContent = '';
    return this.engine.stopped ? this.begin([...this.changed]) : this.walk('rewind');
  }

  advance(steps = 1) {
    return this.walk('advance', steps);
  }

  /** Goes to another step. What is refused is shown. */
  async walk(name, ...values) {
    try {
      await this.engine.ask(name, ...values);
      if (this.step) await this.readStep();
      this.drawSoon();
    } catch (reason) {
      this.fail(reason);
    }
  }

  /** The step to which the engine has gone belongs to the link, as far as a setting can name it. */
  async readStep() {
    this.step = stepOf(JSON.parse(await this.engine.ask('describe')));
    this.remember('step', String(Math.min(this.step.value, this.step.most)));
  }

  /** Through a point of the canvas; the middle if none is given. A world that stands still gets a step. */
  async throwBox(x = this.width / 2, y = this.height / 2) {
    await this.run('throw', x, y);
    await this.advance();
  }

  get isPlaying() {
    return this.playing.textContent === 'stop';
  }

  stopPlaying() {
    this.playing.textContent = 'play';
    this.numbers.setAttribute('aria-live', 'polite');
  }

  async play() {
    if (this.isPlaying) return this.stopPlaying();
    this.playing.textContent = 'stop';
    this.numbers.setAttribute('aria-live', 'off');
    // A loop that was stopped ends, even if the next one has begun meanwhile.
    const loop = ++this.loops;
    const isOn = () => this.isPlaying && this.loops === loop;
    await (this.canvas ? this.playWorld(isOn) : this.playWalk(isOn));
  }

  /** A step per frame. */
  async playWalk(isOn) {
    while (isOn()) {
      await this.advance();
      await this.drawSoon();
      await sleep(FRAME);
    }
  }

  /** As many steps as time has passed. The engine makes the next picture while this one is painted. */
  async playWorld(isOn) {
    const pace = new Pace(1000 * this.facts.h);
    let next = null;
    const askForNext = () => {
      const due = pace.take();
      if (due < 1) return null;
      const picture = this.engine.ask('frame', due, ...this.fitCanvas());
      picture.catch(() => {});  // one that fails before the next round awaits it is no uncaught error
      return picture;
    };
    try {
      while (isOn()) {
        const picture = await next;
        next = isOn() ? askForNext() : null;  // stopped meanwhile: no further step
        if (picture) this.showPicture(picture);
        await nextFrame();
      }
      await next;
    } catch (reason) {
      this.fail(reason);
    }
    this.drawSoon();
  }

  async set(name, value) {
    this.problem.textContent = '';
    if (name === 'step' && this.step) this.step.value = value === 'last' ? LAST_STEP : Number(value);
    try {
      await this.engine.ask('set', `${name}=${value}`);
      this.remember(name, value);
      await (name === 'scene' || name === 'quality' ? this.list() : this.showQuality());
      this.drawSoon();
    } catch (reason) {
      this.fail(reason);
      if (this.engine.stopped) {
        this.remember(name, value);  // for the next worker
        return;
      }
      await this.list().catch(problem => this.fail(problem));  // the inputs show what the engine has
      this.drawSoon();
    }
  }

  /** The link and the next worker set the settings in this order: a scene and a quality change earlier ones. */
  remember(name, value) {
    this.changed.delete(name);
    this.changed.set(name, value);
  }

  /** After one of its settings was changed, a quality may have become another or none. */
  async showQuality() {
    const {quality} = this.controls.elements;
    if (!quality) return;
    const described = JSON.parse(await this.engine.ask('describe'));
    quality.value = described.find(({name}) => name === 'quality').value;
  }

  /** Makes the inputs from what the page describes. */
  async list() {
    const described = JSON.parse(await this.engine.ask('describe'));
    const vectors = described.filter(({kind}) => kind === 'vector');
    this.step = stepOf(described);
    this.vectors = new Map(vectors.map(({name, value}) => [name, value.join()]));
    this.controls.replaceChildren();
    let group = this.controls;
    for (const control of described) {
      if (control.kind === 'section') {
        group = element('fieldset', {}, element('legend', {textContent: control.label}));
        this.controls.append(group);
      } else if (control.name === 'scene') {
        this.buttons.querySelector('label.live-scene')?.remove();
        this.buttons.prepend(Object.assign(this.input(control), {className: 'live-scene'}));
      } else {
        group.append(this.input(control));
      }
    }
  }

  input(control) {
    const label = element('label', {}, control.label + (control.unit ? ` (${control.unit}) ` : ' '));
    const change = value => this.set(control.name, value);
    if (control.kind === 'toggle') {
      const box = element('input', {type: 'checkbox', name: control.name, checked: control.value});
      box.onchange = () => change(box.checked ? 'on' : 'off');
      label.prepend(box);
    } else if (control.kind === 'choice') {
      const select = element('select', {name: control.name}, ...control.names.map(
          name => element('option', {value: name, textContent: name, selected: name === control.value})));
      select.onchange = () => change(select.value);
      label.append(select);
    } else if (control.kind === 'moves') {
      const moves = [...control.value];
      const button = name => element('button', {type: 'button', name: control.name, textContent: name,
                                                onclick: () => change(moves.push(name) && moves.join(','))});
      label.append(...control.names.map(button));
    } else {
      const values = control.kind === 'vector' ? [...control.value] : [control.value];
      const ranges = values.map(value => this.range(control, value));
      const shown = each => (Number(each) === -1 && control.minus_one || short(each));
      const output = element('output', {textContent: values.map(shown).join(', ')});
      ranges.forEach((range, i) => {
        range.oninput = () => {
          values[i] = range.value;  // the others may be beyond the ends of their sliders
          output.textContent = values.map(shown).join(', ');
          change(values.join(','));
        };
      });
      label.append(output, ...ranges);
    }
    return label;
  }

  range(control, value) {
    const isWhole = control.kind === 'whole';
    return element('input', {type: 'range', name: control.name, min: control.least, max: control.most,
                             step: isWhole ? 1 : 'any', value: value, ariaLabel: control.label});
  }

  /** Draws once for all changes of a frame. @return a promise of the picture */
  drawSoon() {
    if (this.canvas && this.isPlaying) return Promise.resolve();  // the next picture is on its way
    this.isOld = true;
    this.drawing ??= this.drawUntilNew().catch(reason => this.fail(reason)).finally(() => { this.drawing = null; });
    return this.drawing;
  }

  async drawUntilNew() {
    while (this.isOld) {
      await nextFrame();
      this.isOld = false;
      await (this.canvas ? this.paint() : this.draw());
      this.show();
      await this.drawPlots();
    }
  }

  async draw() {
    this.size = this.pictureSize();
    Object.assign(this, await this.engine.ask('draw', ...this.size));
    this.stage.innerHTML = this.unique(this.svg, 'picture');
  }

  /** Drawn for the width of the page where that is narrow, so that labels stay readable. */
  pictureSize() {
    const width = this.stage.clientWidth;
    return width > 0 && width < NARROW ? [width, Math.round(0.85 * width)] : [];
  }

  /** Whether the picture was drawn for the stage as wide as it is. A hidden stage has no width. */
  fitsStage() {
    const width = this.stage.clientWidth;
    if (width === 0) return true;
    return this.canvas ? width === this.width : this.pictureSize().join() === this.size?.join();
  }

  /** Width and height of the canvas in pixels of the page. */
  fitCanvas() {
    this.width = this.stage.clientWidth;
    this.height = Math.round(Math.min(0.66 * this.width + 60, 560));
    this.canvas.style.height = `${this.height}px`;
    return [this.width, this.height];
  }

  async paint() {
    this.paintPicture(await this.engine.ask('paint', ...this.fitCanvas()));
  }

  paintPicture(picture) {
    Object.assign(this, picture);
    paintShapes(this.canvas, this.width, this.height, this.shapes, this.words.labels);
    ++this.pictures;
  }

  /** Of a world that runs: numbers and plots change less often. */
  showPicture(picture) {
    this.paintPicture(picture);
    if (performance.now() - (this.shown ?? 0) > NUMBERS_EVERY) this.show();
    this.drawPlots().catch(reason => this.fail(reason));
  }

  /** Everything but the picture and the plots. */
  show() {
    const {facts} = this;
    this.shown = performance.now();
    if (this.canvas) this.showLegend();
    const arrows = facts.handles.length > 0 ? 'turn the view, or do what the list below names' : 'turn the view';
    this.stage.setAttribute('aria-label', `${facts.title}. Arrow keys ${arrows}` +
        (this.walks ? '; space goes a step further.' : '.') +
        (this.canvas ? ' Plus and minus zoom; P plays; N selects the next body; T throws a box.' : ''));
    this.canvas?.setAttribute('aria-label', facts.story);
    this.fitSteps(facts.steps);
    this.report(facts.problem);
    this.numbers.replaceChildren(...facts.facts.map(
        ([name, value]) => element('div', {}, element('dt', {textContent: name}), element('dd', {textContent: value}))));
    const state = [...this.changed].map(([name, value]) => `${name}=${value}`).join(';');
    this.link.href = `?live=${this.name}&set=${encodeURIComponent(state)}#fig_${this.name}`;
  }

  /** A problem of the code is shown as long as the code has it; what was refused, until the next try. */
  report(problem) {
    const isShown = this.problem.textContent === this.reported;
    this.reported = problem;
    if ((problem || isShown) && this.problem.textContent !== problem) this.problem.textContent = problem;
  }

  showLegend() {
    const {legend, notes} = this.words;
    const mark = colour => Object.assign(element('span', {className: 'live-mark', textContent: '■'}),
                                         {style: `color: ${colour}`});
    this.legend.replaceChildren(...legend.map(({text, colour}) => element('li', {}, mark(colour), text)),
                                ...notes.map(note => element('li', {textContent: note})));
  }

  async drawPlots() {
    const isEarly = this.isPlaying && performance.now() - (this.plotted ?? 0) < PLOTS_EVERY;
    if (this.canvas && isEarly) return;
    this.plotted = performance.now();
    const plots = await this.engine.ask('plots', this.facts.plots);
    this.plots.replaceChildren(...plots.map((svg, i) => element('div', {innerHTML: this.unique(svg, `plot${i}`)})));
  }

  /** The shown step runs over the steps that the walk has, as far as the setting goes. */
  fitSteps(steps) {
    const range = this.controls.elements.step;
    if (!range || steps < 1) return;
    const {value, most} = this.step;
    const isLast = value === LAST_STEP;
    Object.assign(range, {min: 0, max: Math.min(steps - 1, most)});
    range.value = isLast ? range.max : value;
    range.parentElement.querySelector('output').textContent = isLast ? 'last' : Math.min(value, steps - 1);
  }

  /** Pictures share a page: the names inside of each become its own. */
  unique(svg, part) {
    const prefix = `${this.name}-${part}-`;
    return svg.replaceAll(/\bid="|url\(#/g, `$&${prefix}`)
        .replace('"title description"', `"${prefix}title ${prefix}description"`);
  }

  /** An arrow key moves the eye or a body its way. A pointer drags what is seen, so that the eye goes the other way. */
  dragByKey(right, up) {
    const sign = this.drags.value === 'orbit' ? -1 : 1;
    this.drag(sign * KEY_DRAG * right, sign * KEY_DRAG * up);
    this.endDrag();
  }

  key(event) {
    if (event.target !== this.stage || event.ctrlKey || event.metaKey || event.altKey) return;
    const turns = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
    const onCanvas = {'+': () => this.run('zoom', 1 / ZOOM), '-': () => this.run('zoom', ZOOM),
                      n: () => this.run('select_next'), p: () => this.playing.isConnected && this.play(),
                      t: () => this.throwBox()};
    if (turns[event.key]) {
      this.dragByKey(...turns[event.key]);
    } else if (event.key === ' ' && this.walks) {
      this.advance();
    } else if (this.canvas && onCanvas[event.key]) {
      onCanvas[event.key]();
    } else {
      return;
    }
    event.preventDefault();
  }
}

// A page that was left stays in the browser's memory. Its workers end, and begin again when the reader returns.
const liveFigures = new Set();
addEventListener('pagehide', () => liveFigures.forEach(live => live.engine.stop('The page was left.')));
addEventListener('pageshow', event => event.persisted && liveFigures.forEach(live => live.restart()));

async function start(figure, settings = []) {
  if (figure.live || figure.classList.contains('live-loading')) return;
  figure.classList.add('live-loading');
  figure.querySelector('.live-start').textContent = 'The engine is being loaded …';
  const begin = performance.now();
  try {
    figure.live = await LiveFigure.open(figure, settings);
    liveFigures.add(figure.live);
    figure.live.loaded = performance.now() - begin;
  } catch (reason) {
    figure.querySelector('.live-start')?.replaceChildren(`This figure stays as it is: ${reason.message}`);
  }
  figure.classList.remove('live-loading');
}

async function startAndFocus(figure) {
  await start(figure);
  figure.live?.stage.focus({preventScroll: true});
}

async function startAndPlay(figure, settings) {
  await start(figure, settings);
  if (figure.live && !figure.live.isPlaying) figure.live.play();
}

document.addEventListener('DOMContentLoaded', () => {
  const asked = new URLSearchParams(location.search);
  const settings = (asked.get('set') ?? '').split(';').filter(Boolean).map(each => each.split(/=(.*)/s).slice(0, 2));
  const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
  for (const figure of document.querySelectorAll('figure[data-live]')) {
    const button = element('button', {type: 'button', className: 'live-start', textContent: 'Make this figure live',
                                      onclick: () => startAndFocus(figure)});
    const image = figure.querySelector('img');
    image.after(button);
    image.addEventListener('pointerdown', () => startAndFocus(figure));
    const isLinked = figure.id === `fig_${asked.get('live')}`;
    // The first page opens on a scene that plays, unless the reader prefers stillness.
    if ('start' in figure.dataset && !still) {
      startAndPlay(figure, isLinked ? settings : []);
    } else if (isLinked) {
      start(figure, settings);
    }
  }
});
