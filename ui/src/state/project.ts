/** The project that is open: its name, whether it is saved, and the autosave. */
import { signal } from '@preact/signals';
import { t } from '../messages';
import { writeJson } from '../model/json';
import { type Program, readProgram } from '../model/program';
import { noteKey } from './robot';
import { type Project, ProjectStore } from './store';
import { newUuid } from '../model/ids';

export type SaveState = 'saved' | 'saving' | 'failed';

export const projectName = signal('');
export const saveState = signal<SaveState>('saved');

const quiet = 400;
const again = 5000;
const openKey = 'mirada.project';
const rescueKey = 'mirada.rescue';

interface Rescue {
  project: Project;
}

/** Keeps what `program` gives, a moment after the last change, and at once when the page goes away. */
export class Keeper {
  private timer = 0;
  private dirty = false;
  private busy: Promise<void> = Promise.resolve();
  private project: Project;

  constructor(
    private readonly store: ProjectStore | null,
    private readonly program: () => Program,
  ) {
    this.project = emptyProject('');
    const leave = () => this.rescue();
    window.addEventListener('pagehide', leave);
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden) return;
      this.rescue();
      this.flush().catch(() => undefined);
    });
  }

  get id(): string {
    return this.project.id;
  }

  /** From now on the changes belong to this project. */
  adopt(project: Project): void {
    this.project = project;
    this.dirty = false;
    projectName.value = project.name;
    saveState.value = 'saved';
    sessionStorage.setItem(openKey, project.id);
    localStorage.setItem(openKey, project.id);
  }

  changed(): void {
    this.dirty = true;
    saveState.value = 'saving';
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.flush(), quiet);
  }

  rename(name: string): void {
    this.project = { ...this.project, name };
    projectName.value = name;
    this.changed();
  }

  /** Resolves when the newest change is kept. */
  flush(): Promise<void> {
    window.clearTimeout(this.timer);
    this.busy = this.busy.then(() => this.write());
    return this.busy;
  }

  private async write(): Promise<void> {
    if (!this.dirty) return;
    this.dirty = false;
    const before = this.project;
    const next = { ...before, text: writeJson(this.program()) };
    try {
      if (!this.store) throw new Error('no database');
      const kept = await this.store.keep(next, (name) => t('copy_name', { name }));
      if (this.project.id === before.id) this.kept(before, kept);
    } catch {
      this.dirty = true;
      saveState.value = 'failed';
      window.clearTimeout(this.timer);
      this.timer = window.setTimeout(() => void this.flush(), again);
    }
  }

  private kept(before: Project, kept: Project): void {
    this.project = { ...kept, name: kept.id === before.id ? this.project.name : kept.name };
    if (kept.id !== before.id) {
      noteKey('warning', 'other_tab', { name: kept.name });
      sessionStorage.setItem(openKey, kept.id);
      projectName.value = kept.name;
    }
    localStorage.removeItem(rescueKey);
    if (!this.dirty) saveState.value = 'saved';
  }

  /** The page may end before a database write does: leave the work in the synchronous store too. */
  private rescue(): void {
    if (!this.dirty && saveState.peek() === 'saved') return;
    const rescue: Rescue = { project: { ...this.project, text: writeJson(this.program()) } };
    try {
      localStorage.setItem(rescueKey, JSON.stringify(rescue));
    } catch {
      // Too large for that store; the database write that runs at the same time is the way left.
    }
  }
}

export function emptyProject(name: string): Project {
  return { id: newUuid(), name, version: 0, saved_ms: 0, text: '' };
}

function readRescue(text: string): Project | null {
  try {
    const { project } = JSON.parse(text) as Rescue;
    return 'program' in readProgram(project.text, project.name) ? project : null;
  } catch {
    return null;
  }
}

/** What the last page could not finish writing, put where it belongs. True when something was recovered. */
export async function recover(store: ProjectStore): Promise<boolean> {
  const text = localStorage.getItem(rescueKey);
  if (!text) return false;
  localStorage.removeItem(rescueKey);
  const project = readRescue(text);
  if (!project) return false;
  const there = await store.load(project.id);
  if (there?.text === project.text) return false;
  const kept = await store.keep(project, (name) => t('copy_name', { name }));
  sessionStorage.setItem(openKey, kept.id);
  return true;
}

/** The project that this tab, or else this browser, had open last. */
export async function lastProject(store: ProjectStore): Promise<Project | undefined> {
  for (const id of [sessionStorage.getItem(openKey), localStorage.getItem(openKey)]) {
    const project = id ? await store.load(id) : undefined;
    if (project && 'program' in readProgram(project.text, project.name)) return project;
  }
  return undefined;
}
