/** Colours of a pack from its one hue. */

function channels(hex: string): [number, number, number] {
  const full = /^#[0-9a-f]{3}$/i.test(hex) ? hex.replace(/[0-9a-f]/gi, '$&$&') : hex;
  const value = Number.parseInt(full.slice(1), 16);
  if (!/^#[0-9a-f]{6}$/i.test(full)) return [128, 128, 128];
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

function toHex(rgb: number[]): string {
  return `#${rgb
    .map((c) =>
      Math.round(Math.min(255, Math.max(0, c)))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;
}

/** Towards black (part < 0) or white (part > 0), by this part of the way. */
export function shade(hex: string, part: number): string {
  const end = part < 0 ? 0 : 255;
  return toHex(channels(hex).map((c) => c + (end - c) * Math.abs(part)));
}

/** Relative luminance, 0 to 1 (WCAG 2). */
function luminance(hex: string): number {
  const [r, g, b] = channels(hex).map((c) => {
    const part = c / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** Whether white letters are hard to read on this colour. */
export function wantsDarkText(hex: string): boolean {
  return 1.05 / (luminance(hex) + 0.05) < 2.25;
}

/** The same colour, see-through. */
export function veil(hex: string, opacity: number): string {
  return `rgba(${channels(hex).join(', ')}, ${opacity})`;
}
