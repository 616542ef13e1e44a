// SPDX-License-Identifier: Apache-2.0
// When pictures are drawn: asked often, drawn once, and never before the card has finished the last one, so that a hand
// never waits for pictures of what is over.

export class PictureQueue {
  private readonly listeners_: (() => void)[] = []; // who waits until all is drawn
  private waiting_ = 0; // for the next picture; -1: until the card has finished the last
  private is_drawing_ = false; // the card has not finished the last picture
  private is_gone_ = false; // nothing is drawn any more

  constructor(
    private readonly context_: WebGL2RenderingContext,
    private readonly draw_: () => void,
  ) {}

  /// A picture at the next chance.
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

  /// When a person can see what was asked for until now.
  drawn(): Promise<void> {
    this.ask();
    return new Promise((resolve) => this.listeners_.push(resolve));
  }

  /// No further picture is drawn.
  stop(): void {
    this.is_gone_ = true;
  }

  /// Called when a picture's commands have been given: looks when the card has carried them out.
  watch_card(): void {
    const context = this.context_;
    const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    context.flush();
    this.is_drawing_ = true;
    const look = () => {
      const is_over = !fence || context.isContextLost() || context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED;
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
