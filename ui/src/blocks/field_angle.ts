import * as Blockly from 'blockly/core';
import { t } from '../messages';
import { type Dial, makeDial } from './dial';
import { readNumber } from '../model/number';

/** A number with a dial over a robot; any angle can still be typed. */
export class FieldAngle extends Blockly.FieldNumber {
  private dial: Dial | null = null;

  protected override doClassValidation_(value?: string | number): number | null {
    return readNumber(String(value ?? ''));
  }

  protected override showEditor_(event?: Event): void {
    const touch = Blockly.utils.userAgent.MOBILE || Blockly.utils.userAgent.IPAD;
    super.showEditor_(event, touch, false);
    const dial = makeDial(t('dial'), (degrees) => this.setEditorValue_(degrees, false));
    this.dial = dial;
    dial.show(Number(this.getValue()));
    Blockly.DropDownDiv.getContentDiv().appendChild(dial.element);
    Blockly.DropDownDiv.setColour('#ffffff', '#d5d9e0');
    Blockly.DropDownDiv.showPositionedByField(
      this as Blockly.Field,
      () => this.closeDial(),
      undefined,
      false,
    );
  }

  private closeDial(): void {
    this.dial = null;
    Blockly.WidgetDiv.hideIfOwner(this);
  }

  protected override doValueUpdate_(value: number): void {
    super.doValueUpdate_(value);
    this.dial?.show(value);
  }

  /** Called by Blockly for `{"type": "mirada_angle"}`. */
  static override fromJson(options: Blockly.FieldNumberFromJsonConfig): FieldAngle {
    return new FieldAngle(options.value);
  }
}
