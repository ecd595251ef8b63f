/** The exercise that is being done, and what its program was found to be worth. */
import type { OffsetRow } from '../logic/offsets';
import {
  type Assessment,
  type Exercise,
  fitting_machine,
  free_name,
  with_score,
} from '../logic/training';
import { documents } from './documents.svelte';
import { notices } from './notices.svelte';
import { panel } from './panel.svelte';
import { preferences } from './preferences.svelte';
import { setup } from './setup.svelte';
import { slider } from './slider.svelte';
import { t } from './words.svelte';

const AXES = ['X', 'Y', 'Z'];

class Training {
  exercises = $state.raw<Exercise[]>([]);
  /** Its name; empty: the first one. */
  chosen = $state('');
  is_busy = $state(false);
  private found = $state.raw<{ exercise: string; text: string; assessment: Assessment } | null>(
    null,
  );

  get exercise(): Exercise | undefined {
    return this.exercises.find((e) => e.name === this.chosen) ?? this.exercises[0];
  }
  /** The editor has the program of the exercise. */
  get is_open(): boolean {
    return this.exercise !== undefined && documents.current === this.exercise.file;
  }
  get assessment(): Assessment | null {
    return this.found?.exercise === this.exercise?.name ? (this.found?.assessment ?? null) : null;
  }
  /** The text has changed since it was assessed. */
  get is_old(): boolean {
    return this.is_open && this.found?.text !== documents.document?.text;
  }

  async refresh(): Promise<void> {
    const answer = await panel.ask('exercises').catch(() => null);
    if (answer) this.exercises = answer.exercises as Exercise[];
  }

  begin = (): Promise<void> => this.busy((exercise) => this.open(exercise));
  check = (): Promise<void> => this.busy((exercise) => this.assess(exercise));

  /** The text that the exercise begins with; what the library has stays until it is saved. */
  start_over(): void {
    if (!this.exercise || !this.is_open || this.is_busy) return;
    documents.replace(this.exercise.start);
  }

  async go_to(file: string, line: number): Promise<void> {
    if (file !== documents.current) await documents.follow(file);
    documents.go_to(line);
  }

  private async busy(action: (exercise: Exercise) => Promise<void>): Promise<void> {
    if (!this.exercise || this.is_busy) return;
    this.is_busy = true;
    await action(this.exercise).finally(() => (this.is_busy = false));
  }

  private async open(exercise: Exercise): Promise<void> {
    if (!(await this.come_to_machine(exercise.machine))) return;
    await this.set_zero(exercise);
    await documents.refresh();
    if (documents.programs.some((program) => program.name === exercise.file))
      await documents.open_and_load(exercise.file);
    else await documents.create(exercise.file, exercise.start);
    await this.set_up(exercise);
  }

  /** Puts the stock of the exercise on the table, unless somebody has set the program up. */
  private async set_up(exercise: Exercise): Promise<void> {
    if (exercise.set_up === null) return;
    const kept = await panel.ask('stock', {}).catch(() => null);
    if (kept?.is_default !== true) return;
    if (await panel.act('stock', { toml: exercise.set_up })) await setup.refresh();
  }

  private async come_to_machine(definition: string): Promise<boolean> {
    await panel.refresh_machines();
    const fitting = fitting_machine(panel.machines, definition, panel.machine, panel.me);
    if (fitting === panel.machine) {
      if (!panel.operates) await panel.take();
      return true;
    }
    const name = fitting ?? free_name(panel.machines, definition);
    if (fitting === null && !(await panel.act('create', { name, definition }))) return false;
    await turn_to(name);
    notices.say(t('training.at-machine', { name }));
    return panel.machine === name;
  }

  /** Puts G54 where the work of the exercise lies, and says so. */
  private async set_zero(exercise: Exercise): Promise<void> {
    const answer = await panel.act('offsets');
    const rows = (answer?.offsets as OffsetRow[] | undefined) ?? [];
    const moved = AXES.filter((axis, i) => {
      const value = rows.find((row) => row.offset === 'G54' && row.axis === axis)?.value;
      return value !== undefined && value !== exercise.zero_mm[i];
    });
    for (const axis of moved) {
      const value = exercise.zero_mm[AXES.indexOf(axis)];
      if (!(await panel.act('set-offset', { offset: 'G54', axis, value }))) return;
    }
    if (moved.length > 0) notices.say(t('training.zero-set', { axes: moved.join(' ') }));
  }

  private async assess(exercise: Exercise): Promise<void> {
    const text = documents.document?.text;
    if (!this.is_open || text === undefined) return;
    const answer = await panel.act('assess', { exercise: exercise.name, text });
    if (!answer) return;
    const assessment = answer as unknown as Assessment;
    this.found = { exercise: exercise.name, text, assessment };
    preferences.scores = with_score(preferences.scores, exercise.name, assessment.score);
  }
}

/** To another machine, whose program is shown. */
async function turn_to(name: string): Promise<void> {
  slider.now();
  documents.close_all();
  await panel.watch(name);
  await panel.refresh_machines();
  await documents.show_what_is_loaded();
}

export const training = new Training();
