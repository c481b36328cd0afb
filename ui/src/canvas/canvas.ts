/** The Blockly workspace of the page: made once, filled, translated in place. */
import { signal } from '@preact/signals';
import * as Blockly from 'blockly/core';
import * as messagesEn from 'blockly/msg/en';
import * as messagesEs from 'blockly/msg/es';
import { useCategories } from '../blocks/category';
import { defineBlocks } from '../blocks/define';
import type { Catalog } from '../blocks/pack';
import { makeTheme, textRules } from '../blocks/theme';
import { makeToolbox, searchContents, serveToolbox } from '../blocks/toolbox';
import { askText, askYes, tell } from '../dialogs/ask';
import { lang, t } from '../messages';
import type { WorkspaceState } from '../model/program';
import { loadWorkspace, saveWorkspace } from './load_save';

const blocklyWords = { en: messagesEn, es: messagesEs };

function useLanguage(catalog: Catalog): void {
  Blockly.setLocale(blocklyWords[lang.peek()] as unknown as Record<string, string>);
  defineBlocks(catalog);
}

function useOwnDialogs(): void {
  Blockly.dialog.setPrompt((question, start, callback) =>
    askText(
      question,
      start,
      () => null,
      callback,
      () => callback(null),
    ),
  );
  Blockly.dialog.setConfirm((question, callback) => askYes(question, t('ok'), callback));
  Blockly.dialog.setAlert((message, callback) => tell(message, callback));
}

export const canUndo = signal(false);
export const canRedo = signal(false);

export class Canvas {
  readonly workspace: Blockly.WorkspaceSvg;
  private readonly catalog: Catalog;
  private changed: () => void = () => undefined;

  constructor(container: HTMLElement, catalog: Catalog) {
    this.catalog = catalog;
    useLanguage(catalog);
    useOwnDialogs();
    useCategories();
    Blockly.Css.register(textRules(catalog));
    this.workspace = Blockly.inject(container, {
      renderer: 'zelos',
      theme: makeTheme(catalog),
      media: '/media/',
      sounds: false,
      toolbox: makeToolbox(catalog),
      trashcan: true,
      comments: true,
      collapse: true,
      disable: true,
      maxInstances: {},
      grid: { spacing: 24, length: 2, colour: '#dfe3ea', snap: false },
      move: { scrollbars: true, drag: true, wheel: true },
      zoom: { controls: true, wheel: false, pinch: true, startScale: 0.8, maxScale: 2, minScale: 0.3 },
    });
    serveToolbox(this.workspace, catalog);
    this.workspace.addChangeListener((event) => {
      this.noteUndo();
      if (!event.isUiEvent && !(event instanceof Blockly.Events.FinishedLoading)) this.changed();
    });
  }

  /** `listener` is called after every change of the program (not for what only changes the view). */
  onChange(listener: () => void): void {
    this.changed = listener;
  }

  save(): WorkspaceState {
    return saveWorkspace(this.workspace);
  }

  /** Whether anything on it can begin: a stack with a hat. */
  hasStart(): boolean {
    const hats = new Set(this.catalog.hats());
    return this.workspace.getTopBlocks(false).some((block) => hats.has(block.type) && block.isEnabled());
  }

  /** Opens another program: undo starts anew, the view goes to its first script. */
  load(state: WorkspaceState): string[] {
    const unknown = loadWorkspace(this.workspace, state, this.catalog);
    this.workspace.clearUndo();
    this.noteUndo();
    this.showStart();
    return unknown;
  }

  /** Makes blocks, toolbox and Blockly's own words anew in the current language; program, undo and view stay. */
  translate(): void {
    const state = this.save();
    const { scrollX, scrollY, scale } = this.workspace;
    this.workspace.getToolbox()?.clearSelection();
    useLanguage(this.catalog);
    this.workspace.updateToolbox(makeToolbox(this.catalog));
    loadWorkspace(this.workspace, state, this.catalog);
    this.workspace.setScale(scale);
    this.workspace.scroll(scrollX, scrollY);
  }

  /** Shows the blocks that have these words; no words: closes the search. */
  search(query: string): void {
    const toolbox = this.workspace.getToolbox() as Blockly.Toolbox | null;
    const flyout = toolbox?.getFlyout();
    toolbox?.clearSelection();
    if (!query.trim()) {
      flyout?.hide();
      return;
    }
    const contents = searchContents(this.workspace, this.catalog, query);
    flyout?.show(contents);
  }

  undo(redo: boolean): void {
    this.workspace.undo(redo);
    this.noteUndo();
  }

  private noteUndo(): void {
    canUndo.value = this.workspace.getUndoStack().length > 0;
    canRedo.value = this.workspace.getRedoStack().length > 0;
  }

  resize(): void {
    Blockly.svgResize(this.workspace);
  }

  private showStart(): void {
    const tops = this.workspace.getTopBlocks(true);
    const first = tops[0];
    if (!first) return;
    const at = first.getRelativeToSurfaceXY();
    const { scale } = this.workspace;
    const room = this.workspace.getMetrics().viewWidth;
    this.workspace.scroll((room > 720 ? 176 : 40) - at.x * scale, 40 - at.y * scale);
  }
}
