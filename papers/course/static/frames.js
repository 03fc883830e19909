// An interactive part tells its height; its frame takes it, so that it needs no scrolling of its own.
addEventListener('message', (event) => {
  const height = event.data?.interactiveHeight;
  if (!(height > 0)) return;
  for (const frame of document.querySelectorAll('iframe.interactive')) {
    if (frame.contentWindow === event.source) frame.style.height = `${height}px`;
  }
});
