// What a verdict says, for the room Tank and for a result: which methods decide, and what holds under a record that does not.

import { significant } from './display.js';
import { add, t } from './words.js';

add({
  'check-record-fails': ['Under this record, unreduced and not deciding: {fails} of {count} checks fail{open}.',
    'Unter diesem Beben, nicht abgemindert und nicht entscheidend: {fails} von {count} Nachweisen nicht eingehalten{open}.'],
  'check-record-holds': ['Under this record, unreduced and not deciding: none of {count} checks fails{open}.',
    'Unter diesem Beben, nicht abgemindert und nicht entscheidend: alle {count} Nachweise eingehalten{open}.'],
  'check-record-open': [', {count} open', ', {count} offen'],
  'check-governs': ['Governing: {name} ({method}), utilisation {ratio}.', 'Maßgebend: {name} ({method}), Ausnutzung {ratio}.'],
});

/** Whether a method decides: it does so under one excitation, not under both. */
export const decides = (verdict, method) => verdict?.deciding?.some((one) => one.method === method?.id && one.excitation === method?.excitation) ?? false;

/** What the checks say under a record that does not decide, or an empty text. `method` and `check` give names. */
export function recordSentence(record, method, check) {
  const counts = record?.counts;
  const count = counts ? counts.fails + counts.holds : 0;
  if (!count) return '';
  const { governing } = record;
  const open = counts.not_checked ? t('check-record-open', { count: counts.not_checked }) : '';
  const head = t(counts.fails ? 'check-record-fails' : 'check-record-holds', { fails: counts.fails, count, open });
  if (governing?.check?.utilisation == null) return head;
  const ratio = significant(governing.check.utilisation);
  return `${head} ${t('check-governs', { name: check(governing.check.name), method: method(governing), ratio })}`;
}
