// A link to every heading and figure, for citing it.
'use strict';
document.addEventListener('DOMContentLoaded', () => {
  const add = (place, id, what) => {
    const link = document.createElement('a');
    Object.assign(link, {className: 'permalink', href: `#${id}`, textContent: '#', ariaLabel: `Link to this ${what}`});
    place.append(' ', link);
  };
  for (const anchor of document.querySelectorAll('.contents :is(h1, h2, h3) > a.anchor')) {
    add(anchor.parentElement, anchor.id, 'section');
  }
  for (const figure of document.querySelectorAll('.contents figure[id]')) {
    add(figure.querySelector('figcaption'), figure.id, 'figure');
  }
});
