import * as Blockly from 'blockly/core';

/** As much of an XML element as Blockly's core touches when it has no page. */
class PlainElement {
  readonly attributes = new Map<string, string>();
  readonly childNodes: unknown[] = [];
  textContent = '';
  id = '';

  constructor(readonly nodeName: string) {}

  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value);
  }

  appendChild(child: unknown): void {
    this.childNodes.push(child);
  }
}

/** Lets Blockly's core work without a browser: it also keeps every shadow as XML. */
export function useNoPage(): void {
  const document = {
    createElementNS: (_space: string, name: string) => new PlainElement(name),
    createTextNode: (text: string) => text,
  };
  class Unused {}
  const dependencies = { document, DOMParser: Unused, XMLSerializer: Unused };
  Blockly.utils.xml.injectDependencies(dependencies as unknown as { document: Document });
}
