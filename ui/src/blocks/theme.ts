import * as Blockly from 'blockly/core';
import { shade, wantsDarkText } from './colour';
import type { Catalog } from './pack';

export const unknownColour = '#9aa1ad';
export const fontFamily = '"Nunito Variable", "Nunito", system-ui, sans-serif';

function styleOf(colour: string, hat: string) {
  return {
    colourPrimary: colour,
    colourSecondary: shade(colour, -0.1),
    colourTertiary: shade(colour, -0.22),
    hat,
  };
}

/** Rules for the packs whose hue is too light for white letters. */
export function textRules(catalog: Catalog): string {
  const light = catalog.packs.filter((pack) => wantsDarkText(pack.colour));
  const styles = light.flatMap((pack) => [CSS.escape(pack.id), `${CSS.escape(pack.id)}_hat`]);
  const fields = ['blocklyLabelField', 'blocklyDropdownField'];
  const rules = styles.flatMap((style) =>
    fields.map((field) => `.blocklyBlock.${style} > .${field} > .blocklyText`),
  );
  return rules.map((rule) => `.mirada-theme ${rule} { fill: #33270a; }`).join('\n');
}

/** Mirada's look of the blocks: zelos, one hue a pack. */
export function makeTheme(catalog: Catalog): Blockly.Theme {
  const blockStyles: Record<string, Blockly.Theme.BlockStyle> = {
    mirada_unknown: styleOf(unknownColour, ''),
    mirada_shadow: {
      colourPrimary: '#ffffff',
      colourSecondary: '#ffffff',
      colourTertiary: '#d5d9e0',
      hat: '',
    },
  };
  const categoryStyles: Record<string, { colour: string }> = {};
  for (const pack of catalog.packs) {
    blockStyles[pack.id] = styleOf(pack.colour, '');
    blockStyles[`${pack.id}_hat`] = styleOf(pack.colour, 'cap');
    categoryStyles[pack.id] = { colour: pack.colour };
  }
  return Blockly.Theme.defineTheme('mirada', {
    name: 'mirada',
    base: Blockly.Themes.Zelos,
    blockStyles,
    categoryStyles,
    fontStyle: { family: fontFamily, weight: '700', size: 11 },
    componentStyles: {
      workspaceBackgroundColour: '#f7f8fa',
      toolboxBackgroundColour: '#ffffff',
      toolboxForegroundColour: '#3a4254',
      flyoutBackgroundColour: '#eef0f4',
      flyoutOpacity: 0.96,
      scrollbarColour: '#c3c8d2',
      scrollbarOpacity: 0.7,
      insertionMarkerColour: '#1f2a44',
      insertionMarkerOpacity: 0.25,
      selectedGlowColour: '#0f8f82',
    },
  });
}
