/** What is wrong with the programs of this page, and the way from one mistake to the next. */
import { count_errors, problem_beside, problems_of, type Problem } from '../logic/problems';
import { verdict_of } from '../logic/stock/part_view';
import { documents } from './documents.svelte';
import { dock } from './dock.svelte';
import { panel } from './panel.svelte';
import { part } from './part.svelte';
import { text_check } from './text_check.svelte';

class Problems {
  list = $derived.by((): Problem[] =>
    problems_of({
      checked: { file: documents.current, found: text_check.found },
      path: panel.path,
      alarm: panel.state.alarm,
      part: part.findings,
      edited: new Set(
        documents.open
          .filter(({ loaded, text }) => loaded !== null && loaded !== text)
          .map(({ name }) => name),
      ),
    }),
  );
  errors = $derived(count_errors(this.list));
  /** One word for the program. */
  verdict = $derived(
    verdict_of({
      has_program: panel.state.program !== '' && panel.path !== null,
      problems: this.list.length,
      is_stale: part.is_stale,
      is_done:
        panel.path?.done === true &&
        text_check.state !== 'under-way' &&
        (!part.is_asked || part.facts.done || part.facts.error !== null),
    }),
  );

  async go_to({ file, line, finding }: Problem): Promise<void> {
    if (finding) return part.go_to(finding);
    if (line <= 0) return;
    if (file !== documents.current) await documents.follow(file);
    documents.go_to(line);
  }

  /** To the next mistake (1) or the one before (-1), as the cursor stands. */
  beside(way: 1 | -1): void {
    const found = problem_beside(this.list, documents.current, documents.cursor, way);
    if (!found) return;
    dock.tab = 'problems';
    void this.go_to(found);
  }
}

export const problems = new Problems();
