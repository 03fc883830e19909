// The interactive parts that the lessons show: {lesson, question, picture, part, state}, state with its #.

import { readdirSync, readFileSync } from 'node:fs';

const lessons = new URL('../lessons/', import.meta.url).pathname;
const embedding = /^\[!\[(.+)\]\(\.\.\/figures\/play-([\w-]+)\.png\)\]\(\.\.\/interactive\/(\w+)\.html(#\S*)?\)$/gm;

export function embedded() {
  return readdirSync(lessons).filter((file) => file.endsWith('.md')).flatMap((lesson) =>
    [...readFileSync(lessons + lesson, 'utf8').matchAll(embedding)].map(([, question, picture, part, state = '']) =>
      ({ lesson, question, picture, part, state })));
}
