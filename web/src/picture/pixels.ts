/** Pixels of the picture along one of the page's: what is as wide as pixels are told counts those of the page. */
export const PIXELS = { value: 1 };
