// Mouse and touch on a live figure. On a canvas a body follows the pointer, two fingers or the wheel zoom, and a double
// click throws a box. Everything else turns the view, or what the reader has chosen.

function listenToPointers(live) {
  const {stage} = live;
  const pointers = new Map();
  let pulls = false;

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
    const before = pointers.get(event.pointerId);
    const apart = pointers.size === 2 ? spread() : 0;
    const now = place(event);
    pointers.set(event.pointerId, now);
    const [right, up] = [now[0] - before[0], before[1] - now[1]];
    if (pointers.size === 2) {
      if (live.canvas) live.run('zoom', apart / spread());
    } else if (pulls) {
      live.run('pull', ...now);
    } else {
      live.drag(right, up);
    }
  }

  function end(event) {
    if (!pointers.delete(event.pointerId)) return;
    if (pulls) live.run('release');
    pulls = false;
    live.endDrag();
  }

  stage.addEventListener('pointerdown', async event => {
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
    if (!live.canvas || pointers.size !== 1) return;
    pulls = await live.run('press', ...place(event)) === 'body';
    if (pulls && !pointers.has(event.pointerId)) {  // let go meanwhile
      pulls = false;
      live.run('release');
    } else if (pulls && live.playing.isConnected && !live.isPlaying) {
      live.play();
    }
  });
  stage.addEventListener('pointermove', move);
  stage.addEventListener('pointerup', end);
  stage.addEventListener('pointercancel', end);
  if (!live.canvas) return;
  stage.addEventListener('dblclick', event => live.throwBox(...place(event)));
  stage.addEventListener('wheel', event => {
    if (document.activeElement !== stage) return;  // otherwise the wheel scrolls the page
    event.preventDefault();
    live.run('zoom', event.deltaY > 0 ? ZOOM : 1 / ZOOM);
  }, {passive: false});
}
