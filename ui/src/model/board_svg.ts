/** A chessboard to print, true to scale: one row and column of squares more than inner corners. */
export function boardSvg(columns: number, rows: number, square_mm: number): string {
  const across = columns + 1;
  const down = rows + 1;
  const squares: string[] = [];
  for (let row = 0; row < down; row++) {
    for (let column = row % 2; column < across; column += 2) {
      squares.push(
        `<rect x="${(column + 1) * square_mm}" y="${(row + 1) * square_mm}" width="${square_mm}" height="${square_mm}"/>`,
      );
    }
  }
  const width = (across + 2) * square_mm;
  const height = (down + 2) * square_mm;
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}mm" height="${height}mm" ` +
    `viewBox="0 0 ${width} ${height}"><rect width="${width}" height="${height}" fill="white"/>` +
    `${squares.join('')}</svg>`
  );
}
