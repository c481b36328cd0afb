/** Fits a canvas to its place on the page in device pixels; the pen then works in CSS pixels. */
export function sharpPen(
  canvas: HTMLCanvasElement,
): { pen: CanvasRenderingContext2D; w: number; h: number } | null {
  const w = canvas.clientWidth;
  const h = canvas.clientHeight;
  const ratio = window.devicePixelRatio || 1;
  const pen = canvas.getContext('2d');
  if (!pen || w === 0 || h === 0) return null;
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio)) {
    canvas.width = Math.round(w * ratio);
    canvas.height = Math.round(h * ratio);
  }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { pen, w, h };
}
