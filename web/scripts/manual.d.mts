import type { Plugin } from 'vite';

export interface MadePage {
  name: string;
  title: string;
  html: string;
}
export function manual(): Plugin;
export function anchor_of(heading: string): string;
export function target_of(href: string, from: string, names: readonly string[]): string | null;
export function page_of(name: string, text: string, names: readonly string[]): MadePage;
export function pages_of(folder: string): MadePage[];
