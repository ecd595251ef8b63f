/** One question is under way at a time; of the wishes that come meanwhile the newest is asked next, the others never. */
export class Newest<Wish, Answer> {
  private under_way = false;
  private next: { wish: Wish } | null = null;

  /** `take` is given each answer with the wish that it is for; whether it is the newest one, too. */
  constructor(
    private readonly ask: (wish: Wish) => Promise<Answer>,
    private readonly take: (answer: Answer, wish: Wish, is_newest: boolean) => void,
  ) {}

  get is_busy(): boolean {
    return this.under_way;
  }

  want(wish: Wish): void {
    this.next = { wish };
    if (!this.under_way) void this.go_on();
  }

  /** What waits is not asked any more. */
  forget(): void {
    this.next = null;
  }

  private async go_on(): Promise<void> {
    this.under_way = true;
    while (this.next) {
      const { wish } = this.next;
      this.next = null;
      const answer = await this.ask(wish);
      this.take(answer, wish, this.next === null);
    }
    this.under_way = false;
  }
}
