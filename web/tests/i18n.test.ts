import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { BINDINGS, GROUPS } from '../src/logic/keymap';
import { TABLES, chosen_language, text_of } from '../src/logic/i18n';
import { ALARMS_ZH_HANT } from '../src/logic/i18n/alarms_zh_hant';
import { EDITOR_PHRASES_ZH_HANT } from '../src/logic/i18n/editor_zh_hant';
import { MACHINE_MESSAGES_ZH_HANT, machine_message } from '../src/logic/i18n/machine_messages';
import { MACHINE_TITLES_ZH_HANT, machine_title } from '../src/logic/i18n/machine_titles';
import { refusal_words } from '../src/logic/i18n/refusals';
import { REFUSALS_ZH_HANT } from '../src/logic/i18n/refusals_zh_hant';
import { en } from '../src/logic/i18n/en';
import { en_guide } from '../src/logic/i18n/en_guide';
import { en_setup } from '../src/logic/i18n/en_setup';
import { en_stock } from '../src/logic/i18n/en_stock';
import { en_trust } from '../src/logic/i18n/en_trust';
import { alarm_words } from '../src/logic/i18n/alarms';
import { MODES } from '../src/logic/protocol';

const keys = Object.keys(TABLES.en).sort();
const values_in = (text: string) => [...text.matchAll(/\{\w+\}/g)].map(String).sort();

describe.each(Object.entries(TABLES))('the table %s', (_, table) => {
  it('has every text and no other', () => {
    expect(Object.keys(table).sort()).toEqual(keys);
  });
  it('leaves no text empty and names the same values', () => {
    for (const key of keys) {
      const text = table[key as keyof typeof table];
      expect(text.trim(), key).not.toBe('');
      expect(values_in(text), key).toEqual(values_in(TABLES.en[key as keyof typeof TABLES.en]));
    }
  });
});

it('no text stands in two tables', () => {
  const tables = [en, en_guide, en_setup, en_stock, en_trust].flatMap((table) =>
    Object.keys(table),
  );
  expect(tables.filter((key, i) => tables.indexOf(key) !== i)).toEqual([]);
});

describe('the Chinese table', () => {
  it('is Chinese but for names and units', () => {
    const same = new Set(['mode.mdi', 'tab.mdi', 'speed.axis']);
    for (const key of keys) {
      const text = TABLES['zh-Hant'][key as keyof (typeof TABLES)['zh-Hant']];
      if (!same.has(key)) expect(text, key).toMatch(/\p{Script=Han}/u);
    }
  });
  it('is written in traditional characters', () => {
    const simplified = /[国学习进设关开这为动态击显输务线错误选择复杂处记录轴执从应]/u;
    const text = Object.values(TABLES['zh-Hant']).join('') + JSON.stringify(ALARMS_ZH_HANT);
    expect(text.match(simplified)).toBeNull();
  });
});

