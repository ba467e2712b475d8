'use strict';
// Letters by what they stand for, as visualize/figure/typesetting.cpp sets them in figures: variables in italics,
// quantities in colours of their own.

// Letters with the digits, primes and small letters that follow them; neither the s of "it's" nor the e of 1e-8
const NAME =
    /(?<![\p{Script=Latin}\p{Script=Greek}_'’])(?<!\d(?=e[-−+]))[\p{Script=Latin}\p{Script=Greek}_][\p{Script=Latin}\p{Script=Greek}_\d]*[′″₀-ₜ]*/gu;

// What a line should not end in: a short pair of parentheses, and what a fraction's stroke or a product's dot joins
const TORN = /[^\s()]*\((?:[^()]|\([^()]*\)){1,28}\)[^\s()]*|[^\s/·]+(?: ?[/·] ?[^\s/·]+)+/g;

/** What a trace's names are: `names` as JSON has them. */
class Typesetter {
  constructor({variables = [], quantities = []} = {}, language = document.documentElement.lang) {
    this.variables = new Set(variables);
    this.quantities = new Map(quantities.map(({name}, number) => [name, number]));
    this.coded = new Map(quantities.map(({symbol}, number) => [symbol, number]));
    this.language = language;
  }

  /** English has a word of one letter: the article, where a word follows. */
  isArticle(text, at, name) {
    return this.language === 'en' && name === 'a' && at > 0 && /^ [a-z]/.test(text.slice(at + 1));
  }

  /** The text as [{text, italic, quantity}]. */
  pieces(text, code = false) {
    const out = [];
    let from = 0;
    for (const match of text.matchAll(NAME)) {
      const [name] = match, {index} = match;
      const italic = !code && this.variables.has(name) && !this.isArticle(text, index, name);
      const quantity = (code ? this.coded : this.quantities).get(name);
      if (!italic && quantity === undefined) continue;
      if (index > from) out.push({text: text.slice(from, index)});
      out.push({text: name, italic, quantity});
      from = index + name.length;
    }
    if (from < text.length) out.push({text: text.slice(from)});
    return out;
  }

  /** The same as nodes of HTML. */
  html(text, code = false) {
    return this.pieces(text, code).map(({text, italic, quantity}) => {
      if (!italic && quantity === undefined) return text;
      const slant = italic ? 'variable' : '', color = quantity === undefined ? '' : `quantity quantity-${quantity}`;
      return html('span', {class: `${slant} ${color}`.trim()}, text);
    });
  }

  /** A sentence, whose formulas are not broken where that would tear a number or a point apart. */
  sentence(text) { return this.html(text.replace(TORN, (part) => part.replace(/ /g, '\u00a0').replace(/[/·]/g, '\u2060$&\u2060'))); }

  /** The same as nodes of SVG. */
  svg(text) {
    return this.pieces(text).map(({text, italic, quantity}) => {
      if (!italic && quantity === undefined) return text;
      return svg('tspan', {
        'font-style': italic && 'italic',
        style: quantity !== undefined && `fill: var(--quantity-${quantity})`
      }, text);
    });
  }
}
