declare module 'virtual:manual' {
  import type { ManualPage } from './logic/manual';
  const pages: ManualPage[];
  export default pages;
}
