// Mouse and touch on a live figure. On a canvas a body follows the pointer, two fingers or the wheel zoom, and a double
// click throws a box. Everything else turns the view, or what the reader has chosen.

/** How far a wheel event turns, in notches: at most one. A trackpad sends many events of a few pixels each. */
function notchesOf({deltaY, deltaMode}) {
  const perNotch = deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : 3;  // pixels or lines
  return Math.max(-1, Math.min(deltaY / perNotch, 1));
}

function listenToPointers(live) {
  const {stage} = live;
  const pointers = new Map();
  let pulls = false;
  let asked = null;  // the way of a pointer while the engine is asked whether it has met a body

  const place = event => {
    const {left, top} = stage.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const spread = () => {
    const [[ax, ay], [bx, by]] = pointers.values();
    return Math.hypot(ax - bx, ay - by);
  };

  function move(event) {
    if (!pointers.has(event.pointerId)) return;
    if (event.buttons === 0) return end(event);  // let go where the page did not hear of it
    const before = pointers.get(event.pointerId);
    const apart = pointers.size === 2 ? spread() : 0;
    const now = place(event);
    pointers.set(event.pointerId, now);
    const [right, up] = [now[0] - before[0], before[1] - now[1]];
    if (pointers.size === 2) {
      if (live.canvas) live.run('zoom', apart / spread());
    } else if (asked) {
      asked[0] += right;
      asked[1] += up;
    } else if (pulls) {
      live.run('pull', ...now);
    } else {
      live.drag(right, up);
    }
  }

  function end(event) {
    if (!pointers.delete(event.pointerId)) return;
    if (pulls || asked) live.run('release');
    pulls = false;
    asked = null;
    live.endDrag();
  }

  /** A press begins either a pull or a turn of the view. */
  async function press(event) {
    const way = [0, 0];
    asked = way;
    const meetsBody = await live.run('press', ...place(event)) === 'body';
    const hasMoved = way.some(each => each !== 0);
    const isHeld = asked === way;
    if (isHeld) asked = null;
    if (!meetsBody) {
      if (hasMoved) live.drag(...way);
    } else if (isHeld) {
      pulls = true;
      if (hasMoved) live.run('pull', ...pointers.get(event.pointerId));
      if (live.playing.isConnected && !live.isPlaying) live.play();
    }
  }

  stage.addEventListener('pointerdown', event => {
    if (event.button !== 0) return;  // the others open a menu or scroll
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
    if (live.canvas && pointers.size === 1) press(event);
  });
  stage.addEventListener('pointermove', move);
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) stage.addEventListener(name, end);
  if (!live.canvas) return;
  stage.addEventListener('dblclick', event => live.throwBox(...place(event)));
  stage.addEventListener('wheel', event => {
    if (document.activeElement !== stage || event.deltaY === 0) return;  // otherwise the wheel scrolls the page
    event.preventDefault();
    live.run('zoom', ZOOM ** notchesOf(event));
  }, {passive: false});
}
