import * as Blockly from 'blockly/core';
import { useState } from 'preact/hooks';
import {
  type Param,
  type ParamType,
  type Procedure,
  type ProcedureBlock,
  changeProcedure,
  definitionType,
  procedureBlocks,
} from '../blocks/procedure_blocks';
import { type MessageKey, t } from '../messages';
import { newId } from '../model/ids';
import { Dialog, closeDialog, openDialog } from './dialog';

const typeWords: Record<ParamType, MessageKey> = {
  number: 'type_number',
  text: 'type_text',
  boolean: 'type_boolean',
};
const addWords: Record<ParamType, MessageKey> = {
  number: 'add_number',
  text: 'add_text',
  boolean: 'add_boolean',
};

/** What is wrong with it, in words, or null. `others` are the names of the other blocks. */
export function procedureFault(procedure: Procedure, others: string[]): MessageKey | null {
  if (!procedure.name.trim()) return 'block_name_missing';
  if (others.includes(procedure.name.trim())) return 'block_name_taken';
  const names = procedure.params.map((param) => param.name.trim());
  if (names.includes('')) return 'parameter_unnamed';
  return new Set(names).size < names.length ? 'parameter_twice' : null;
}

function freeName(params: Param[]): string {
  const first = t('parameter_first');
  const taken = new Set(params.map((param) => param.name));
  for (let n = 1; ; n++) {
    const name = n === 1 ? first : `${first}${n}`;
    if (!taken.has(name)) return name;
  }
}

function ParamRow({ param, change }: { param: Param; change: (param: Param | null) => void }) {
  return (
    <li class="param-row">
      <span class={`param-type ${param.type}`}>{t(typeWords[param.type])}</span>
      <input
        class="text-input"
        maxLength={40}
        aria-label={t('parameter_name')}
        value={param.name}
        onInput={(event) => change({ ...param, name: event.currentTarget.value })}
      />
      <button
        type="button"
        class="icon-button"
        aria-label={t('remove_parameter', { name: param.name })}
        onClick={() => change(null)}
      >
        ✕
      </button>
    </li>
  );
}

function Preview({ procedure }: { procedure: Procedure }) {
  return (
    <div class={`my-block-preview ${procedure.returns ? 'gives-value' : ''}`}>
      <span>{procedure.name || '…'}</span>
      {procedure.params.map((param) => (
        <span key={param.id} class={`preview-slot ${param.type}`}>
          {param.name}
        </span>
      ))}
    </div>
  );
}

function Check(props: { label: string; on: boolean; change: (on: boolean) => void }) {
  return (
    <label class="check">
      <input
        type="checkbox"
        checked={props.on}
        onChange={(event) => props.change(event.currentTarget.checked)}
      />
      {props.label}
    </label>
  );
}

interface Props {
  start: Procedure;
  others: string[];
  /** A block that is in use keeps its shape: command or reporter. */
  fixedShape: boolean;
  done: (procedure: Procedure) => void;
}

function ProcedureDialog({ start, others, fixedShape, done }: Props) {
  const [procedure, setProcedure] = useState(start);
  const fault = procedureFault(procedure, others);
  const { params } = procedure;
  const setParams = (next: Param[]) => setProcedure({ ...procedure, params: next });
  const changeParam = (index: number) => (param: Param | null) =>
    setParams(params.flatMap((old, i) => (i === index ? (param ? [param] : []) : [old])));
  const submit = (event: Event) => {
    event.preventDefault();
    if (fault) return;
    closeDialog();
    const named = params.map((param) => ({ ...param, name: param.name.trim() }));
    done({ ...procedure, name: procedure.name.trim(), params: named });
  };
  return (
    <Dialog title={t('block_editor')} wide>
      <form onSubmit={submit}>
        <Preview procedure={procedure} />
        <label class="label">
          {t('block_name')}
          <input
            data-first
            class="text-input"
            maxLength={60}
            value={procedure.name}
            onInput={(event) => setProcedure({ ...procedure, name: event.currentTarget.value })}
            onFocus={(event) => event.currentTarget.select()}
          />
        </label>
        <div class="label">{t('parameters')}</div>
        <ul class="params">
          {params.map((param, index) => (
            <ParamRow key={param.id} param={param} change={changeParam(index)} />
          ))}
        </ul>
        <div class="button-row">
          {(['number', 'text', 'boolean'] as const).map((type) => (
            <button
              key={type}
              type="button"
              class="button small"
              onClick={() => setParams([...params, { id: newId(), name: freeName(params), type }])}
            >
              {t(addWords[type])}
            </button>
          ))}
        </div>
        {!fixedShape && (
          <Check
            label={t('gives_value')}
            on={procedure.returns}
            change={(returns) => setProcedure({ ...procedure, returns })}
          />
        )}
        <Check
          label={t('run_at_once')}
          on={procedure.warp}
          change={(warp) => setProcedure({ ...procedure, warp })}
        />
        <p class="field-fault" role="alert">
          {fault && t(fault)}
        </p>
        <footer>
          <button type="button" class="button" onClick={closeDialog}>
            {t('cancel')}
          </button>
          <button type="submit" class="button primary" disabled={fault !== null}>
            {t('ok')}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}

function otherNames(workspace: Blockly.Workspace, but?: string): string[] {
  const all = procedureBlocks(workspace, [definitionType]).map((block) => block.procedure);
  return all.filter((procedure) => procedure.id !== but).map((procedure) => procedure.name);
}

/** Makes a new block: asks, then puts its definition below all scripts. */
export function makeProcedure(workspace: Blockly.WorkspaceSvg): void {
  const start: Procedure = {
    id: newId(),
    name: t('block_name_first'),
    params: [],
    returns: false,
    warp: false,
  };
  const place = (procedure: Procedure) => {
    const there = workspace.getBlocksBoundingBox();
    const state = { type: definitionType, extraState: procedure, x: there.left, y: there.bottom + 48 };
    const block = Blockly.serialization.blocks.append(state, workspace, { recordUndo: true });
    workspace.centerOnBlock(block.id, true);
    workspace.refreshToolboxSelection();
  };
  openDialog.value = (
    <ProcedureDialog start={start} others={otherNames(workspace)} fixedShape={false} done={place} />
  );
}

/** Edits the block of this definition, and all its calls. */
export function editProcedure(workspace: Blockly.WorkspaceSvg, definition: ProcedureBlock): void {
  const { procedure } = definition;
  const others = otherNames(workspace, procedure.id);
  const done = (after: Procedure) => {
    changeProcedure(workspace, definition, after);
    workspace.refreshToolboxSelection();
  };
  openDialog.value = <ProcedureDialog start={procedure} others={others} fixedShape done={done} />;
}
