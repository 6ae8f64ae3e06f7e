// Finds passages of the book (bookText, made by make_search.py) that contain all words of a query. The address holds
// the query.
'use strict';
document.addEventListener('DOMContentLoaded', () => {
  const MOST = 50; // passages shown
  const AROUND = 90; // characters shown before and after a word

  const field = Object.assign(document.createElement('input'), {type: 'search', name: 'q', ariaLabel: 'Words to find'});
  const count = document.createElement('p');
  count.setAttribute('role', 'status');
  const list = document.createElement('ul');
  document.getElementById('text_search').append(field, count, list);

  const occurrences = (text, word) => text.toLowerCase().split(word).length - 1;

  function score(passage, words) {
    const each = words.map(word => 5 * occurrences(passage.heading, word) + occurrences(passage.text, word));
    return each.includes(0) ? 0 : each.reduce((sum, one) => sum + one);
  }

  function entry(passage, words) {
    const link = Object.assign(document.createElement('a'), {href: passage.address, textContent: passage.heading});
    const at = Math.max(0, passage.text.toLowerCase().indexOf(words[0]));
    const [begin, end] = [Math.max(0, at - AROUND), at + words[0].length + AROUND];
    const mark = Object.assign(document.createElement('mark'), {textContent: passage.text.substr(at, words[0].length)});
    const item = document.createElement('li');
    item.append(link, ` … ${passage.text.slice(begin, at)}`, mark, `${passage.text.slice(at + words[0].length, end)} …`);
    return item;
  }

  function show() {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = words.length === 0 ? [] : bookText.map(passage => ({passage, score: score(passage, words)}))
        .filter(({score}) => score > 0).sort((a, b) => b.score - a.score);
    list.replaceChildren(...found.slice(0, MOST).map(({passage}) => entry(passage, words)));
    count.textContent = words.length === 0 ? '' : `${found.length} passage${found.length === 1 ? '' : 's'}`;
    try {
      history.replaceState(null, '', `?q=${encodeURIComponent(field.value)}`);
    } catch {
      // A page that is opened from disk may not change its address in every browser.
    }
  }

  field.value = new URLSearchParams(location.search).get('q') ?? '';
  field.addEventListener('input', show);
  if (field.value) show();
  field.focus();
});
