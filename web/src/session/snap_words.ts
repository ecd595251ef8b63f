/** What has been snapped to, as a sentence. */
import { kind_of } from '../logic/features/actions';
import { is_arc, length, radius } from '../logic/features/elements';
import { contour_editor } from './contour_editor.svelte';
import { t } from './words.svelte';

/** Empty: nothing is to be said. */
export function snap_words(): string {
  const { mark, finds_nothing } = contour_editor;
  if (!mark) return finds_nothing ? t('snap.nothing') : '';
  const { of } = mark;
  if (!of) return t('snap.on', { what: t(`snap.${mark.kind}`) });
  const name = t(`contour.${kind_of(of)}`, { n: of.id });
  if (mark.kind === 'tangent') return t('snap.on-tangent', { name });
  if (is_arc(of)) return t('snap.on-radius', { name, value: radius(of).toFixed(3) });
  return t('snap.on-length', { name, value: length(of).toFixed(3) });
}
