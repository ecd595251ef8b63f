/** Every code of src/base/diagnostic_codes.def in Traditional Chinese: what is wrong; why, and what to do. */
export const ALARMS_ZH_HANT: Record<string, [message: string, cause_and_remedy: string]> = {};
