// SPDX-License-Identifier: Apache-2.0
// Questions of which the newest answer counts.

export class Newest {
  private number_ = 0;

  /// Answers to all questions before count no more. Gives whether one to a question that is asked now does.
  begin(): () => boolean {
    this.number_ += 1;
    const number = this.number_;
    return () => number === this.number_;
  }

  /// No answer that is awaited counts.
  drop(): void {
    this.number_ += 1;
  }
}
