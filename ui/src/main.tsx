import { render } from 'preact';
import '@fontsource-variable/nunito/wght.css';
import './styles/tokens.css';
import './styles/controls.css';
import './styles/page.css';
import './styles/stage.css';
import './styles/calibrate.css';
import './styles/faces.css';
import './styles/blocks.css';
import { App } from './app';
import { lang } from './messages';
import { type Lang, languages } from './model/words';
import { Editor, editor } from './state/editor';
import { listenToKeys } from './state/keys';
import { keepPanels } from './state/panels';
import { connect, link, noteKey } from './state/robot';
import { loadRobot } from './wire/api';

const bootWait = 1000;

function chooseLanguage(robotLang: Lang): void {
  const isLang = (code: string | null | undefined): code is Lang => languages.includes(code as Lang);
  const kept = localStorage.getItem('mirada.lang');
  const browser = navigator.languages.map((code) => code.slice(0, 2)).find(isLang);
  lang.value = isLang(kept) ? kept : isLang(robotLang) && robotLang !== 'en' ? robotLang : (browser ?? 'en');
  document.documentElement.lang = lang.value;
}

/** Blockly measures texts: the font must be there before the first block. */
async function fontReady(): Promise<void> {
  await Promise.race([
    Promise.all([
      document.fonts.load('700 16px "Nunito Variable"'),
      document.fonts.load('800 16px "Nunito Variable"'),
    ]),
    new Promise((resolve) => setTimeout(resolve, 2000)),
  ]).catch(() => undefined);
}

async function boot(container: HTMLElement): Promise<void> {
  for (let tries = 0; ; tries++) {
    try {
      const [robot] = await Promise.all([loadRobot(), fontReady()]);
      chooseLanguage(robot.setup.lang);
      editor.value = await Editor.start(container, robot);
      connect(robot.setup);
      keepPanels();
      listenToKeys();
      return;
    } catch (problem) {
      if (editor.peek() || !(problem instanceof TypeError || problem instanceof Error)) throw problem;
      if (tries === 0) noteKey('warning', 'boot_failed');
      link.value = 'lost';
      await new Promise((resolve) => setTimeout(resolve, bootWait));
    }
  }
}

chooseLanguage('en');
render(<App mount={(element) => void boot(element)} />, document.getElementById('app')!);
