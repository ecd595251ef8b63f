/** The line whose path stands out, in editor and picture alike. */

class Selection {
  place = $state.raw<{ file: string; line: number } | null>(null);

  choose(file: string, line: number): void {
    if (this.place?.file === file && this.place.line === line) return;
    this.place = { file, line };
  }
  clear(): void {
    this.place = null;
  }
}

export const selection = new Selection();
