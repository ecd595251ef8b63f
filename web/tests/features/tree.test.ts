import { expect, it } from 'vitest';
import {
  node_at_line,
  node_by_id,
  path_to,
  rows_of,
  tree_of,
  type TreeNode,
} from '../../src/logic/features/tree';
import { region_of } from '../../src/logic/features/region';
import { p1, shaft } from './documents';

const told = (nodes: TreeNode[], level = 0): string[] =>
  nodes.flatMap(({ id, type, facts, children }) => [
    `${' '.repeat(level)}${[id, type, facts].filter(Boolean).join(' ')}`,
    ...told(children, level + 1),
  ]);

it('the tree of P1 has its operations, features with layers, and the holes of a pattern together', () => {
  expect(told(tree_of(p1, 'both'))).toEqual([
    'S1 G54',
    ' O1 T1  S3000',
    '  F1 pocket 40 × 28  Z0…-4',
    '   F1/1 Z-2',
    '   F1/2 Z-4',
    '  F2 outside-profile 30 × 20  Z0…-6',
    '   F2/1 Z-6',
    '  F3 pocket Ø16  Z0…-3',
    '   F3/1 Z-3',
    ' O2 T2  S3000',
    '  P1 line 2',
    '   H1 plain Ø6  X10 Y50  Z0…-12',
    '   H2 plain Ø6  X30 Y50  Z0…-12',
  ]);
});

it('what lies in another feature stands below it, on a lathe too', () => {
  const thread = path_to(tree_of(shaft, 'both'), 'F2').map(({ id }) => id);
  expect(thread).toEqual(['S1', 'O1', 'F1', 'F2']);
});

it('by the rows alone there are layers of loops, and what has no loops is missing', () => {
  expect(told(tree_of(p1, 'literal'))).toEqual([
    'L1 pocket T1',
    ' L1/1 Z-2',
    ' L1/2 Z-4',
    'L2 side-milling T1',
    ' L2/1 Z-6',
    'L3 pocket T1',
    ' L3/1 Z-3',
    'LH1 plain T2  X10 Y50  Z-12',
    'LH2 plain T2  X30 Y50  Z-12',
  ]);
});

it('says what the other method says only where both are asked and differ', () => {
  const differing = structuredClone(p1);
  Object.assign(differing.features[1], { agree: false, literal: { type: 'pocket' } });
  const other = (method: 'both' | 'swept') =>
    node_by_id(tree_of(differing, method), 'F2')?.otherwise;
  expect(other('both')).toBe('pocket');
  expect(other('swept')).toBeUndefined();
  expect(node_by_id(tree_of(p1, 'both'), 'F1')?.otherwise).toBeUndefined();
});

it('a feature that two operations cut has one place', () => {
  const twice = structuredClone(p1);
  twice.operations[1].features = ['F1', ...twice.operations[1].features];
  const all = told(tree_of(twice, 'both')).filter((row) => row.trim().startsWith('F1 '));
  expect(all).toHaveLength(1);
});

it('a line leads to the smallest node that has it', () => {
  const tree = tree_of(p1, 'both');
  const at = (line: number) => node_at_line(tree, line)?.id;
  expect([1, 8, 10, 22, 31, 36, 45, 49, 52].map(at)).toEqual([
    undefined,
    'F1',
    'F1/1',
    'F1/2',
    'F1',
    'F2/1',
    'F3/1',
    'H1',
    'H2',
  ]);
});

it('below a closed node nothing is seen', () => {
  const tree = tree_of(p1, 'both');
  expect(rows_of(tree, new Set())).toHaveLength(13);
  const rows = rows_of(tree, new Set(['O1', 'P1']));
  expect(rows.map(({ node, level, is_open }) => [node.id, level, is_open])).toEqual([
    ['S1', 1, true],
    ['O1', 2, false],
    ['O2', 2, true],
    ['P1', 3, false],
  ]);
});

it('doubts, what was not recognised and calls are told', () => {
  const document = structuredClone(p1);
  document.unrecognised = [{ lines: [60, 75], moves: 14, cut_mm: 31.2, why: 'free-motion' }];
  document.calls = [
    {
      id: 'C1',
      line: 6,
      code: 'G65',
      program: 'O9100',
      arguments: [{ letter: 'R', variable: 18, value: 30, text: '30.', literal: true }],
      features: ['F1'],
    },
  ];
  const tree = tree_of(document, 'both');
  expect(node_by_id(tree, 'C1')).toMatchObject({ facts: 'G65 O9100 R30.', lines: [6, 6] });
  expect(node_by_id(tree, 'U1')).toMatchObject({ facts: '14 · 31.2 mm', doubts: ['free-motion'] });
  expect(node_by_id(tree, 'F2')?.doubts).toEqual(['ring-by-default']);
});

it('the region of a part lies at its bottom where its work system is, holes of a pattern together', () => {
  const moved = structuredClone(p1);
  moved.setups[0].origin = { X: 100, Y: 0, Z: -50 };
  const of = (document: typeof p1, id: string, zero: { x: number; z: number } | null = null) =>
    region_of(document, node_by_id(tree_of(document, 'both'), id)!, zero);
  const pocket = of(moved, 'F1')!;
  expect(pocket.is_closed).toBe(true);
  expect(pocket.outlines[0][0]).toEqual([110, 15, -54]);
  expect(of(moved, 'F1/1')!.outlines[0][0]).toEqual([110, 15, -52]);
  expect(of(p1, 'F2')!.outlines).toHaveLength(2);
  expect(of(p1, 'P1')!.outlines).toHaveLength(2);
  expect(of(p1, 'O1')).toBeNull();
  const half = of(shaft, 'F1', { x: 5, z: 100 })!;
  expect(half).toMatchObject({ is_closed: false });
  expect(half.outlines[0][2]).toEqual([15, 0, 99.234315]);
});
