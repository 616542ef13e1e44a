// SPDX-License-Identifier: Apache-2.0
// Sends values that change fast: one message at a time. When it is answered, only the newest value is sent.

const kPictureTime = 16; // ms; limits messages to one per picture

export class LatestSender {
  private is_sending_ = false;
  private waits_ = false;

  /// `send` sends the newest value at the time of the call.
  constructor(private readonly send_: () => Promise<unknown>) {}

  ask(): void {
    this.waits_ = true;
    void this.run();
  }

  /// Drops the value that waits.
  drop(): void {
    this.waits_ = false;
  }

  private async run(): Promise<void> {
    if (this.is_sending_) return;
    this.is_sending_ = true;
    while (this.waits_) {
      this.waits_ = false;
      await this.send_().catch(() => undefined);
      await new Promise((done) => setTimeout(done, kPictureTime));
    }
    this.is_sending_ = false;
  }
}
