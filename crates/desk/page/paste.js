// What is pasted from a spreadsheet goes into the cells from the one that has the focus, with a row for each line.

import { childOf, plain } from './jsonc.js';
import { findUnit } from './units.js';

/** The cells of a copied range: lines and tabs, or semicolons where there are no tabs. */
export function cellsOf(text) {
  const lines = text.replace(/\r\n?/g, '\n').replace(/\n+$/, '').split('\n');
  const sign = lines.some((line) => line.includes('\t')) ? '\t' : lines.every((line) => line.includes(';')) ? ';' : '\t';
  return lines.map((line) => line.split(sign).map((cell) => cell.trim()));
}

/** Units of a heading such as `t [mm]`, `thickness (mm)` or `mm`; null where the first line is no heading. */
export function headingUnits(cells) {
  const [first, second] = cells;
  if (!second || first.some((cell) => /^[-+]?[\d.,]+/.test(cell)) || !second.some((cell) => /\d/.test(cell))) return null;
  return first.map((cell) => /[[(]([^\])]+)[\])]\s*$/.exec(cell)?.[1] ?? cell.split(/[\s,]/).at(-1));
}

export async function pasteInto(table, cells, fromRow, fromColumn) {
  const units = headingUnits(cells);
  const lines = units ? cells.slice(1) : cells;
  const columns = table.columns.slice(fromColumn);
  const key = `paste ${Date.now()}`;
  for (const [offset, line] of lines.entries()) {
    const row = fromRow + offset;
    const values = columns.map((column, index) => [column, valueOf(table, column, line[index] ?? '', units?.[index])]).filter(([, value]) => value !== undefined);
    if (row < table.count) {
      for (const [column, value] of values) table.form.put([...table.parts, row, column], value, key);
    } else if (values.length) {
      await table.form.document.working;
      table.form.put([...table.parts, row], newRow(table, values), key);
    }
    await table.form.document.working;
  }
  table.rows[Math.min(fromRow + lines.length, table.rows.length) - 1]?.focus(columns[0]);
}

function valueOf(table, column, text, unit) {
  if (text === '') return undefined;
  const model = table.rows[Math.min(table.count, table.rows.length - 1)].cells.get(column);
  const known = unit && model.field.dimensions && findUnit(unit, model.field.dimensions) ? `1 ${unit}` : '';
  return model.pasted(text, known);
}

// A new row has the material of the row before it where the pasted range has none.
function newRow(table, values) {
  if (!table.leaves) return values.map(([, value]) => value);
  const before = plain(childOf(table.node, table.count - 1)) ?? {};
  const made = Object.fromEntries(values);
  if (table.leaves.includes('material') && made.material === undefined && before.material !== undefined) made.material = before.material;
  return made;
}
