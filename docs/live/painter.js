// Fills a canvas with what WorldCanvas::paint() lists: flat shapes from back to front.
const HEAD = 7; // pixels, of an arrow

const [POLYGON, LINE, DASHED_LINE, ARROW, DASHED_ARROW, DOT, SEGMENTS] = Array(7).keys();

function addHead(context, x0, y0, x1, y1) {
  const angle = Math.atan2(y1 - y0, x1 - x0);
  for (const side of [-0.4, 0.4]) {
    context.moveTo(x1, y1);
    context.lineTo(x1 - HEAD * Math.cos(angle + side), y1 - HEAD * Math.sin(angle + side));
  }
}

function addSegments(context, points) {
  for (let i = 0; i < points.length; i += 4) {
    context.moveTo(points[i], points[i + 1]);
    context.lineTo(points[i + 2], points[i + 3]);
  }
}

function addPath(context, points) {
  context.moveTo(points[0], points[1]);
  for (let i = 2; i < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
}

function paintShape(context, kind, size, points) {
  context.beginPath();
  if (kind === DOT) {
    context.arc(points[0], points[1], size, 0, 2 * Math.PI);
    context.fill();
  } else if (kind === POLYGON) {
    addPath(context, points);
    context.fill();
  } else {
    if (kind === SEGMENTS) addSegments(context, points); else addPath(context, points);
    if (kind === ARROW || kind === DASHED_ARROW) addHead(context, ...points);
    context.lineWidth = size;
    const isDashed = kind === DASHED_LINE || kind === DASHED_ARROW;
    if (isDashed) context.setLineDash([5, 4]);
    context.stroke();
    if (isDashed) context.setLineDash([]);
  }
}

/** Clears the canvas. A new size takes new memory, so that it is set only where it differs. */
function begin(canvas, width, height) {
  const [wide, high] = [width, height].map(length => Math.round(length * devicePixelRatio));
  if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, {width: wide, height: high});
  const context = canvas.getContext('2d');
  context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

function paintShapes(canvas, width, height, shapes, labels) {
  const context = begin(canvas, width, height);
  let [lastColour, lastOpacity] = [-1, -1];
  for (let at = 0; at < shapes.length;) {
    const kind = shapes[at], colour = shapes[at + 1], opacity = shapes[at + 2], size = shapes[at + 3];
    const first = at + 5;
    at = first + 2 * shapes[at + 4];
    if (colour !== lastColour) context.fillStyle = context.strokeStyle = `#${colour.toString(16).padStart(6, '0')}`;
    if (opacity !== lastOpacity) context.globalAlpha = opacity;
    [lastColour, lastOpacity] = [colour, opacity];
    paintShape(context, kind, size, shapes.subarray(first, at));
  }
  context.globalAlpha = 1;
  context.fillStyle = '#222';
  context.font = '12px sans-serif';
  for (const {x, y, text} of labels) context.fillText(text, x + 5, y - 5);
}
