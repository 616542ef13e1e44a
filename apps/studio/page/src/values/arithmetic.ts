// SPDX-License-Identifier: Apache-2.0
// Evaluates arithmetic in number fields, such as "1/3" or "2*(4+0.5)": sums, products, powers and parentheses over
// plain numbers. Any other text is an expression of the document, which the server reads.

class Arithmetic {
  private at_ = 0;
  private readonly signs_: string[];

  constructor(text: string) {
    this.signs_ = text.match(/\d*\.?\d+(?:[eE][+-]?\d+)?|\d+\.|[-+*/^()]|\S/g) ?? [];
  }

  result(): number {
    const value = this.sum();
    return this.at_ < this.signs_.length ? NaN : value;
  }

  private take(...signs: string[]): string | null {
    const sign = this.signs_[this.at_];
    if (sign === undefined || !signs.includes(sign)) return null;
    this.at_ += 1;
    return sign;
  }

  private sum(): number {
    let value = this.product();
    for (let sign = this.take('+', '-'); sign; sign = this.take('+', '-')) {
      const next = this.product();
      value = sign === '+' ? value + next : value - next;
    }
    return value;
  }

  private product(): number {
    let value = this.signed();
    for (let sign = this.take('*', '/'); sign; sign = this.take('*', '/')) {
      const next = this.signed();
      value = sign === '*' ? value * next : value / next;
    }
    return value;
  }

  private signed(): number {
    if (this.take('-')) return -this.signed();
    if (this.take('+')) return this.signed();
    return this.power();
  }

  private power(): number {
    const base = this.atom();
    return this.take('^') ? base ** this.signed() : base;
  }

  private atom(): number {
    if (this.take('(')) {
      const value = this.sum();
      return this.take(')') ? value : NaN;
    }
    const sign = this.signs_[this.at_];
    this.at_ += 1;
    return sign !== undefined && /\d/.test(sign) ? Number(sign) : NaN;
  }
}

/// Returns the value of the text, or null if it is not arithmetic over plain numbers.
export function calculate(text: string): number | null {
  const value = new Arithmetic(text.trim().replace(/,(?=\d)/g, '.')).result();
  return Number.isFinite(value) ? tidy(value) : null;
}

/// Removes the digits that binary fractions leave: 0.1 + 0.2 gives 0.3.
export function tidy(value: number): number {
  return Number(value.toPrecision(12));
}

/// Rounds a value to the digits that a step of this size needs.
export function rounded(value: number, step: number): number {
  if (!(step > 0)) return tidy(value);
  return tidy(Math.round(value / step) * step);
}

/// Returns a step that divides a range into about `count` parts: 1, 2 or 5 times a power of ten.
export function fitting_step(low: number, high: number, count = 100): number {
  const raw = (high - low) / count;
  if (!(raw > 0)) return 0.01;
  const power = 10 ** Math.floor(Math.log10(raw));
  const share = raw / power;
  return tidy(power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10));
}
