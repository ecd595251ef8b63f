/** What the picture is about: where the tip may be, and what of a linkage belongs to a path. */
import { type Box, empty_box, grow, join } from '../logic/box';
import { Kind } from '../logic/chunk';
import { head_pose, joints_of } from '../logic/kinematics';
import { way_of } from '../logic/diameters';
import type { PathPlace, PathStore } from '../logic/path_store';
import type { MachineDefinition } from '../logic/protocol';

const SAMPLES = 64;

/** Where the tip may be: linear axes of the program; what has no travel gets the reach of the linkage. */
export function travel_of(definition: MachineDefinition): Box {
  const box = empty_box();
  const { kinematics } = definition;
  const reach = Number(kinematics.upper_arm ?? 0) + Number(kinematics.forearm ?? 0);
  ['X', 'Y', 'Z'].forEach((name, i) => {
    const axis =
      definition.axes.find((a) => a.name === name) ??
      definition.joints.find((a) => a.name === name);
    const far = definition.lathe ? 0 : reach || radius_of(definition);
    box.min[i] = way_of(axis, axis?.min ?? -far);
    box.max[i] = way_of(axis, axis?.max ?? far);
  });
  return box;
}

function radius_of(definition: MachineDefinition): number {
  const x = definition.joints.find((a) => a.name === 'X');
  return (x?.max ?? 100) + Number(definition.kinematics.x1 ?? 0);
}

/** With the parts of a linkage around it. */
export function with_linkage(
  box: Box,
  definition: MachineDefinition | null,
  store: PathStore,
): Box {
  if (definition?.kinematics.kind === 'arm') {
    join(box, { min: [-30, -30, -30], max: [30, 30, 60] });
  }
  if (definition?.kinematics.kind === 'head-ac') {
    for (const place of cut_places(store)) join(box, head_box(definition, store, place));
  }
  return box;
}

/** Some places of the path while it cuts, evenly over its time. */
function cut_places(store: PathStore): PathPlace[] {
  const places: PathPlace[] = [];
  for (let i = 0; i <= SAMPLES; i++) {
    const place = store.place_at((store.facts.end_s * i) / SAMPLES);
    const chunk = place && store.chunks[place.chunk];
    if (chunk && chunk.kind[Math.min(place.vertex + 1, chunk.vertices - 1)] === Kind.cut)
      places.push(place);
  }
  return places;
}

/** The head from its pivot to its carriage while the tip stands there. */
function head_box(definition: MachineDefinition, store: PathStore, place: PathPlace): Box {
  const [a, c] = store.rotary_at(place) ?? [0, 0];
  const joints = joints_of(definition.kinematics, store.point_at(place), { A: a, C: c }, {});
  const { carriage, pivot } = head_pose(definition.kinematics, joints);
  const around = Number(definition.kinematics.r_a) * 0.35;
  const box = empty_box();
  grow(box, carriage[0] - around, carriage[1] - around, carriage[2]);
  grow(box, carriage[0] + around, carriage[1] + around, carriage[2] + 3 * around);
  grow(box, ...pivot);
  return box;
}
