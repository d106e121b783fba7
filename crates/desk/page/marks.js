// Vertical lines with a name in a chart: periods of the tank, the strong part of a record.

import { colour } from './dom.js';

/** Draws lines at x (SI) with their names: `marks(chart, [{ x, title }])`, before the chart is first drawn. */
export function marks(chart, lines) {
  const { plot } = chart;
  if (!plot?.hooks || !lines.length) return;
  const factor = chart.state?.xUnit?.factor ?? 1;
  plot.hooks.draw = [...(plot.hooks.draw ?? []), () => {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = colour('--soft');
    ctx.fillStyle = colour('--soft');
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
    ctx.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
    ctx.textBaseline = 'top';
    for (const { x, title } of lines) line(plot, ctx, bbox, x / factor, title);
    ctx.restore();
  }];
}

// The name stands right of its line, or left of it at the edge.
function line(plot, ctx, bbox, x, title) {
  const { min, max } = plot.scales.x;
  if (!(x >= min && x <= max)) return;
  const at = Math.round(plot.valToPos(x, 'x', true));
  const gap = 4 * devicePixelRatio;
  const right = at + gap + ctx.measureText(title).width < bbox.left + bbox.width;
  ctx.textAlign = right ? 'left' : 'right';
  ctx.beginPath();
  ctx.moveTo(at, bbox.top);
  ctx.lineTo(at, bbox.top + bbox.height);
  ctx.stroke();
  ctx.fillText(title, at + (right ? gap : -gap), bbox.top + 2);
}
