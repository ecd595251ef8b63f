/** From where the camera looks. */
export type ViewName = 'iso' | 'top' | 'front' | 'right';

export type Way = [number, number, number];

/** From the middle of the picture to the camera, and what is up there. */
type Views = Record<ViewName, { from: Way; up: Way }>;

/** How a machine stands in the picture: about what is up it is turned by hand. */
export interface Standing {
  up: Way;
  views: Views;
  /** With which it opens. */
  first: ViewName;
}

export const ON_THE_TABLE: Standing = {
  up: [0, 0, 1],
  views: {
    iso: { from: [-0.62, -1, 0.78], up: [0, 0, 1] },
    top: { from: [0, 0, 1], up: [0, 1, 0] },
    front: { from: [0, -1, 0], up: [0, 0, 1] },
    right: { from: [1, 0, 0], up: [0, 0, 1] },
  },
  first: 'iso',
};

/** Of a lathe: in the front view Z goes to the right and X up, from the right its face is seen. */
export const IN_THE_CHUCK: Standing = {
  up: [1, 0, 0],
  views: {
    iso: { from: [0.62, 1, 0.55], up: [1, 0, 0] },
    top: { from: [1, 0, 0], up: [0, -1, 0] },
    front: { from: [0, 1, 0], up: [1, 0, 0] },
    right: { from: [0, 0, 1], up: [1, 0, 0] },
  },
  first: 'front',
};
