import * as Blockly from 'blockly/core';
import { type MessageKey, t } from '../messages';
import { readNumber } from '../model/number';
import { askNewName, renameVariable } from './names';

export type NameKind = '' | 'list' | 'broadcast_msg';

const newId = 'mirada_new';
const renameId = 'mirada_rename';
const deleteId = 'mirada_delete';

const firstName: Record<NameKind, MessageKey> = {
  '': 'first_variable',
  list: 'first_list',
  broadcast_msg: 'first_message',
};
const newName: Record<NameKind, MessageKey> = {
  '': 'create_variable_menu',
  list: 'create_list_menu',
  broadcast_msg: 'new_message',
};

/** A variable, list or message: its menu also makes, renames and deletes, with our own dialogs. */
export class FieldName extends Blockly.FieldVariable {
  private readonly kind: NameKind;

  constructor(kind: NameKind) {
    super(t(firstName[kind]), undefined, [kind], kind);
    this.kind = kind;
    this.menuGenerator_ = () => this.entries();
  }

  private entries(): Blockly.MenuOption[] {
    const workspace = this.getSourceBlock()?.workspace;
    const map = workspace?.getVariableMap();
    const all = map?.getVariablesOfType(this.kind) ?? [];
    const entries: Blockly.MenuOption[] = all
      .map((variable): [string, string] => [variable.getName(), variable.getId()])
      .sort((a, b) => a[0].localeCompare(b[0]));
    if (!workspace || workspace.isFlyout) return entries.length ? entries : [[this.getText() || ' ', '']];
    const name = this.getText();
    entries.push([t(newName[this.kind]), newId], [t('rename_this', { name }), renameId]);
    if (all.length > 0) entries.push([t('delete_this', { name }), deleteId]);
    return entries;
  }

  protected override onItemSelected_(menu: Blockly.Menu, item: Blockly.MenuItem): void {
    const workspace = this.getSourceBlock()?.workspace as Blockly.WorkspaceSvg | undefined;
    const variable = this.getVariable();
    const chosen = item.getValue();
    if (!workspace || ![newId, renameId, deleteId].includes(chosen ?? '')) {
      super.onItemSelected_(menu, item);
      return;
    }
    if (chosen === newId) askNewName(workspace, this.kind, (id) => this.setValue(id));
    else if (variable && chosen === renameId) renameVariable(workspace, variable);
    else if (variable)
      Blockly.Variables.deleteVariable(workspace, variable, this.getSourceBlock() ?? undefined);
  }
}

/** A number that may also be left empty, as in Scratch. */
export class FieldAmount extends Blockly.FieldNumber {
  protected override doClassValidation_(value?: string | number): number | null {
    return value === '' ? ('' as unknown as number) : readNumber(String(value ?? ''));
  }

  /** Called by Blockly for the field's JSON. */
  static override fromJson(options: Blockly.FieldNumberFromJsonConfig): FieldAmount {
    return new FieldAmount(options.value);
  }
}
