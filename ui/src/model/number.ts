/**
 * A number as people type it, in either language: a comma or a point before the decimals, points, commas or spaces
 * between the thousands. Null when it is none, or too large to be kept.
 */
export function readNumber(typed: string): number | null {
  let text = typed.replace(/\s/g, '').replace(/o/gi, '0');
  const decimal = text.lastIndexOf(',') > text.lastIndexOf('.') ? ',' : '.';
  const other = decimal === ',' ? '.' : ',';
  text = text.replaceAll(other, '');
  const places = text.split(decimal);
  text = places.length > 2 ? places.join('') : places.join('.');
  if (text === '') return typed.trim() === '' ? 0 : null;
  const number = Number(text);
  return Number.isFinite(number) ? number : null;
}
