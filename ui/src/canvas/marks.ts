/** What the running program shows on its blocks: the glow of running ones, and faults in words. */
import * as Blockly from 'blockly/core';
import { say } from '../messages';
import type { Fault } from '../wire/protocol';

const warningId = 'mirada';
const opened = 3;

/** Sets and clears a class on blocks; touches only those that changed. */
export class Glow {
  private lit = new Set<string>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  show(ids: readonly string[]): void {
    const next = new Set(ids);
    for (const id of this.lit) if (!next.has(id)) this.mark(id, false);
    for (const id of next) if (!this.lit.has(id)) this.mark(id, true);
    this.lit = next;
  }

  /** Blocks were made anew: none of them glows. */
  forget(): void {
    this.lit.clear();
  }

  private mark(id: string, on: boolean): void {
    const root = this.workspace.getBlockById(id)?.getSvgRoot();
    if (root) root.classList.toggle('mirada-running', on);
  }
}

/** Shows each fault on its block; bubbles of the first few open by themselves. */
export class FaultMarks {
  private marked = new Map<string, string>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  show(faults: readonly Fault[]): void {
    const wanted = new Map<string, { text: string; error: boolean }>();
    for (const fault of faults) {
      const before = wanted.get(fault.place);
      const words = say(fault.message);
      const text = before && !before.text.includes(words) ? `${before.text}\n${words}` : words;
      wanted.set(fault.place, { text, error: fault.severity === 'error' || Boolean(before?.error) });
    }
    for (const id of [...this.marked.keys()]) if (!wanted.has(id)) this.clear(id);
    let bubbles = 0;
    for (const [id, { text, error }] of wanted) {
      if (this.marked.get(id) === text) continue;
      if (this.mark(id, text, error, bubbles < opened)) bubbles += 1;
    }
  }

  private mark(id: string, text: string, error: boolean, open: boolean): boolean {
    const block = this.workspace.getBlockById(id);
    if (!block) return false;
    this.marked.set(id, text);
    block.setWarningText(text, warningId);
    block.getSvgRoot().classList.toggle('mirada-fault', error);
    if (!open || !error) return false;
    const icon = block.getIcon(Blockly.icons.IconType.WARNING);
    icon?.setBubbleVisible(true).catch(() => undefined);
    return true;
  }

  private clear(id: string): void {
    this.marked.delete(id);
    const block = this.workspace.getBlockById(id);
    if (!block) return;
    block.setWarningText(null, warningId);
    block.getSvgRoot().classList.remove('mirada-fault');
  }

  /** Blocks were made anew: nothing is marked on them any more. */
  forget(): void {
    this.marked.clear();
  }
}
