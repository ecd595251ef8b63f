/** From where the camera looks. */
export type ViewName = 'iso' | 'top' | 'front' | 'right';

/** From the middle of the picture to the camera, and what is up there. */
export const VIEWS: Record<
  ViewName,
  { from: [number, number, number]; up: [number, number, number] }
> = {
  iso: { from: [-0.62, -1, 0.78], up: [0, 0, 1] },
  top: { from: [0, 0, 1], up: [0, 1, 0] },
  front: { from: [0, -1, 0], up: [0, 0, 1] },
  right: { from: [1, 0, 0], up: [0, 0, 1] },
};
