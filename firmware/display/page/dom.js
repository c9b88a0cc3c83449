// Elements without a library. Text is set as text, never as HTML: nothing from the bus can become markup.
const SVG = 'http://www.w3.org/2000/svg';
export const $ = (id) => document.getElementById(id);

export function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'style') element.style.cssText = value; // as an attribute the page's security policy refuses it
    else element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

export function el(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'onclick') element.addEventListener('click', value);
    else if (value !== false && value !== null) element.setAttribute(key, value === true ? '' : value);
  }
  element.append(...children.filter((c) => c !== null && c !== undefined));
  return element;
}

// Only when it differs: the page is drawn again every second, and a reader's place is kept.
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
