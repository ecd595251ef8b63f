/** Whose a variable is. The server says it; where it does not, FANUC's ranges do. */
import type { Variable } from './protocol';

export type VariableScope = 'local' | 'common' | 'permanent' | 'program';

export function scope_of(variable: Variable): VariableScope {
  if (variable.scope) return variable.scope;
  const number = /^#(\d+)$/.exec(variable.name)?.[1];
  if (number === undefined) return 'program';
  if (Number(number) <= 33) return 'local';
  return Number(number) < 500 ? 'common' : 'permanent';
}
