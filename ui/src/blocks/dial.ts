/** The dial of an angle: a robot from above; 0 is ahead, right is positive, as blocks say it. */

const size = 176;
const middle = size / 2;
const ring = 72;
const step = 5;
const svgNs = 'http://www.w3.org/2000/svg';

function element(name: string, attributes: Record<string, string | number>, parent: Element): SVGElement {
  const made = document.createElementNS(svgNs, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  parent.appendChild(made);
  return made;
}

/** The angle as the dial shows it: -180 < angle <= 180. */
export function wrapAngle(degrees: number): number {
  const turned = ((degrees % 360) + 360) % 360;
  return turned > 180 ? turned - 360 : turned;
}

/** The angle, rounded to the dial's step, from its middle to a point (x to the right, y down). */
export function angleOfPoint(x: number, y: number): number {
  const degrees = (Math.atan2(x, -y) * 180) / Math.PI;
  return wrapAngle(Math.round(degrees / step) * step);
}

function pointAt(degrees: number, radius: number): { x: number; y: number } {
  const turned = (degrees * Math.PI) / 180;
  return { x: middle + radius * Math.sin(turned), y: middle - radius * Math.cos(turned) };
}

function wedge(degrees: number): string {
  const end = pointAt(degrees, ring);
  const sweep = degrees >= 0 ? 1 : 0;
  return `M ${middle} ${middle} V ${middle - ring} A ${ring} ${ring} 0 ${Math.abs(degrees) > 180 ? 1 : 0} ${sweep} ${end.x} ${end.y} Z`;
}

function drawFace(svg: Element): void {
  for (let degrees = -165; degrees <= 180; degrees += 15) {
    const from = pointAt(degrees, ring);
    const to = pointAt(degrees, degrees % 45 === 0 ? ring - 10 : ring - 5);
    element('line', { x1: from.x, y1: from.y, x2: to.x, y2: to.y, class: 'dial-tick' }, svg);
  }
  for (const degrees of [0, 90, -90, 180]) {
    const { x, y } = pointAt(degrees, ring - 20);
    element('text', { x, y: y + 4, class: 'dial-number' }, svg).textContent = String(degrees);
  }
}

function drawRobot(svg: Element): void {
  const robot = element('g', { class: 'dial-robot', transform: `translate(${middle} ${middle})` }, svg);
  element('rect', { x: -19, y: -11, width: 6, height: 22, rx: 3, class: 'dial-wheel' }, robot);
  element('rect', { x: 13, y: -11, width: 6, height: 22, rx: 3, class: 'dial-wheel' }, robot);
  element('rect', { x: -14, y: -18, width: 28, height: 34, rx: 9 }, robot);
  element('circle', { cx: 0, cy: -9, r: 6, class: 'dial-eye' }, robot);
  element('circle', { cx: 0, cy: -10.5, r: 2.5, class: 'dial-pupil' }, robot);
}

export interface Dial {
  element: SVGElement;
  show(degrees: number): void;
}

/** Builds the dial; `changed` is called while a pointer turns it. */
export function makeDial(label: string, changed: (degrees: number) => void): Dial {
  const svg = document.createElementNS(svgNs, 'svg');
  svg.setAttribute('viewBox', `0 0 ${size} ${size}`);
  svg.setAttribute('class', 'mirada-dial');
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', label);
  element('circle', { cx: middle, cy: middle, r: ring, class: 'dial-ring' }, svg);
  const fan = element('path', { class: 'dial-fan' }, svg);
  drawFace(svg);
  drawRobot(svg);
  const hand = element('line', { x1: middle, y1: middle, class: 'dial-hand' }, svg);
  const knob = element('circle', { r: 9, class: 'dial-knob' }, svg);
  const turn = (event: PointerEvent) => {
    const box = svg.getBoundingClientRect();
    changed(angleOfPoint(event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2));
    event.preventDefault();
  };
  svg.addEventListener('pointerdown', (event) => {
    svg.setPointerCapture(event.pointerId);
    turn(event);
  });
  svg.addEventListener('pointermove', (event) => {
    if (svg.hasPointerCapture(event.pointerId)) turn(event);
  });
  const show = (degrees: number) => {
    const shown = wrapAngle(degrees);
    const end = pointAt(shown, ring);
    fan.setAttribute('d', wedge(shown));
    hand.setAttribute('x2', String(end.x));
    hand.setAttribute('y2', String(end.y));
    knob.setAttribute('cx', String(end.x));
    knob.setAttribute('cy', String(end.y));
  };
  return { element: svg, show };
}
