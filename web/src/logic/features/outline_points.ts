/** Contours as points that are near enough to be seen as round: for the picture, which has no arcs. */
import { centre, type Element, is_arc, type Point, sweep } from './elements';

const STEP_RAD = Math.PI / 30;

/** Without the last point of a closed one, which is its first. */
export function points_of(elements: readonly Element[], is_closed: boolean): Point[] {
  const points = elements.flatMap(along);
  const last = elements.at(-1);
  return is_closed || !last ? points : [...points, last.to];
}

/** From its beginning on, without its end. */
function along(element: Element): Point[] {
  if (!is_arc(element)) return [element.from];
  const [x, y] = centre(element);
  const angle = sweep(element);
  const steps = Math.max(1, Math.ceil(Math.abs(angle) / STEP_RAD));
  const [dx, dy] = [element.from[0] - x, element.from[1] - y];
  return Array.from({ length: steps }, (_, i): Point => {
    const [sine, cosine] = [Math.sin((angle * i) / steps), Math.cos((angle * i) / steps)];
    return [x + dx * cosine - dy * sine, y + dx * sine + dy * cosine];
  });
}
