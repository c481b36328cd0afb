import { describe, expect, it } from 'vitest';
import { keyNames, keyOf } from '../src/blocks/keys';
import { cutText } from '../src/blocks/pack';
import { searchBlocks, toolboxBlock } from '../src/blocks/toolbox';
import { shade, wantsDarkText } from '../src/blocks/colour';
import { procedureFault } from '../src/dialogs/procedure_dialog';
import { lang } from '../src/messages';
import { shippedCatalog } from './support';

const catalog = shippedCatalog();

describe('the toolbox', () => {
  it('gives number and angle inputs a shadow with the default', () => {
    const block = catalog.find('vision_obstacle_distance')!.block;
    expect(toolboxBlock(block)).toEqual({
      type: 'vision_obstacle_distance',
      inputs: { ANGLE: { shadow: { type: 'math_angle', fields: { NUM: 30 } } } },
    });
  });

  it('finds blocks by words of their text, without accents', () => {
    const found = (query: string) => searchBlocks(catalog, query).map((block) => block.opcode);
    expect(found('obst dist')).toEqual(expect.arrayContaining(['vision_obstacle_distance', 'memory_known']));
    expect(found('obst dist at')).not.toContain('vision_way_clear');
    lang.value = 'es';
    expect(found('direccion obstaculo')).toContain('vision_nearest_direction');
    lang.value = 'en';
    expect(found('   ')).toEqual([]);
    expect(found('xyzzy')).toEqual([]);
  });

  it('names the packs that a program needs, in the order of the toolbox', () => {
    expect(catalog.packsOf(['motion_turn', 'math_number', 'event_whenflagclicked', 'nope'])).toEqual([
      'events',
      'motion',
    ]);
  });
});

describe('small things', () => {
  it('cuts a sentence at its arguments', () => {
    expect(cutText('if [A] then [B]')).toEqual([
      { text: 'if ' },
      { arg: 'A' },
      { text: ' then ' },
      { arg: 'B' },
    ]);
  });

  it('knows the keys of the browser', () => {
    expect([keyOf(' '), keyOf('ArrowUp'), keyOf('A'), keyOf('7'), keyOf('F5'), keyOf('any')]).toEqual([
      'space',
      'up arrow',
      'a',
      '7',
      null,
      null,
    ]);
    expect(keyNames.length).toBe(7 + 26 + 10);
  });

  it('puts dark letters on light hues only', () => {
    expect([wantsDarkText('#FFBF00'), wantsDarkText('#4C97FF'), wantsDarkText('#9966FF')]).toEqual([
      true,
      false,
      false,
    ]);
    expect(shade('#808080', -0.5)).toBe('#404040');
  });

  it('says what a my block lacks', () => {
    const param = (name: string) => ({ id: name, name, type: 'number' as const });
    const base = { id: 'p', name: 'dance', params: [param('a')], returns: false, warp: false };
    expect(procedureFault(base, [])).toBeNull();
    expect(procedureFault({ ...base, name: ' ' }, [])).toBe('block_name_missing');
    expect(procedureFault(base, ['dance'])).toBe('block_name_taken');
    expect(procedureFault({ ...base, params: [param('a'), param('a')] }, [])).toBe('parameter_twice');
    expect(procedureFault({ ...base, params: [param('')] }, [])).toBe('parameter_unnamed');
  });
});
