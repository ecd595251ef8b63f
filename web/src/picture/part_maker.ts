/**
 * Makes triangles of the part between frames, at a stretch what is quickly done: whoever turns the picture need not wait for
 * them, and frames that show nothing new are not drawn.
 */
import type { StockLayer } from './stock_layer';

const STRETCH_MS = 9;
/** While it takes longer, what is done is shown so often; of all cells, which take longer to draw, when all of it is there. */
const SHOWN_MS = 120;
const MOST_HIDDEN_MS = 1500;

export class PartMaker {
  private timer = 0;
  /** When the last frame was drawn. */
  drawn_at = 0;
  private closed = false;

  /** `show`: something new is there, of a picture that is coarse or not. */
  constructor(
    private readonly stock: StockLayer,
    private readonly show: (coarse: boolean) => void,
  ) {}

  make(coarse: boolean): void {
    clearTimeout(this.timer);
    this.timer = 0;
    if (this.stock.update(STRETCH_MS, coarse)) return;
    this.timer = window.setTimeout(() => {
      if (this.closed) return;
      this.make(coarse);
      const is_whole = !this.timer;
      const most_ms = coarse ? SHOWN_MS : MOST_HIDDEN_MS;
      if (is_whole || performance.now() - this.drawn_at > most_ms) this.show(coarse);
    });
  }

  close(): void {
    this.closed = true;
    clearTimeout(this.timer);
  }
}
