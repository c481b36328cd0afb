/** Projects in the browser's own database. Every write names the version it builds on: two tabs cannot overwrite each other. */
import { newUuid } from '../model/ids';

export interface Project {
  id: string;
  name: string;
  /** Counts the writes; a write that names another number than the kept one is refused. */
  version: number;
  saved_ms: number;
  /** The program's JSON text. */
  text: string;
}

const databaseName = 'mirada';
const storeName = 'projects';

function asked<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('database request failed'));
  });
}

function done(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onerror = transaction.onabort = () =>
      reject(transaction.error ?? new Error('transaction failed'));
  });
}

export class ProjectStore {
  private constructor(private readonly database: IDBDatabase) {}

  static async open(): Promise<ProjectStore> {
    const request = indexedDB.open(databaseName, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(storeName, { keyPath: 'id' });
    return new ProjectStore(await asked(request));
  }

  async load(id: string): Promise<Project | undefined> {
    const store = this.database.transaction(storeName).objectStore(storeName);
    return (await asked(store.get(id))) as Project | undefined;
  }

  /** All projects, the newest first. */
  async list(): Promise<Project[]> {
    const store = this.database.transaction(storeName).objectStore(storeName);
    const all = (await asked(store.getAll())) as Project[];
    return all.sort((a, b) => b.saved_ms - a.saved_ms);
  }

  async remove(id: string): Promise<void> {
    const transaction = this.database.transaction(storeName, 'readwrite');
    transaction.objectStore(storeName).delete(id);
    await done(transaction);
  }

  /**
   * Keeps the project if the kept one still has `project.version` (0: none must be there). Otherwise another tab wrote
   * meanwhile: the work is kept as a project of its own, named by `otherName`. Returns what was kept.
   */
  async keep(project: Project, otherName: (name: string) => string): Promise<Project> {
    const transaction = this.database.transaction(storeName, 'readwrite');
    const store = transaction.objectStore(storeName);
    const there = (await asked(store.get(project.id))) as Project | undefined;
    const mine = (there?.version ?? 0) === project.version || there === undefined;
    const kept: Project = mine
      ? { ...project, version: project.version + 1, saved_ms: Date.now() }
      : { ...project, id: newUuid(), name: otherName(project.name), version: 1, saved_ms: Date.now() };
    store.put(kept);
    await done(transaction);
    return kept;
  }
}
