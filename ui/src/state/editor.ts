/** One editor: canvas, project and robot tied together. Made once, after the robot answered. */
import { computed, effect, signal } from '@preact/signals';
import { Catalog } from '../blocks/pack';
import { Canvas } from '../canvas/canvas';
import { countBlocks, maxBlocks } from '../canvas/load_save';
import { FaultMarks, Glow } from '../canvas/marks';
import { answerClicks } from '../canvas/value_bubble';
import { askText } from '../dialogs/ask';
import { type MessageKey, lang, say, t } from '../messages';
import { type Program, eachBlock, inLanguage, makeProgram, readProgram } from '../model/program';
import { type Bytes, onlyProject } from '../model/scratch_file';
import type { Lang } from '../model/words';
import { type OpenedScratch, type Robot, openScratch } from '../wire/api';
import type { Example } from '../wire/protocol';
import { Keeper, emptyProject, lastProject, projectName, recover } from './project';
import { codeWanted, faults, giveCode, noteKey, run, startFaults, telemetry, youDrive } from './robot';
import { type Project, ProjectStore } from './store';

/** Who watches has another program open, maybe one with the same ids. */
const glowing = computed(() =>
  youDrive.value && telemetry.value?.state === 'running' ? telemetry.value.blocks : [],
);

const emptyWorkspace = { blocks: { languageVersion: 0, blocks: [] }, variables: [] };

export class Editor {
  readonly catalog: Catalog;
  readonly canvas: Canvas;
  readonly examples: Example[];
  private readonly keeper: Keeper;
  private readonly faultMarks: FaultMarks;
  private readonly glow: Glow;
  private loading = false;

  private constructor(
    container: HTMLElement,
    robot: Robot,
    readonly store: ProjectStore | null,
  ) {
    this.catalog = new Catalog(robot.packs);
    this.examples = robot.examples;
    this.canvas = new Canvas(container, this.catalog);
    this.keeper = new Keeper(store, () => this.program());
    this.faultMarks = new FaultMarks(this.canvas.workspace);
    this.canvas.onChange(() => {
      if (!this.loading) this.keeper.changed();
    });
    answerClicks(this.canvas.workspace, () => this.program());
    this.glow = new Glow(this.canvas.workspace);
    effect(() => this.glow.show(glowing.value));
    effect(() => this.faultMarks.show(faults.value));
    codeWanted.subscribe((times) => {
      if (times > 0) askText(t('ask_code'), '', () => null, giveCode);
    });
  }

  static async start(container: HTMLElement, robot: Robot): Promise<Editor> {
    const store = await ProjectStore.open().catch(() => null);
    const editor = new Editor(container, robot, store);
    const recovered = store ? await recover(store) : false;
    const last = store ? await lastProject(store) : undefined;
    if (last) editor.show(last);
    else if (editor.examples[0]) await editor.openExample(editor.examples[0]);
    else await editor.newProject();
    if (recovered) noteKey('info', 'recovered');
    return editor;
  }

  get projectId(): string {
    return this.keeper.id;
  }

  /** The program as it stands on the canvas. */
  program(): Program {
    const workspace = this.canvas.save();
    const types = [...eachBlock(workspace)].map((block) => block.type);
    return makeProgram(projectName.peek(), workspace, this.catalog.packsOf(types));
  }

  flag(): void {
    const program = this.program();
    const n = countBlocks(program.workspace);
    if (n > maxBlocks) noteKey('error', 'too_many_blocks', { n, max: maxBlocks });
    else if (!this.canvas.hasStart()) noteKey('warning', n > 0 ? 'no_start' : 'no_blocks');
    else run(program);
  }

  private put(program: Program, project: Project): void {
    this.loading = true;
    startFaults.value = [];
    this.faultMarks.forget();
    const unknown = this.canvas.load(program.workspace);
    this.loading = false;
    this.keeper.adopt(project);
    if (unknown.length > 0) noteKey('warning', 'unknown_blocks');
  }

  private show(project: Project): void {
    const read = readProgram(project.text, project.name);
    if ('program' in read) this.put(read.program, project);
  }

  private async openNew(program: Program, name: string): Promise<void> {
    await this.keeper.flush();
    this.put(program, emptyProject(name));
    this.keeper.changed();
  }

  openExample(example: Example): Promise<void> {
    return this.openNew(inLanguage(example.program, lang.peek()), say(example.name));
  }

  newProject(): Promise<void> {
    return this.openNew(makeProgram('', emptyWorkspace, []), t('untitled'));
  }

  async openProject(id: string): Promise<void> {
    await this.keeper.flush();
    const project = await this.store?.load(id);
    if (project) this.show(project);
  }

  /** Opens the text of a file as a project of its own; a bad one changes nothing. Returns what is wrong with it. */
  async openText(text: string, fileName: string): Promise<MessageKey | null> {
    const read = readProgram(text, fileName.replace(/\.(mirada\.)?json$/i, ''));
    if ('bad' in read) return read.bad;
    await this.openNew(read.program, read.program.name);
    noteKey('info', 'opened_file', { name: read.program.name });
    return null;
  }

  /** Opens a Scratch file as a project of its own; a refused one changes nothing. Returns what there is to say. */
  async openScratch(bytes: Bytes, fileName: string): Promise<string> {
    const opened = await openScratch(onlyProject(bytes)).catch((): OpenedScratch | null => null);
    if (!opened) return t('scratch_no_robot');
    const words = opened.faults.map((fault) => say(fault.message));
    const name = fileName.replace(/\.(sb3|json)$/i, '') || t('untitled');
    const read = readProgram(JSON.stringify(opened.program), name);
    if ('bad' in read) return [t('scratch_refused'), ...words].join(' ');
    await this.openNew({ ...read.program, name }, name);
    return [t('opened_scratch', { name }), ...words].join(' ');
  }

  rename(name: string): void {
    this.keeper.rename(name);
  }

  async removeProject(): Promise<void> {
    const { id } = this.keeper;
    const others = ((await this.store?.list()) ?? []).filter((project) => project.id !== id);
    if (others[0]) await this.openProject(others[0].id);
    else await this.newProject();
    await this.store?.remove(id);
  }

  setLanguage(next: Lang): void {
    if (next === lang.peek()) return;
    lang.value = next;
    localStorage.setItem('mirada.lang', next);
    document.documentElement.lang = next;
    this.loading = true;
    this.faultMarks.forget();
    this.glow.forget();
    this.canvas.translate();
    this.loading = false;
    this.faultMarks.show(faults.peek());
    this.glow.show(glowing.peek());
  }

  /** Brings a block into view and selects it. */
  reveal(blockId: string): void {
    const block = this.canvas.workspace.getBlockById(blockId);
    if (!block) return;
    this.canvas.workspace.centerOnBlock(blockId, true);
    block.select();
  }
}

export const editor = signal<Editor | null>(null);
