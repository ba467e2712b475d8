'use strict';
// Letters by what they stand for, as visualize/figure/text/typesetting.cpp sets them in figures: variables in italics,
// quantities in colours of their own.

// Letters with the digits, primes and small letters that follow them; neither the s of "it's" nor the e of 1e-8
const NAME =
    /(?<![\p{Script=Latin}\p{Script=Greek}_'’])(?<!\d(?=e[-−+]))[\p{Script=Latin}\p{Script=Greek}_][\p{Script=Latin}\p{Script=Greek}_\d]*[′″₀-ₜ]*/gu;
// Region codes: four binary digits or more, with no other letter or digit beside them
const CODE = /(?<![\p{L}\d._])[01]{4,}(?![\p{L}\d_]|\.\d)/gu;

// What a line should not end in: a short pair of parentheses, what a fraction's stroke or a product's dot joins, and a
// relation
const TORN =
    /(?:[=≈<>≤≥] )?(?:[^\s()]*\((?:[^()]|\([^()]*\)){1,28}\)[^\s()]*|[^\s/·]+(?: ?[/·] ?[^\s/·]+)+)|[=≈<>≤≥] \S+/g;

/** What a trace's names are: `names` as JSON has them. */
class Typesetter {
  constructor({variables = [], quantities = []} = {}, language = document.documentElement.lang) {
    this.variables = new Set(variables);
    this.quantities = new Map(quantities.map(({name}, number) => [name, number]));
    this.coded = new Map(quantities.map(({symbol}, number) => [symbol, number]));
    this.language = language;
  }

  /** English has a word of one letter: the article, where a word follows. */
  isArticle(text, at, name, starts) {
    return this.language === 'en' && name === 'a' && !(at === 0 && starts) && /^ [a-z]/.test(text.slice(at + 1));
  }

  /** The class of what belongs to a quantity, if it has a colour. */
  className(symbol) {
    const number = this.coded.get(symbol);
    return number === undefined ? undefined : `quantity-${number}`;
  }

  /** Whose a code is, by the cells of the table's last rows: where several have it, what was named last. */
  ownerOf(code, values, named) {
    const owners = values.get(code) ?? new Set();
    return owners.size === 1 ? [...owners][0] : owners.has(named) ? named : undefined;
  }

  /** The text as [{text, italic, quantity}]; `values`: the quantities that have a code, by the code. */
  pieces(text, code = false, values = new Map(), starts = values.size > 0) {
    const out = [];
    let from = 0, named;
    const codes = values.size > 0 ? [...text.matchAll(CODE)] : [];
    for (const match of [...text.matchAll(NAME), ...codes].sort((a, b) => a.index - b.index)) {
      const [name] = match, {index} = match;
      const prose = code ? text.slice(text.lastIndexOf('\n', index) + 1, index).includes('//') : true;
      if (prose && this.isArticle(text, index, name, starts)) continue;
      const italic = !code && this.variables.has(name);
      const called = (code ? this.coded : this.quantities).get(name);
      named = called ?? named;
      const quantity = called ?? this.ownerOf(name, values, named);
      if (!italic && quantity === undefined) continue;
      if (index > from) out.push({text: text.slice(from, index)});
      out.push({text: name, italic, quantity});
      from = index + name.length;
    }
    if (from < text.length) out.push({text: text.slice(from)});
    return out;
  }

  /** The same as nodes of HTML. */
  html(text, code = false, values = undefined) {
    return this.pieces(text, code, values).map(({text, italic, quantity}) => {
      if (!italic && quantity === undefined) return text;
      const slant = italic ? 'variable' : '', color = quantity === undefined ? '' : `quantity quantity-${quantity}`;
      return html('span', {class: `${slant} ${color}`.trim()}, text);
    });
  }

  /** A sentence, whose formulas are not broken where that would tear a number or a point apart. */
  sentence(text, values) {
    const whole = text.replace(TORN, (part) => part.replace(/ /g, '\u00a0').replace(/[/·]/g, '\u2060$&\u2060'));
    return this.html(whole, false, values);
  }

  /** The quantities that have a value in these rows, by the value. */
  valuesIn(columns, rows) {
    const values = new Map();
    columns.forEach(({id, quantity}, c) => {
      const number = this.coded.get(quantity ?? id);
      if (number === undefined) return;
      for (const cells of rows) values.set(cells[c], (values.get(cells[c]) ?? new Set()).add(number));
    });
    return values;
  }

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
