// Answers to "how full", "how thin", "how strong": the server seeks the value, and the answer can be put into the text.

import { fill, h, labelled } from './dom.js';
import { nodeAt, plain } from './jsonc.js';
import { tongue, wording } from './marked.js';
import { parsePath } from './path.js';
import { localised, t } from './words.js';

export class Solver {
  constructor(desk) {
    this.desk = desk;
    this.element = h('div.tank-solved.panel', { hidden: true, role: 'status' });
  }

  buttons() {
    const button = (words, act) => h('button', { type: 'button', onclick: act }, t(words));
    return [button('solve-fill', () => this.solve('fill_height')), button('solve-thickness', () => this.chooseCourse()), button('solve-shaking', () => this.chooseShaking())];
  }

  async chooseCourse() {
    const courses = plain(nodeAt(this.desk.document.root, ['tank', 'courses'])) ?? [];
    if (!courses.length) return void this.desk.say(t('solve-no-course'), 'warning');
    const select = h('select', {}, courses.map((course, index) => h('option', { value: String(index + 1) },
      [`${index + 1}`, course?.height, course?.thickness, course?.material].filter(Boolean).join(' · '))));
    const answer = await this.desk.ask(labelled(t('solve-course'), select), [
      { id: 'go', title: t('solve-go'), kind: 'primary' }, { id: 'cancel', title: t('doc-cancel') },
    ], { title: t('solve-thickness') });
    if (answer === 'go') await this.solve(`thickness:${select.value}`);
  }

  async chooseShaking() {
    const site = plain(nodeAt(this.desk.document.root, ['site'])) ?? {};
    const choices = [['ag', site.ec8?.ag], ['ss', site.api650?.ss]].filter(([, value]) => value !== undefined);
    if (!choices.length) return void this.desk.say(t('solve-no-site'), 'warning');
    if (choices.length === 1) return this.solve(choices[0][0]);
    const answer = await this.desk.ask(t('solve-which'), choices.map(([id]) => ({ id, title: t(`solve-${id}`) })), { title: t('solve-shaking') });
    if (answer) await this.solve(answer);
  }

  async solve(variable) {
    const { document } = this.desk;
    await document.working;
    const text = document.text;
    // The faults stand above the form and at their fields.
    if (document.check?.text === text && document.check.faults?.length) return void this.desk.say(t('solve-faulty'), 'warning');
    this.element.hidden = false;
    fill(this.element, h('p', {}, t('solve-waiting')));
    try {
      const answer = await this.desk.api.post('solve', { ...document.question(text), variable });
      this.show(answer, variable);
    } catch (error) {
      fill(this.element, h('p', {}, error.message), error.help ? h('p.hint', {}, error.help) : null, this.closeButton());
    }
  }

  // The sentence of the page, what the search looked at, and the sentence of the program with its details.
  show(answer, variable) {
    const use = answer.found && answer.text ? h('button.primary', { type: 'button', onclick: () => this.use(answer) }, t('solve-use', { value: localised(String(answer.text)) })) : null;
    const thickness = variable.startsWith('thickness:');
    const name = thickness ? t('solve-found-thickness', { course: variable.split(':')[1] }) : t(`solve-found-${variable}`);
    const first = answer.found ? t('solve-found', { name, value: localised(String(answer.text)) }) : t('solve-none', { name });
    fill(this.element, h('p', {}, h('strong', {}, first)), h('p.hint', {}, [t(this.bySpectrum() ? 'solve-scope' : 'solve-scope-record'), thickness ? t('solve-scope-thickness') : ''].join(' ').trim()),
      h('details', { open: !answer.found || this.desk.settings.language === 'en' }, h('summary', {}, t('solve-details')), h('p', { lang: tongue(answer) }, wording(answer))), h('div.row', {}, use, this.closeButton()));
    (use ?? this.element.querySelector('button')).focus();
  }

  // Without a site the codes decide under the record.
  bySpectrum() {
    const deciding = this.desk.document.check?.results?.verdict?.deciding ?? [];
    return !deciding.length || deciding.some((one) => one.excitation === 'site');
  }

  closeButton() {
    return h('button', { type: 'button', onclick: () => this.clear() }, t('solve-close'));
  }

  async use(answer) {
    const parts = parsePath(answer.path);
    const before = plain(nodeAt(this.desk.document.root, parts));
    const bare = typeof before === 'number' && Number.isFinite(Number(answer.text));
    await this.desk.document.set(parts, bare ? Number(answer.text) : answer.text);
    this.clear();
  }

  clear() {
    this.element.hidden = true;
    this.element.replaceChildren();
  }
}
