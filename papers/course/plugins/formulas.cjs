// Reads formulas, one JSON object {tex, display} a line, and prints each as KaTeX's HTML, in JSON.

const katex = require('katex');
const lines = require('readline').createInterface({ input: process.stdin });

lines.on('line', (line) => {
  const { tex, display } = JSON.parse(line);
  try {
    const html = katex.renderToString(tex, { displayMode: display, strict: 'error' });
    console.log(JSON.stringify({ html }));
  } catch (error) {
    console.log(JSON.stringify({ error: error.message }));
  }
});
