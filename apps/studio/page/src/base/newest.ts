// SPDX-License-Identifier: Apache-2.0
// Questions to which only the newest answer counts.

export class Newest {
  private number_ = 0;

  /// Begins a question and makes all earlier ones outdated. Returns a function that tells whether this question is
  /// still the newest.
  begin(): () => boolean {
    this.number_ += 1;
    const number = this.number_;
    return () => number === this.number_;
  }

  /// Makes all open questions outdated.
  drop(): void {
    this.number_ += 1;
  }
}
