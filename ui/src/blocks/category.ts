import * as Blockly from 'blockly/core';

/** A category of the toolbox with a dot in its pack's colour. */
class MiradaCategory extends Blockly.ToolboxCategory {
  protected override createIconDom_(): HTMLElement {
    const dot = document.createElement('span');
    dot.className = 'category-dot';
    dot.style.background = this.colour_;
    return dot;
  }

  /** The row's own colours come from the style sheet. */
  override setSelected(isSelected: boolean): void {
    super.setSelected(isSelected);
    if (this.rowDiv_) this.rowDiv_.style.backgroundColor = '';
  }
}

export function useCategories(): void {
  const { TOOLBOX_ITEM } = Blockly.registry.Type;
  Blockly.registry.register(TOOLBOX_ITEM, Blockly.ToolboxCategory.registrationName, MiradaCategory, true);
}
