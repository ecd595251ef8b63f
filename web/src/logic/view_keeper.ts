/**
 * Whether the picture goes with the path, so that all of it is in sight, or stays as a hand has turned it. Another program
 * begins without what the hand has done; the same one, edited and loaded again, stays as it is seen.
 */
export class ViewKeeper {
  private run = -1;
  private program = '';
  private by_hand = false;

  get goes_with_path(): boolean {
    return !this.by_hand;
  }

  hand(): void {
    this.by_hand = true;
  }

  /** Another machine. */
  forget(): void {
    this.run = -1;
    this.program = '';
  }

  /** Something of this run's path is there. True: for the first time. Without its program's name it is not known yet. */
  arrives(run: number, program: string): boolean {
    if (run === this.run || !program) return false;
    if (program !== this.program) this.by_hand = false;
    this.run = run;
    this.program = program;
    return true;
  }
}
