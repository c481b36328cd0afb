/** The languages of the editor, and a text in all of them. */
export const languages = ['en', 'es'] as const;
export type Lang = (typeof languages)[number];
export type Words = Record<Lang, string>;
