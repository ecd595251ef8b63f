/** The editor that the keyboard speaks to; the pane sets it while it is there. */
import type { ProgramEditor } from '../editor/program_editor';

export const editor_keys: { editor: ProgramEditor | null } = { editor: null };
