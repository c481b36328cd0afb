import * as Blockly from 'blockly/core';
import { askText } from '../dialogs/ask';
import { type MessageKey, t } from '../messages';
import type { NameKind } from './fields';

type Variable = Blockly.IVariableModel<Blockly.IVariableState>;

const question: Record<NameKind, MessageKey> = {
  '': 'ask_variable',
  list: 'ask_list',
  broadcast_msg: 'ask_message',
};

function taken(workspace: Blockly.Workspace, kind: string, name: string, but?: Variable): string | null {
  const other = workspace
    .getVariableMap()
    .getVariablesOfType(kind)
    .find((variable) => variable.getName().toLowerCase() === name.toLowerCase());
  return other && other !== but ? t('name_taken', { name: other.getName() }) : null;
}

/** Asks for a name and makes a variable, list or message of it. */
export function askNewName(
  workspace: Blockly.WorkspaceSvg,
  kind: NameKind,
  done?: (id: string) => void,
): void {
  askText(
    t(question[kind]),
    '',
    (name) => taken(workspace, kind, name),
    (name) => {
      const id = workspace.getVariableMap().createVariable(name, kind).getId();
      done?.(id);
    },
  );
}

export function renameVariable(workspace: Blockly.WorkspaceSvg, variable: Variable): void {
  const old = variable.getName();
  const check = (name: string) => taken(workspace, variable.getType(), name, variable);
  askText(t('ask_rename', { name: old }), old, check, (name) => {
    workspace.getVariableMap().renameVariable(variable, name);
  });
}
