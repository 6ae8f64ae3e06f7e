// Runs in a worker, after the engine and its `hulls`: one figure, which live.js asks by messages {id, name, values}.
// An answer is {id, result} or {id, problem}, with crashed: true where the engine cannot go on.
const starting = cs550LiveEngine();

function tasks(engine) {
  const call = (name, ...values) => {
    const text = engine.ccall(`live_${name}`, 'string', values.map(value => typeof value), values);
    if (text.startsWith('!')) throw new Error(text.slice(1));
    return text;
  };
  const timed = make => {
    const start = performance.now();
    const made = make();
    return {...made, milliseconds: performance.now() - start, facts: JSON.parse(call('facts'))};
  };
  const shapes = () => {
    const first = engine.ccall('live_shapes', 'number') / Float32Array.BYTES_PER_ELEMENT;
    return engine.HEAPF32.slice(first, first + engine.ccall('live_shapes_size', 'number'));
  };
  const paint = (width, height) => timed(() => ({words: JSON.parse(call('paint', width, height)), shapes: shapes()}));
  return {
    call,
    open: description => call('hulls', hulls) + call('open', description),
    draw: (width = 0, height = 0) => timed(() => ({svg: call('svg', width, height)})),
    paint,
    frame: (steps, width, height) => {
      call('advance', steps);
      return paint(width, height);
    },
    plots: count => Array.from({length: count}, (_, plot) => call('plot', plot)),
  };
}

const isCrash = reason => reason instanceof WebAssembly.RuntimeError || reason instanceof RangeError;

function explain(reason) {
  if (isCrash(reason)) return `the code crashed: ${reason.message}`;
  return reason.message ?? 'the code threw something that is not a std::exception';
}

self.onmessage = async ({data: {id, name, values}}) => {
  try {
    const {call, ...own} = tasks(await starting);
    self.postMessage({id, result: own[name] ? own[name](...values) : call(name, ...values)});
  } catch (reason) {
    self.postMessage({id, problem: explain(reason), crashed: isCrash(reason)});
  }
};
