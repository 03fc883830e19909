// The page's beginning: reads the data, builds the viewer, says when it is ready or what is amiss.

import { element } from './dom.js';
import { keys, listen } from './keys.js';
import { loadPage } from './page_data.js';
import { Viewer } from './viewer.js';

function fillHelp() {
  const help = document.getElementById('help');
  help.querySelector('table').append(...keys.map(([key, what]) => element('tr', {},
    element('th', { scope: 'row' }, ...key.split(' ').flatMap((k) => [element('kbd', {}, k), ' '])),
    element('td', {}, what))));
  help.querySelector('button').addEventListener('click', () => help.close());
  // A click beside it closes it too.
  help.addEventListener('click', (event) => {
    if (event.target === help) help.close();
  });
}

async function begin() {
  const message = document.getElementById('message');
  document.documentElement.dataset.begun = '';
  try {
    if (typeof DecompressionStream === 'undefined') {
      throw new Error('this browser is too old to unpack the page (it lacks DecompressionStream)');
    }
    const page = await loadPage(document);
    const viewer = new Viewer(page, document.getElementById('stage'),
      document.getElementById('panel'));
    fillHelp();
    listen(viewer);
    viewer.showTheme();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => viewer.showTheme());
    viewer.stage.drawNow();
    message.remove();
    window.viewer = viewer; // for those who look under the bonnet, and for the tests
    document.documentElement.dataset.ready = Math.round(performance.now());
  } catch (error) {
    message.textContent = `The page cannot be shown: ${error.message}`;
    message.classList.add('failed');
    throw error;
  }
}

begin();
