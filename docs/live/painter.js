// Fills a canvas with what WorldCanvas::paint() lists: flat shapes from back to front.
const OUTLINE = 'rgba(0, 0, 0, 0.35)';
const HEAD = 7; // pixels, of an arrow

const [POLYGON, LINE, DASHED_LINE, ARROW, DASHED_ARROW, DOT] = Array(6).keys();

function addHead(context, x0, y0, x1, y1) {
  const angle = Math.atan2(y1 - y0, x1 - x0);
  for (const side of [-0.4, 0.4]) {
    context.moveTo(x1, y1);
    context.lineTo(x1 - HEAD * Math.cos(angle + side), y1 - HEAD * Math.sin(angle + side));
  }
}

function paintShape(context, kind, size, points) {
  context.beginPath();
  if (kind === DOT) {
    context.arc(points[0], points[1], size, 0, 2 * Math.PI);
    context.fill();
    return;
  }
  context.moveTo(points[0], points[1]);
  for (let i = 2; i < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
  if (kind === POLYGON) {
    context.closePath();
    context.fill();
    if (size > 0) context.strokeStyle = OUTLINE;
  }
  if (kind === ARROW || kind === DASHED_ARROW) addHead(context, ...points);
  context.lineWidth = size || 1;
  context.setLineDash(kind === DASHED_LINE || kind === DASHED_ARROW ? [5, 4] : []);
  context.stroke();
}

function paintShapes(canvas, width, height, shapes, labels) {
  const ratio = devicePixelRatio;
  Object.assign(canvas, {width: width * ratio, height: height * ratio});
  const context = canvas.getContext('2d');
  context.scale(ratio, ratio);
  context.lineJoin = 'round';
  for (let at = 0; at < shapes.length;) {
    const [kind, colour, opacity, size, count] = shapes.subarray(at, at + 5);
    at += 5 + 2 * count;
    context.globalAlpha = opacity;
    context.fillStyle = context.strokeStyle = `#${colour.toString(16).padStart(6, '0')}`;
    paintShape(context, kind, size, shapes.subarray(at - 2 * count, at));
  }
  context.globalAlpha = 1;
  context.fillStyle = '#222';
  context.font = '12px sans-serif';
  for (const {x, y, text} of labels) context.fillText(text, x + 5, y - 5);
}
