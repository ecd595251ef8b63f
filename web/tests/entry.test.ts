import { describe, expect, it } from 'vitest';
import { doubt_of, entered, longest_travel, travel_of } from '../src/logic/entry';

describe('an entry', () => {
  it('sets the value, or is added to it', () => {
    expect(entered('7', 'input', 12.5)).toBe(7);
    expect(entered('-0.05', '+input', 12.5)).toBe(12.45);
    expect(entered('0.2', '+input', 0.1)).toBe(0.3);
    expect(entered('5', '+input', null)).toBe(5);
  });
  it('that is no number stays none', () => {
    expect(entered('7x', 'input', 1)).toBeUndefined();
    expect(entered('7x', '+input', 1)).toBeUndefined();
    expect(entered('', '+input', 1)).toBeNull();
  });
});

describe('an entry is asked about', () => {
  it('where the axis cannot go so far, either way', () => {
    expect(doubt_of(712.5, 712, 600, 10)).toEqual({ kind: 'beyond', most: 600 });
    expect(doubt_of(-125_000, 0, 600, 10)).toEqual({ kind: 'beyond', most: 600 });
    expect(doubt_of(712.5, 712, null, 10)).toBeNull();
  });
  it('where it is far from what it was', () => {
    expect(doubt_of(312.5, 12.5, 600, 10)).toEqual({ kind: 'far', by: 300 });
    expect(doubt_of(22.5, 12.5, 600, 10)).toBeNull();
    expect(doubt_of(22.501, 12.5, 600, 10)?.kind).toBe('far');
    expect(doubt_of(30, 12.5, 600, 50)).toBeNull();
  });
});

describe('how far', () => {
  const axis = (min: number | null, max: number | null, rotary = false) =>
    ({ name: 'X', min, max, rotary, unit: rotary ? 'deg' : 'mm', program: true }) as const;
  it('an axis goes is its travel, from wherever it is measured', () => {
    expect(travel_of(axis(-300, 300))).toBe(600);
    expect(travel_of(axis(-500, -100))).toBe(500);
    expect(travel_of(axis(null, null, true))).toBeNull();
    expect(travel_of(undefined)).toBeNull();
  });
  it('a tool is long is the longest travel of the linear axes', () => {
    expect(longest_travel([axis(-300, 300), axis(0, 400), axis(0, 5000, true)])).toBe(600);
    expect(longest_travel([axis(null, null)])).toBeNull();
  });
});
