/** A unified diff as rows: what goes, what comes, and the lines around it with their numbers. */
export interface DiffRow {
  kind: 'same' | 'removed' | 'added' | 'place';
  /** Of the line in the text before, of one that is added in the text behind the edit. */
  line: number | null;
  text: string;
}

const PLACE = /^@@ -(\d+)(?:,\d+)? \+(\d+)(?:,\d+)? @@/;

export function diff_rows(diff: string): DiffRow[] {
  const rows: DiffRow[] = [];
  let [before, behind] = [0, 0];
  for (const line of diff.split('\n')) {
    const place = PLACE.exec(line);
    if (place) {
      [before, behind] = [Number(place[1]), Number(place[2])];
      rows.push({ kind: 'place', line: null, text: line });
    } else if (before > 0 || behind > 0) {
      const row = row_of(line.replace(/\r$/, ''), before, behind);
      if (!row) continue;
      rows.push(row);
      if (row.kind !== 'added') before++;
      if (row.kind !== 'removed') behind++;
    }
  }
  return rows;
}

function row_of(line: string, before: number, behind: number): DiffRow | null {
  const text = line.slice(1);
  if (line[0] === '-') return { kind: 'removed', line: before, text };
  if (line[0] === '+') return { kind: 'added', line: behind, text };
  return line[0] === ' ' ? { kind: 'same', line: before, text } : null;
}
