// Figures that answer: the static picture is replaced by one that the engine draws anew, at the reader's first touch.
// The engine (live_engine.js) is loaded then, once for all figures of a page. A link restores every setting.
'use strict';
(() => {
  const TURN = 0.008; // rad per pixel
  const KEY_TURN = 0.12; // rad per key
  const FRAME = 1000 / 30; // ms between steps of a walk that plays

  let engine = null;
  let count = 0;

  function loadEngine() {
    engine ??= new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = 'live_engine.js';
      script.onload = () => cs550LiveEngine().then(resolve, reject);
      script.onerror = () => reject(new Error('live_engine.js cannot be loaded'));
      document.head.append(script);
    });
    return engine;
  }

  function element(name, properties = {}, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  }

  const short = number => String(Number(Number(number).toPrecision(4)));

  class LiveFigure {
    constructor(figure, module, settings) {
      this.number = count++;
      this.figure = figure;
      this.module = module;
      this.name = figure.id.replace(/^fig_/, '');
      this.changed = new Map();
      this.call('live_open', figure.dataset.live);
      this.build();
      for (const [name, value] of settings) this.set(name, value);
      this.list();
      this.draw();
      this.stage.focus({preventScroll: true});
    }

    /** The answer's text. Throws the sentence of a refusal. */
    call(name, ...values) {
      const types = values.map(value => typeof value);
      const text = this.module.ccall(name, 'string', ['number', ...types], [this.number, ...values]);
      if (text.startsWith('!')) throw new Error(text.slice(1));
      return text;
    }

    run(name, ...values) {
      this.module.ccall(name, null, ['number', ...values.map(() => 'number')], [this.number, ...values]);
      this.drawSoon();
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
      this.controls = element('form', {className: 'live-controls', onsubmit: event => event.preventDefault()});
      this.link = element('a', {textContent: 'link to this state'});
      this.buttons = element('p', {className: 'live-buttons'});
      this.figure.querySelector('img').replaceWith(this.stage);
      this.figure.querySelector('.live-start').remove();
      this.stage.after(this.buttons, this.problem, this.numbers, this.plots, this.controls);
      this.stage.addEventListener('keydown', event => this.key(event));
      this.stage.addEventListener('pointerdown', event => this.startDrag(event));
      const facts = JSON.parse(this.call('live_facts'));
      const button = (text, act) => element('button', {type: 'button', textContent: text, onclick: act});
      this.dragsBody = element('input', {type: 'checkbox'});
      if (facts.drag) this.buttons.append(element('label', {}, this.dragsBody, ' drag moves the body '));
      this.playing = button('play', () => this.play());
      if (facts.walks) {
        const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
        this.buttons.append(button('step', () => this.advance()), ...(still ? [] : [this.playing]),
                            button('from the start', () => this.run('live_rewind')));
      }
      if (facts.throws) this.buttons.append(button('throw a box', () => this.throwBox()));
      this.buttons.append(this.link);
    }

    advance() {
      this.run('live_advance');
      const range = this.controls.elements.step;
      if (range) range.value = (Number(range.value) + 1) % (Number(range.max) + 1);
    }

    /** The box flies in the next steps: a world that stands still gets one. */
    throwBox() {
      this.run('live_throw');
      this.run('live_advance');
    }

    play() {
      const runs = this.playing.textContent === 'stop';
      this.playing.textContent = runs ? 'play' : 'stop';
      const tick = () => {
        if (this.playing.textContent !== 'stop') return;
        this.advance();
        setTimeout(tick, FRAME);
      };
      if (!runs) tick();
    }

    set(name, value) {
      this.problem.textContent = '';
      try {
        this.call('live_set', `${name}=${value}`);
        this.changed.set(name, value);
      } catch (reason) {
        this.problem.textContent = reason.message;
      }
      this.drawSoon();
    }

    /** Makes the inputs from what the page describes. */
    list() {
      this.controls.replaceChildren();
      let group = this.controls;
      for (const control of JSON.parse(this.call('live_describe'))) {
        if (control.kind === 'section') {
          group = element('fieldset', {}, element('legend', {textContent: control.label}));
          this.controls.append(group);
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
        const values = control.kind === 'vector' ? control.value : [control.value];
        const ranges = values.map(value => this.range(control, value));
        const output = element('output', {textContent: values.map(short).join(', ')});
        for (const range of ranges) {
          range.oninput = () => {
            output.textContent = ranges.map(each => short(each.value)).join(', ');
            change(ranges.map(each => each.value).join(','));
          };
        }
        label.append(output, ...ranges);
      }
      return label;
    }

    range(control, value) {
      const isWhole = control.kind === 'whole';
      return element('input', {type: 'range', name: control.name, min: control.least, max: control.most,
                               step: isWhole ? 1 : 'any', value: value, ariaLabel: control.label});
    }

    drawSoon() {
      this.pending ??= requestAnimationFrame(() => this.draw());
    }

    draw() {
      this.pending = null;
      const start = performance.now();
      this.svg = this.call('live_svg');
      this.milliseconds = performance.now() - start;
      this.stage.innerHTML = this.unique(this.svg, 'picture');
      const facts = JSON.parse(this.call('live_facts'));
      this.stage.setAttribute('aria-label', `${facts.title}. Arrow keys turn the view; space goes a step further.`);
      this.fitSteps(facts.steps);
      if (facts.problem) this.problem.textContent = facts.problem;
      this.numbers.replaceChildren(...facts.facts.map(
          ([name, value]) => element('div', {}, element('dt', {textContent: name}), element('dd', {textContent: value}))));
      this.plots.replaceChildren(...Array.from({length: facts.plots}, (_, i) => {
        const plot = element('div');
        plot.innerHTML = this.unique(this.call('live_plot', i), `plot${i}`);
        return plot;
      }));
      const state = [...this.changed].map(([name, value]) => `${name}=${value}`).join(';');
      this.link.href = `?live=${this.name}&set=${encodeURIComponent(state)}#fig_${this.name}`;
    }

    /** The shown step runs over the steps that the walk has; as a setting, -1 is the last. */
    fitSteps(steps) {
      this.steps = steps;
      const range = this.controls.elements.step;
      if (!range || steps < 1) return;
      const isLast = range.value === '-1' || range.value === range.max;
      Object.assign(range, {min: 0, max: steps - 1});
      if (isLast) range.value = steps - 1;
    }

    /** Pictures share a page: the names inside of each become its own. */
    unique(svg, part) {
      const prefix = `${this.name}-${part}-`;
      return svg.replaceAll(/\bid="|url\(#/g, `$&${prefix}`)
          .replace('"title description"', `"${prefix}title ${prefix}description"`);
    }

    key(event) {
      const turns = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
      if (event.target !== this.stage) return;
      if (turns[event.key]) {
        this.run('live_orbit', ...turns[event.key].map(turn => turn * KEY_TURN));
      } else if (event.key === ' ') {
        this.advance();
      } else {
        return;
      }
      event.preventDefault();
    }

    startDrag(event) {
      let [x, y] = [event.clientX, event.clientY];
      const perPixel = 2 / this.stage.getBoundingClientRect().height;
      const move = moved => {
        const [right, up] = [moved.clientX - x, y - moved.clientY];
        [x, y] = [moved.clientX, moved.clientY];
        if (this.dragsBody.checked) {
          this.run('live_drag', right * perPixel, up * perPixel);
        } else {
          this.run('live_orbit', -right * TURN, -up * TURN);
        }
      };
      this.stage.setPointerCapture(event.pointerId);
      this.stage.addEventListener('pointermove', move);
      const end = () => {
        this.stage.removeEventListener('pointermove', move);
        if (this.dragsBody.checked) this.list();
      };
      this.stage.addEventListener('pointerup', end, {once: true});
      this.stage.addEventListener('pointercancel', end, {once: true});
    }
  }

  async function start(figure, settings = []) {
    if (figure.live || figure.classList.contains('live-loading')) return;
    figure.classList.add('live-loading');
    const begin = performance.now();
    try {
      figure.live = new LiveFigure(figure, await loadEngine(), settings);
      figure.live.loaded = performance.now() - begin;
    } catch (reason) {
      figure.querySelector('.live-start')?.replaceChildren(`This figure stays as it is: ${reason.message}`);
    }
    figure.classList.remove('live-loading');
  }

  document.addEventListener('DOMContentLoaded', () => {
    const asked = new URLSearchParams(location.search);
    for (const figure of document.querySelectorAll('figure[data-live]')) {
      const button = element('button', {type: 'button', className: 'live-start', textContent: 'Make this figure live',
                                        onclick: () => start(figure)});
      const image = figure.querySelector('img');
      image.after(button);
      image.addEventListener('pointerdown', () => start(figure));
      if (figure.id === `fig_${asked.get('live')}`) {
        const settings = (asked.get('set') ?? '').split(';').filter(Boolean);
        start(figure, settings.map(each => each.split(/=(.*)/s).slice(0, 2)));
      }
    }
  });
})();
