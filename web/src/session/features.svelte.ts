/** What the loaded program machines, as the server recognises it, and which part of that is chosen in tree, picture and text alike. */
import type { Refusal } from '../logic/connection';
import { type FeaturesDocument, type Method } from '../logic/features/document';
import { node_at_line, node_by_id, path_to, rows_of, tree_of } from '../logic/features/tree';
import { dock } from './dock.svelte';
import { documents } from './documents.svelte';
import { panel, said } from './panel.svelte';
import { selection } from './selection.svelte';

class Features {
  document = $state.raw<FeaturesDocument | null>(null);
  /** Of the program that this is known of; another one is told by an event. */
  revision = $state(-1);
  /** Why there is nothing. */
  refused = $state('');
  is_busy = $state(false);
  method = $state<Method>('both');
  /** Nodes whose children are not shown. */
  closed = $state.raw<ReadonlySet<string>>(new Set());
  chosen = $state('');

  tree = $derived(this.document ? tree_of(this.document, this.method) : []);
  rows = $derived(rows_of(this.tree, this.closed));
  node = $derived(node_by_id(this.tree, this.chosen));
  /** Somebody looks at them. */
  is_shown = $derived(dock.tab === 'features');
  /** Lines of the text that are marked, as the machine counts them. */
  range = $derived.by(() => {
    const lines = this.is_shown ? this.node?.lines : null;
    return lines ? { file: panel.state.file, first: lines[0], last: lines[1] } : null;
  });

  private asked = 0;

  /** Asks the server anew. */
  async refresh(): Promise<void> {
    const number = ++this.asked;
    this.is_busy = true;
    const answer = await panel.ask('features').catch((reason: Refusal) => reason);
    if (number !== this.asked) return;
    this.is_busy = false;
    if ('ok' in answer) this.take(answer.features as FeaturesDocument, Number(answer.revision));
    else this.forget(said(answer));
  }

  forget(sentence = ''): void {
    this.document = null;
    this.revision = -1;
    this.refused = sentence;
  }

  /** From the tree: the text goes to its first line. */
  choose(id: string): void {
    this.chosen = id;
    selection.clear();
    const line = this.node?.lines?.[0];
    if (line === undefined) return;
    void this.go_to(line);
  }

  /** From text and picture: the smallest part that this line is of. */
  choose_line(file: string, line: number): void {
    const at = file === panel.state.file ? documents.machine_line(file, line) : null;
    const node = at === null ? null : node_at_line(this.tree, at);
    if (!node) return;
    this.chosen = node.id;
    const above = path_to(this.tree, node.id).map(({ id }) => id);
    this.closed = new Set([...this.closed].filter((id) => !above.includes(id)));
  }

  fold(id: string, is_open: boolean): void {
    const closed = new Set(this.closed);
    if (is_open) closed.delete(id);
    else closed.add(id);
    this.closed = closed;
  }

  private async go_to(line: number): Promise<void> {
    const { file } = panel.state;
    if (file !== documents.current) await documents.follow(file);
    documents.go_to_machine_line(line, false);
  }

  private take(document: FeaturesDocument, revision: number): void {
    this.document = document;
    this.revision = revision;
    this.refused = '';
    if (!this.node) this.chosen = '';
  }
}

export const features = new Features();
