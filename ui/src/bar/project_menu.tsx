import { useSignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { askText, askYes, tell } from '../dialogs/ask';
import { say, t } from '../messages';
import { writeJson } from '../model/json';
import { type Editor, editor } from '../state/editor';
import { projectName, saveState } from '../state/project';
import type { Project } from '../state/store';
import { Menu, MenuItem } from './menu';

function download(now: Editor): void {
  const url = URL.createObjectURL(new Blob([writeJson(now.program())], { type: 'application/json' }));
  const anchor = document.createElement('a');
  anchor.href = url;
  anchor.download = `${projectName.peek().replace(/[\\/:*?"<>|]/g, '_') || 'mirada'}.json`;
  anchor.click();
  window.setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

const maxScratchBytes = 200e6;

/** A Scratch project is an archive, or (unpacked) JSON whose first word is its list of targets. */
async function isScratch(file: File): Promise<boolean> {
  if (/\.sb[23]?$/i.test(file.name)) return true;
  const start = await file.slice(0, 64).text();
  return start.startsWith('PK') || /^\s*\{\s*"targets"/.test(start);
}

async function openFile(now: Editor, file: File): Promise<void> {
  if (file.size <= maxScratchBytes && (await isScratch(file))) {
    tell(await now.openScratch(new Uint8Array(await file.arrayBuffer()), file.name));
    return;
  }
  const bad = await now.openText(file.size > 8e6 ? 'x'.repeat(5e6) : await file.text(), file.name);
  if (bad) tell(t(bad));
}

function rename(now: Editor): void {
  askText(
    t('project_name'),
    projectName.peek(),
    () => null,
    (name) => now.rename(name),
  );
}

function remove(now: Editor): void {
  const question = t('delete_project_ask', { name: projectName.peek() });
  askYes(question, t('delete'), (agreed) => {
    if (agreed) void now.removeProject();
  });
}

function Projects({ now, projects, close }: { now: Editor; projects: Project[]; close: () => void }) {
  if (projects.length === 0) return <p class="quiet menu-note">{t('projects_empty')}</p>;
  return (
    <div class="menu-scroll">
      {projects.map((project) => (
        <MenuItem
          key={project.id}
          onClick={() => {
            close();
            void now.openProject(project.id);
          }}
        >
          {project.name}
        </MenuItem>
      ))}
    </div>
  );
}

function SaveMark() {
  const state = saveState.value;
  const words = { saved: t('saved'), saving: t('saving'), failed: t('not_saved') }[state];
  return (
    <span class={`save-state ${state}`} role="status" data-testid="save-state">
      {words}
    </span>
  );
}

export function ProjectMenu() {
  const file = useRef<HTMLInputElement>(null);
  const projects = useSignal<Project[]>([]);
  const now = editor.value;
  const refresh = () => {
    void now?.store?.list().then((all) => {
      projects.value = all.filter((project) => project.id !== now.projectId).slice(0, 30);
    });
  };
  const act = (close: () => void, what: () => void) => () => {
    close();
    what();
  };
  const choose = (accept: string) => {
    if (!file.current) return;
    file.current.accept = accept;
    file.current.click();
  };
  const name = (
    <span class="project-name" data-testid="project-name" onPointerDown={refresh}>
      {projectName.value || t('untitled')} ▾
    </span>
  );
  return (
    <div class="project" onPointerDownCapture={refresh} onKeyDownCapture={refresh}>
      <Menu label={t('project')} buttonClass="button plain" button={name}>
        {(close) =>
          now && (
            <>
              <MenuItem onClick={act(close, () => rename(now))}>{t('rename')}</MenuItem>
              <MenuItem onClick={act(close, () => void now.newProject())}>{t('new_project')}</MenuItem>
              <MenuItem onClick={act(close, () => download(now))}>{t('download')}</MenuItem>
              <MenuItem onClick={act(close, () => choose('.json,application/json'))}>
                {t('open_file')}
              </MenuItem>
              <MenuItem onClick={act(close, () => choose('.sb3,.sb2,.json'))}>{t('open_scratch')}</MenuItem>
              <MenuItem onClick={act(close, () => remove(now))}>{t('delete_project')}</MenuItem>
              <h3>{t('my_projects')}</h3>
              <Projects now={now} projects={projects.value} close={close} />
            </>
          )
        }
      </Menu>
      <SaveMark />
      <input
        ref={file}
        type="file"
        accept=".json,application/json"
        hidden
        aria-label={t('open_file')}
        onChange={(event) => {
          const chosen = event.currentTarget.files?.[0];
          event.currentTarget.value = '';
          if (chosen && now) void openFile(now, chosen);
        }}
      />
    </div>
  );
}

export function ExamplesMenu() {
  const now = editor.value;
  return (
    <Menu label={t('examples')} button={t('examples')} buttonClass="button plain">
      {(close) => (
        <div class="menu-scroll">
          {now?.examples.map((example) => (
            <MenuItem
              key={example.id}
              onClick={() => {
                close();
                void now.openExample(example);
              }}
            >
              {say(example.name)}
            </MenuItem>
          ))}
        </div>
      )}
    </Menu>
  );
}
