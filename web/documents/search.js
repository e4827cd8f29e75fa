// The contents of a page are closed where they stand before its text. The search of the documents loads its index with the
// first letter, as a script: pages open from the file system.
if (innerWidth < 1150) document.querySelector('.contents details')?.removeAttribute('open');
{
  const form = document.getElementById('search');
  const up = document.querySelector('footer a').getAttribute('href').replace('README.html', '');
  let loading = null;
  const load = () => loading ??= new Promise((resolve) => {
    document.head.append(Object.assign(document.createElement('script'), { src: `${up}docs/search-index.js`, onload: resolve }));
  });
  /// Each word must begin a word of the section; headings count more.
  const found = (text) => {
    const words = text.toLowerCase().match(/[a-z0-9_]{2,}/g) ?? [];
    const begins = (all, word) => ` ${all}`.includes(` ${word}`);
    return words.length === 0 ? [] : window.restripIndex.filter(([, , , , all]) => words.every((word) => begins(all, word)))
      .map((row) => ({ row, rank: (row[0].startsWith('docs/') ? 1 : 0) + words.filter((word) => begins(row[3].toLowerCase(), word)).length * 2 + words.filter((word) => begins(row[1].toLowerCase(), word)).length }))
      .sort((one, other) => other.rank - one.rank).slice(0, 8).map(({ row }) => row);
  };
  const show = async () => {
    await load();
    const rows = found(form.words.value).map(([page, title, anchor, heading]) => {
      const link = Object.assign(document.createElement('a'), { href: `${up}${page}#${anchor}`, textContent: heading === title ? title : `${title}: ${heading}` });
      const row = document.createElement('li');
      row.append(link);
      return row;
    });
    if (rows.length === 0 && form.words.value.trim().length > 1) rows.push(Object.assign(document.createElement('li'), { textContent: 'Nothing was found.' }));
    document.getElementById('found').replaceChildren(...rows);
  };
  if (form) {
    form.hidden = false;
    form.words.addEventListener('input', show);
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      document.querySelector('#found a')?.click();
    });
  }
}
