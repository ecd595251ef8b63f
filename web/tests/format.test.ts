import { describe, expect, it } from 'vitest';
import {
  bytes,
  duration,
  fixed,
  position,
  rate,
  thousands,
  typed_number,
  variable,
  volume,
} from '../src/logic/format';

describe('numbers', () => {
  it('have a minus as wide as a digit, and none before zero', () => {
    expect(position(-12.3456)).toBe('\u221212.346');
    expect(position(-0.0004)).toBe('0.000');
    expect(fixed(-0, 2)).toBe('0.00');
  });
  it('that are not known are a dash', () => {
    expect([position(undefined), fixed(NaN, 1), rate(null), duration(undefined)]).toEqual(
      Array(4).fill('\u2013'),
    );
  });
  it('of rates have three digits or are whole', () => {
    expect([0, 0.5123, 12.34, 999.6, 24000].map(rate)).toEqual([
      '0',
      '0.51',
      '12.3',
      '1000',
      '24\u2009000',
    ]);
  });
  it('are grouped from five digits on', () => {
    expect(['1234', '12345', '\u22121234567.5'].map(thousands)).toEqual([
      '1234',
      '12\u2009345',
      '\u22121\u2009234\u2009567.5',
    ]);
  });
});

describe('durations', () => {
  it.each([
    [0, '0:00.0'],
    [3.3998, '0:03.4'],
    [59.96, '1:00.0'],
    [61.2, '1:01.2'],
    [3599.9, '59:59.9'],
    [3600, '1:00:00'],
    [36061, '10:01:01'],
  ])('%d s', (seconds, text) => expect(duration(seconds)).toBe(text));
});

describe('variables', () => {
  it('are written so that they read back, vacant ones empty', () => {
    expect([3, -9.7, 0.1 + 0.2, 1 / 3, 1e12, -0.00006368615, 0].map(variable)).toEqual([
      '3',
      '\u22129.7',
      '0.3',
      '0.333333333',
      '1.000000e+12',
      '\u22126.368615e-5',
      '0',
    ]);
    expect(variable(null)).toBe('');
  });
  it('that are typed may have any minus and a comma', () => {
    expect(['12.5', '\u22123', '-.5', '1,5', '2e3'].map(typed_number)).toEqual([
      12.5, -3, -0.5, 1.5, 2000,
    ]);
    expect(typed_number('  ')).toBeNull();
    expect(['1.2.3', 'x', '--1', '1e'].map(typed_number)).toEqual(Array(4).fill(undefined));
  });
});

it('volumes have the unit that fits', () => {
  expect([0, 4.23456, 999, 1000, 260720].map(volume)).toEqual([
    '0 mm³',
    '4.23 mm³',
    '999 mm³',
    '1.00 cm³',
    '260.72 cm³',
  ]);
});

it('sizes have the unit that fits', () => {
  expect([100, 2048, 3.5 * 1024 * 1024].map(bytes)).toEqual(['100 B', '2.0 KiB', '3.5 MiB']);
});
