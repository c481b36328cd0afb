/** The value of a reporter that was clicked, in a bubble under it. */
import * as Blockly from 'blockly/core';
import { say } from '../messages';
import { makeProgram } from '../model/program';
import type { Program, WorkspaceState } from '../model/program';
import { evaluate } from '../state/robot';
import type { Fault, Value } from '../wire/protocol';

let bubble: HTMLElement | null = null;
let wanted = 0;

function words(value: Value | undefined): string {
  if (typeof value === 'number') return String(Math.round(value * 1000) / 1000);
  return value === undefined || value === null ? '' : String(value);
}

function close(): void {
  bubble?.remove();
  bubble = null;
}

function show(at: DOMRect, answer: { value?: Value; fault?: Fault }): void {
  close();
  bubble = document.createElement('output');
  bubble.className = answer.fault ? 'value-bubble fault' : 'value-bubble';
  bubble.textContent = answer.fault ? say(answer.fault.message) : words(answer.value) || '""';
  document.body.appendChild(bubble);
  const left = at.left + at.width / 2 - bubble.offsetWidth / 2;
  bubble.style.left = `${Math.max(8, Math.min(left, window.innerWidth - bubble.offsetWidth - 8))}px`;
  bubble.style.top = `${at.bottom + 10}px`;
}

/** A reporter in the toolbox is no part of the program: it is asked for in a program of its own. */
function programWith(block: Blockly.Block, program: Program): Program {
  if (!block.isInFlyout) return program;
  const state = Blockly.serialization.blocks.save(block) as unknown as { id: string; type: string };
  const workspace: WorkspaceState = { ...program.workspace, blocks: { languageVersion: 0, blocks: [state] } };
  return makeProgram(program.name, workspace, program.packs);
}

/** Asks for the value whenever a reporter is clicked, on the canvas or in the toolbox. */
export function answerClicks(workspace: Blockly.WorkspaceSvg, program: () => Program): void {
  const clicked = (event: Blockly.Events.Abstract) => {
    if (!(event instanceof Blockly.Events.Click)) return;
    close();
    wanted += 1;
    const click = event;
    const home = click.workspaceId ? Blockly.common.getWorkspaceById(click.workspaceId) : null;
    const block = click.blockId ? (home?.getBlockById(click.blockId) as Blockly.BlockSvg | null) : null;
    if (click.targetType !== Blockly.Events.ClickTarget.BLOCK || !block?.outputConnection || block.isShadow())
      return;
    const mine = wanted;
    void evaluate(programWith(block, program()), block.id).then((answer) => {
      if (mine !== wanted || block.disposed) return;
      show(block.pathObject.svgPath.getBoundingClientRect(), answer);
    });
  };
  workspace.addChangeListener(clicked);
  workspace.getFlyout()?.getWorkspace().addChangeListener(clicked);
  document.addEventListener('pointerdown', close, true);
  document.addEventListener('wheel', close, { capture: true, passive: true });
}
