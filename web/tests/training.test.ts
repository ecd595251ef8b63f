import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { TABLES, text_of } from '../src/logic/i18n';
import type { MachineEntry } from '../src/logic/protocol';
import {
  type Criterion,
  KINDS,
  fitting_machine,
  free_name,
  with_score,
  words_of,
} from '../src/logic/training';
import { machine_entry } from './machine_entry';

const machine = (name: string, definition: string, operator: string | null): MachineEntry =>
  machine_entry(name, definition, { operator });

describe('the machine of an exercise', () => {
  const machines = [
    machine('laser', 'laser3', null),
    machine('busy', 'mill3', 'c7'),
    machine('mill', 'mill3', null),
    machine('other', 'mill3', null),
  ];
  it('is the one on the screen where it fits', () => {
    expect(fitting_machine(machines, 'mill3', 'other', 'c1')).toBe('other');
    expect(fitting_machine(machines, 'mill3', 'busy', 'c7')).toBe('busy');
  });
  it('is one that nobody else operates otherwise', () => {
    expect(fitting_machine(machines, 'mill3', 'laser', 'c1')).toBe('mill');
    expect(fitting_machine(machines, 'mill3', 'busy', 'c1')).toBe('mill');
  });
  it('is to be made where none fits', () => {
    expect(fitting_machine(machines, 'laser5', 'mill', 'c1')).toBeNull();
    expect(free_name(machines, 'laser5')).toBe('training-laser5');
    const more = [
      machine('training-laser5', 'laser5', 'c1'),
      machine('training-laser5-2', 'laser5', 'c2'),
    ];
    expect(free_name(more, 'laser5')).toBe('training-laser5-3');
  });
});

describe('what was found', () => {
  const criterion: Criterion = {
    kind: 'all',
    points: 3,
    most: 45,
    met: false,
    finding: 'missing',
    sentence: '',
    values: { mm: 12.5, percent: 40, x: -5, y: 0, z: -0.1234 },
    code: '',
    message: '',
    file: '',
    line: 0,
  };
  const sentence = (c: Criterion, language: 'en' | 'zh-Hant' = 'en') => {
    const { key, values } = words_of(c, language);
    return text_of(language, key, values);
  };
  it('is a sentence with its values', () => {
    expect(sentence(criterion)).toBe(
      '12.5 mm are not cut (40 %), first at X\u22125 Y0 Z\u22120.123.',
    );
    expect(sentence({ ...criterion, met: true, finding: 'well' })).toBe(
      'All that is to be cut is cut.',
    );
  });
  it('has the words of an alarm in the language of the page', () => {
    const alarm: Criterion = {
      ...criterion,
      kind: 'ends',
      finding: 'alarm',
      code: 'PS0112',
      message: 'ZERO DIVIDE',
    };
    expect(sentence(alarm)).toBe('The alarm PS0112 ends the program: ZERO DIVIDE.');
    expect(sentence(alarm, 'zh-Hant')).toMatch(/PS0112.*\p{Script=Han}.*\(ZERO DIVIDE\)/u);
  });

  // The table of the server: { "low-rapid", "A rapid moves …" }.
  const source = readFileSync(join(__dirname, '../../src/training/criterion.cpp'), 'utf8');
  const findings = [...source.matchAll(/\{"([a-z-]+)",\s*"([^"]+)"\}/g)].map((m) => [m[1], m[2]]);
  it('has a text for each finding and kind of the server', () => {
    expect(findings.length).toBe(21);
    const texts: Record<string, string> = TABLES.en;
    for (const [finding, words] of findings) expect(texts[`finding.${finding}`]).toBe(words);
    for (const kind of KINDS) {
      expect(texts[`criterion.${kind}`]).toBeDefined();
      expect(source).toContain(`"${texts[`fulfilled.${kind}`]}"`);
    }
  });
});

it('the exercises are written in traditional characters, too', () => {
  const folder = join(__dirname, '../../exercises');
  const files = readdirSync(folder).filter((file) => file.endsWith('.toml'));
  expect(files.length).toBeGreaterThan(4);
  for (const file of files) {
    const text = readFileSync(join(folder, file), 'utf8');
    expect(text.match(/zh-Hant = .*\n?.*\p{Script=Han}/gu), file).toHaveLength(2);
    expect(
      text.match(/[国学习进设关开这为动态击显输务线错误选择复杂处记录轴执从应]/u),
      file,
    ).toBeNull();
  }
});

it('the best score stays', () => {
  expect(with_score({ a: 40 }, 'a', 30)).toEqual({ a: 40 });
  expect(with_score({ a: 40 }, 'a', 70)).toEqual({ a: 70 });
  expect(with_score({ a: 40 }, 'b', 0)).toEqual({ a: 40, b: 0 });
});
