/** The picture that the keyboard speaks to; the view sets it while it is there. */
import type { Picture } from '../picture/picture';

export const picture_keys: { picture: Picture | null } = { picture: null };
