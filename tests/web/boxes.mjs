// Where things are on the screen, in CSS pixels.
import assert from 'node:assert/strict';

export async function box(locator) {
  const found = await locator.boundingBox();
  assert.ok(found, `${locator} is in sight`);
  return found;
}
export const overlap = (a, b) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
