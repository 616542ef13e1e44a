// SPDX-License-Identifier: Apache-2.0
// Sends what changes fast: one message at a time, and of all that came while one was answered the newest only.

const kPictureTime = 16; // ms; no more than one message a picture, however fast the hand

export class LatestSender {
  private is_sending_ = false;
  private waits_ = false;

  /// `send` sends what is newest when it is called.
  constructor(private readonly send_: () => Promise<unknown>) {}

  ask(): void {
    this.waits_ = true;
    void this.run();
  }

  /// What waits is not sent any more.
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
