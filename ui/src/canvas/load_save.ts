/** Between the program's JSON and Blockly's workspace; nothing is lost on the way. */
import * as Blockly from 'blockly/core';
import { Catalog } from '../blocks/pack';
import { joinChains, splitChains } from '../model/chains';
import { hideUnknown, showUnknown } from '../model/placeholders';
import { type WorkspaceState, eachBlock } from '../model/program';
import { writeJson } from '../model/json';

export const maxBlocks = 5000;

function deepCopy(state: WorkspaceState): WorkspaceState {
  return JSON.parse(writeJson(state)) as WorkspaceState;
}

function fill(workspace: Blockly.Workspace, state: WorkspaceState, catalog: Catalog): string[] {
  const copy = deepCopy(state);
  const unknown = hideUnknown(copy, catalog);
  splitChains(copy);
  workspace.clear();
  Blockly.serialization.workspaces.load(copy, workspace, { recordUndo: false });
  return unknown;
}

/**
 * Fills the workspace, whatever it held before. Returns the types of block that are not known here. Blockly throws in the
 * middle of a program that it cannot connect: then all its blocks become placeholders, so that nothing of it is lost.
 */
export function loadWorkspace(
  workspace: Blockly.Workspace,
  state: WorkspaceState,
  catalog: Catalog,
): string[] {
  Blockly.Events.disable();
  try {
    return fill(workspace, state, catalog);
  } catch {
    return fill(workspace, state, new Catalog([]));
  } finally {
    Blockly.Events.enable();
  }
}

/** The workspace as it travels and is kept. */
export function saveWorkspace(workspace: Blockly.Workspace): WorkspaceState {
  const state = Blockly.serialization.workspaces.save(workspace) as WorkspaceState;
  joinChains(state);
  showUnknown(state);
  return state;
}

/** Blocks that count towards the robot's limit: shadows do not. */
export function countBlocks(state: WorkspaceState): number {
  const shadowTypes = new Set(['math_number', 'math_angle', 'text']);
  let count = 0;
  for (const block of eachBlock(state)) if (!shadowTypes.has(block.type)) count += 1;
  return count;
}
