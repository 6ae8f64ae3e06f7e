// The engine in a worker of its own for each figure: the page stays responsive, and code that does not end is stopped.
const ANSWER_LIMIT = 10000; // ms

/** Loads the worker's source once for all figures of a page. */
let source = null;
function loadSource() {
  source ??= new Promise((resolve, reject) => {
    const script = element('script', {src: 'live_engine.js', onload: resolve});
    script.onerror = () => {
      source = null;  // so that another try loads it again
      script.remove();
      reject(new Error('live_engine.js cannot be loaded'));
    };
    document.head.append(script);
  }).then(() => URL.createObjectURL(new Blob([`(${cs550LiveWorker})()`], {type: 'text/javascript'})));
  return source;
}

class Engine {
  static async start() {
    return new Engine(await loadSource());
  }

  constructor(address) {
    this.waiting = new Map();
    this.count = 0;
    this.worker = new Worker(address);
    this.worker.onmessage = ({data}) => this.receive(data);
    this.worker.onerror = event => this.stop(`The engine cannot be started: ${event.message}`);
  }

  /** The answer to a task of worker.js, or to a function of browser.cpp. */
  ask(name, ...values) {
    if (this.stopped) return Promise.reject(new Error(this.stopped));
    return new Promise((resolve, reject) => {
      const id = ++this.count;
      const limit = setTimeout(() => this.stop(
          `Stopped after ${ANSWER_LIMIT / 1000} s without an answer (an endless loop?)`), ANSWER_LIMIT);
      this.waiting.set(id, {resolve, reject, limit});
      this.worker.postMessage({id, name, values});
    });
  }

  receive({id, result, problem, crashed}) {
    if (crashed) return this.stop(problem);  // its memory may be damaged
    const {resolve, reject, limit} = this.waiting.get(id);
    clearTimeout(limit);
    this.waiting.delete(id);
    if (problem === undefined) resolve(result); else reject(new Error(problem));
  }

  /** Ends the worker. All questions fail with the reason from then on. */
  stop(reason) {
    this.stopped = reason;
    this.worker.terminate();
    for (const {reject, limit} of this.waiting.values()) {
      clearTimeout(limit);
      reject(new Error(reason));
    }
    this.waiting.clear();
  }
}
