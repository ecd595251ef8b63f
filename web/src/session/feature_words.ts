/** Features in words of the page's language. */
import type { Lines } from '../logic/features/document';
import type { TreeNode } from '../logic/features/tree';
import { type TextKey } from '../logic/i18n';
import { preferences } from './preferences.svelte';
import { TABLES } from '../logic/i18n';
import { t } from './words.svelte';

/** A word of the server that the page has no text for stays as it is. */
const known = (key: string, otherwise: string): string =>
  key in TABLES[preferences.language] ? t(key as TextKey) : otherwise;

export const feature_words = {
  type_of: (type: string): string => known(`feature.kind-${type}`, type),

  origin_of: (kind: string): string => known(`feature.origin-${kind}`, kind),
  strategy_of: (strategy: string): string => known(`feature.strategy-${strategy}`, strategy),

  id_of: ({ kind, id, layer }: TreeNode): string =>
    kind === 'layer' ? String(layer ?? id.split('/')[1]) : kind === 'group' ? '' : id,

  name_of(node: TreeNode): string {
    const { kind, type, id } = node;
    if (kind === 'group') return t(`feature.group-${id as 'calls' | 'unrecognised'}`);
    if (kind === 'hole') return known(`feature.form-${type}`, type ?? '');
    if (kind === 'pattern') return known(`feature.pattern-${type}`, type ?? '');
    if (type) return this.type_of(type);
    return kind === 'layer' ? t('feature.layer') : '';
  },

  span_of: ([first, last]: Lines): string => (first === last ? String(first) : `${first}–${last}`),

  lines_of(lines: Lines): string {
    const key = lines[0] === lines[1] ? 'feature.one-line' : 'feature.lines';
    return t(key, { lines: this.span_of(lines) });
  },

  doubts_of: ({ doubts }: TreeNode): string =>
    doubts.map((doubt) => known(`reason.${doubt}`, doubt)).join(', '),

  /** 3 × pocket, 12 × hole */
  counted(features: Record<string, number>): string {
    const all = Object.entries(features).filter(([, count]) => count > 0);
    return all.map(([type, count]) => `${count} × ${this.type_of(type)}`).join(', ');
  },
};
