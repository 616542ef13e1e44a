// SPDX-License-Identifier: Apache-2.0
// Decides when pictures are drawn. Many requests make one picture. A picture waits until the card has finished the
// previous one, so that the user never waits for outdated pictures.

export class PictureQueue {
  private readonly listeners_: (() => void)[] = []; // callbacks that wait until everything is drawn
  private waiting_ = 0; // timer of the next picture; -1: waiting for the card
  private is_drawing_ = false; // true: the card has not finished the last picture
  private is_gone_ = false; // true: nothing is drawn any more

  constructor(
    private readonly context_: WebGL2RenderingContext,
    private readonly draw_: () => void,
  ) {}

  /// Requests a picture.
  ask(): void {
    if (this.waiting_ !== 0 || this.is_gone_) return;
    this.waiting_ = requestAnimationFrame(() => {
      if (this.is_drawing_) {
        this.waiting_ = -1;
        return;
      }
      this.waiting_ = 0;
      this.draw_();
    });
  }

  /// Resolves when everything requested so far is visible.
  drawn(): Promise<void> {
    this.ask();
    return new Promise((resolve) => this.listeners_.push(resolve));
  }

  /// Stops drawing.
  stop(): void {
    this.is_gone_ = true;
  }

  /// Called after a picture's commands were sent. Waits until the card has carried them out.
  watch_card(): void {
    const context = this.context_;
    const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    context.flush();
    this.is_drawing_ = true;
    const look = () => {
      const is_over =
        !fence || context.isContextLost() || context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED;
      if (is_over) this.finish(fence);
      else setTimeout(look, 1);
    };
    setTimeout(look);
  }

  private finish(fence: WebGLSync | null): void {
    this.context_.deleteSync(fence);
    this.is_drawing_ = false;
    if (this.waiting_ === -1) {
      this.waiting_ = 0;
      this.ask();
    } else if (this.waiting_ === 0) {
      for (const tell of this.listeners_.splice(0)) tell();
    }
  }
}
