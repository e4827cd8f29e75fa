// A button at each block of code that copies it.
for (const block of document.querySelectorAll('pre')) {
  if (!navigator.clipboard) break;
  const button = Object.assign(document.createElement('button'), { textContent: 'Copy', className: 'copy', type: 'button' });
  button.addEventListener('click', async () => {
    await navigator.clipboard.writeText(block.textContent);
    button.textContent = 'Copied';
    setTimeout(() => { button.textContent = 'Copy'; }, 1500);
  });
  block.parentElement.append(button);
}