describe('texts', () => {
  const sources = readdirSync(join(__dirname, '../src'), { recursive: true })
    .map(String)
    .filter((file) => /\.(svelte|ts)$/.test(file) && !file.includes('i18n'))
    .map((file) => readFileSync(join(__dirname, '../src', file), 'utf8'))
    .join('\n');

  it('are all used somewhere', () => {
    // A key may be put together: `mode.${mode}`.
    const heads = [...sources.matchAll(/`([a-z]+\.(?:[a-z]+-)*)\$\{/g)].map((match) => match[1]);
    const unused = keys.filter(
      (key) => !sources.includes(`'${key}'`) && !heads.some((head) => key.startsWith(head)),
    );
    expect(unused).toEqual([]);
  });
  it('exist for every key of the keyboard, group and mode', () => {
    for (const { command } of BINDINGS) expect(keys).toContain(`command.${command}`);
    for (const group of GROUPS) expect(keys).toContain(`keys.${group}`);
    for (const mode of MODES) expect(keys).toContain(`mode.${mode}`);
  });
});

describe('alarms', () => {
  const codes = [
    ...readFileSync(join(__dirname, '../../src/base/diagnostic_codes.def'), 'utf8').matchAll(
      /^CODE\(\w+, "(\w+)"/gm,
    ),
  ].map((match) => match[1]);

  it('are found in the table of the control', () => expect(codes.length).toBeGreaterThan(100));
  it('each have Chinese words, and no other has', () => {
    expect(Object.keys(ALARMS_ZH_HANT).sort()).toEqual([...new Set(codes)].sort());
  });
  it('have a message, a cause and a remedy, as the control has', () => {
    const remedies = Object.fromEntries(
      [
        ...readFileSync(join(__dirname, '../../src/base/diagnostic_codes.def'), 'utf8').matchAll(
          /^CODE\(\w+, "(\w+)", ".*", ".* \| (.+)"\)/gm,
        ),
      ].map(([, code, remedy]) => [code, remedy]),
    );
    for (const [code, texts] of Object.entries(ALARMS_ZH_HANT)) {
      expect(texts.length, code).toBe(3);
      for (const text of texts) expect(text.trim(), code).not.toBe('');
      expect(remedies[code], code).toBeTruthy();
      expect(texts[1], code).not.toContain(texts[2]);
      const alarm = { code, message: 'M', cause: 'C', remedy: remedies[code] };
      expect(alarm_words('zh-Hant', alarm).remedy, code).toBe(texts[2]);
      expect(alarm_words('en', alarm).remedy, code).toBe(remedies[code]);
    }
  });
  it('keep what the machine says beside the translation', () => {
    const alarm = { code: 'PS0112', message: 'ZERO DIVIDE', cause: 'A divisor is 0.', remedy: '' };
    expect(alarm_words('en', alarm)).toEqual({
      message: 'ZERO DIVIDE',
      cause: 'A divisor is 0.',
      remedy: '',
    });
    expect(alarm_words('zh-Hant', alarm).message).toContain('(ZERO DIVIDE)');
    expect(alarm_words('zh-Hant', { ...alarm, code: 'MC3005' }).message).toBe('ZERO DIVIDE');
  });
});

describe('what others say in English has Chinese words', () => {
  it('the editor', () => {
    const packages = ['commands', 'language', 'lint', 'search', 'view'];
    const said = packages.flatMap((name) => {
      const file = join(__dirname, `../node_modules/@codemirror/${name}/dist/index.js`);
      const source = readFileSync(file, 'utf8');
      return [...source.matchAll(/phrase\((?:view, )?(?:\w+ \? )?"([^"]+)"(?: : "([^"]+)")?/g)];
    });
    const phrases = said.flatMap(([, one, other]) => (other ? [one, other] : [one]));
    expect(phrases.length).toBeGreaterThan(20);
    expect(phrases.filter((phrase) => !(phrase in EDITOR_PHRASES_ZH_HANT))).toEqual([]);
  });
  it('what the machine itself says', () => {
    const room = join(__dirname, '../../src/machine');
    const files = readdirSync(room, { recursive: true })
      .map(String)
      .filter((file) => file.endsWith('.cpp'));
    const said = files.flatMap((file) =>
      [...readFileSync(join(room, file), 'utf8').matchAll(/\bsay\("([^"]+)"\)/g)].map(
        ([, sentence]) => sentence,
      ),
    );
    expect([...new Set(said)].sort()).toEqual(Object.keys(MACHINE_MESSAGES_ZH_HANT).sort());
    expect(machine_message('zh-Hant', 'PART 3 OF 5')).toBe('PART 3 OF 5');
  });
  it('the titles of the built-in machines', () => {
    const folder = join(__dirname, '../../machines');
    const files = readdirSync(folder).filter((file) => file.endsWith('.toml'));
    const titles = files.map(
      (file) => /^description = "(.*)"$/m.exec(readFileSync(join(folder, file), 'utf8'))?.[1] ?? '',
    );
    expect(titles.length).toBeGreaterThan(5);
    expect(titles.filter((title) => !(title in MACHINE_TITLES_ZH_HANT))).toEqual([]);
    expect(machine_title('en', titles[0])).toBe(titles[0]);
    expect(machine_title('zh-Hant', 'my own mill')).toBe('my own mill');
  });
});

describe('refusals', () => {
  const rows = [
    ...readFileSync(join(__dirname, '../../src/base/refusals.def'), 'utf8').matchAll(
      /^REFUSAL\(\w+, "([\w-]+)", "(.+)"\)$/gm,
    ),
  ].map(([, code, sentence]) => ({ code, sentence }));

  it('are found in the table of the control, each code once', () => {
    expect(rows.length).toBeGreaterThan(40);
    expect(new Set(rows.map(({ code }) => code)).size).toBe(rows.length);
  });
  it('each have Chinese words with the same values, and no other has', () => {
    expect(Object.keys(REFUSALS_ZH_HANT).sort()).toEqual(rows.map(({ code }) => code).sort());
    for (const { code, sentence } of rows) {
      expect(values_in(REFUSALS_ZH_HANT[code]), code).toEqual(values_in(sentence));
      expect(REFUSALS_ZH_HANT[code], code).toMatch(/\p{Script=Han}/u);
    }
  });
  it('are said in the language of the page, with their values', () => {
    const late = { command: 'cycle-start', seconds: '15.0', most: '2' };
    expect(refusal_words('zh-Hant', 'said', 'command-late', late)).toBe(
      'cycle-start：15.0 秒前下達；超過 2 秒的指令不執行',
    );
    expect(refusal_words('en', 'said', 'command-late', late)).toBe('said');
    expect(refusal_words('zh-Hant', 'said', 'another', {})).toBe('said');
    expect(refusal_words('zh-Hant', 'said', undefined)).toBe('said');
    const stops = { line: '7', why: 'ZERO DIVIDE', alarm: 'PS0112' };
    expect(refusal_words('zh-Hant', 'said', 'start-alarm', stops)).toBe(
      `到達第 7 行之前：${ALARMS_ZH_HANT.PS0112[0]} (ZERO DIVIDE)`,
    );
  });
});

describe('refusals that stand in the code', () => {
  // What the page never sends: a mistake of who writes another client, or of the command line.
  const OF_OTHER_CLIENTS = [
    'stock_at: nothing is shown; `stock` shows it',
    'stock_probe: nothing is shown; `stock` shows it',
    'load: either `program` or `text` is needed',
    'speeds: `to_s` comes before `from_s`',
    'there is no exercise ',
    'there is no machine ',
    'lines are counted from 1',
    'blocks are skipped by levels 1 to 9',
    'jog: a speed of 0 moves nothing',
    'breakpoints: each has either a line or a variable',
    'a jog by a distance needs one, at most ',
    'this is no number',
    'times of a run begin with 0 s',
    "Kerf does not run the language '",
    '--machine-set ',
    'parameter ',
    '--host ',
    "'#NUMBER=VALUE' is expected",
    'the time of computing is over before the interrupt at ',
  ];
  const sources = ['machine', 'face/server'].flatMap((rooms) => {
    const folder = join(__dirname, '../../src', rooms);
    return readdirSync(folder, { recursive: true })
      .map(String)
      .filter((file) => file.endsWith('.cpp'))
      .map((file) => readFileSync(join(folder, file), 'utf8'));
  });

  it('have a code, so that they have Chinese words', () => {
    const said = sources.flatMap((source) =>
      [...source.matchAll(/(?:\b(?:refused|no)\(|Failure::Kind::usage,)\s*"([^"]+)"/g)].map(
        ([, sentence]) => sentence,
      ),
    );
    expect(said.filter((sentence) => !OF_OTHER_CLIENTS.includes(sentence))).toEqual([]);
    expect(OF_OTHER_CLIENTS.filter((sentence) => !said.includes(sentence))).toEqual([]);
  });
});

it('the browser chooses the language', () => {
  expect(chosen_language(['zh-TW', 'en'])).toBe('zh-Hant');
  expect(chosen_language(['fr', 'en-GB', 'zh'])).toBe('en');
  expect(chosen_language(['de'])).toBe('en');
});

it('values stand where their names do', () => {
  expect(text_of('en', 'top.line', { line: 7 })).toBe('line 7');
  expect(text_of('en', 'top.line')).toBe('line {line}');
});
