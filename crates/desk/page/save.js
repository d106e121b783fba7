// Files that the page offers to save: tables as CSV, pictures as PNG.

/** Offers a blob as a file. */
export function saveBlob(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Offers columns as CSV: `columns` is `[{head, values}]`, values in SI with full precision and a decimal point. */
export function saveCsv(name, columns) {
  const cell = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const rows = Math.max(...columns.map((column) => column.values.length));
  const lines = [columns.map((column) => cell(column.head)).join(',')];
  for (let i = 0; i < rows; i += 1) {
    lines.push(columns.map(({ values }) => (values[i] === null || values[i] === undefined ? '' : cell(String(values[i])))).join(','));
  }
  saveBlob(name, new Blob([`${lines.join('\n')}\n`], { type: 'text/csv' }));
}

/** Offers a canvas as PNG. */
export function savePng(name, canvas) {
  canvas.toBlob((blob) => blob && saveBlob(name, blob), 'image/png');
}

/** A name for a file, from a title. */
export const fileName = (title, extension) =>
  `${
    title
      .normalize('NFKD')
      .replace(/[^\w.-]+/g, '-')
      .replace(/^-+|-+$/g, '')
      .slice(0, 60) || 'tankcheck'
  }.${extension}`;
