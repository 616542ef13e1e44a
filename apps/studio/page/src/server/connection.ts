// SPDX-License-Identifier: Apache-2.0
// The WebSocket of the page: requests with their answers, messages, scene packets. It connects again if the connection
// is lost.
import type { PacketArrays } from './packet.ts';
import { is_answer, read_packed } from './packet.ts';
import type { News } from './protocol.ts';
import { Refusal } from './protocol.ts';

type Answer = { is: string; re?: number; message?: string; limit?: string; arrays?: PacketArrays };
type Waiting = { resolve: (answer: never) => void; reject: (fault: Error) => void };

export interface Listener {
  /// Called after the server's `hello`.
  on_news(news: News): void;
  on_packet(bytes: ArrayBuffer): void;
  on_lost(): void;
}

const kPauses = [100, 250, 500, 1000, 2000];
const kLimitPause = 150;

/// A request that is answered later and can be cancelled on its own.
export interface Job<T> {
  answer: Promise<T>;
  cancel: () => void;
}

/// The connection was lost before the answer came.
export class Lost extends Error {}

export class Connection {
  /// Counts of messages and bytes, for the bottom line and for tests.
  readonly counts = { sent: 0, packets: 0, packet_bytes: 0, last_packet_bytes: 0 };
  private socket_: WebSocket | null = null;
  private next_id_ = 1;
  private tries_ = 0;
  private readonly waiting_ = new Map<number, Waiting>();
  private is_closed_ = false;
  private is_greeted_ = false;

  constructor(
    private readonly address_: string,
    private readonly listener_: Listener,
  ) {}

  /// Closes the connection finally. Open requests are lost.
  close(): void {
    this.is_closed_ = true;
    this.socket_?.close();
  }

  connect(): void {
    if (this.is_closed_) return;
    const socket = new WebSocket(this.address_);
    socket.binaryType = 'arraybuffer';
    this.socket_ = socket;
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.receive(event.data);
    socket.onclose = () => this.lose(socket);
  }

  /// True after the server's `hello`. Later messages follow the request that opens the document.
  get is_open(): boolean {
    return this.is_greeted_ && this.socket_?.readyState === WebSocket.OPEN;
  }

  /// Sends a request. Rejects with a Refusal, or with Lost.
  async request<T = object>(
    what: string,
    members: object = {},
    numbered: (id: number) => void = () => undefined,
  ): Promise<T> {
    for (;;) {
      try {
        return await this.request_once<T>(what, members, numbered);
      } catch (fault) {
        // There were too many messages per second. The refused message had no effect, so it is sent again.
        if (!(fault instanceof Refusal) || fault.facts.limit !== 'messages_per_second') throw fault;
        await new Promise((done) => setTimeout(done, kLimitPause));
      }
    }
  }

  begin<T>(what: string, members: object): Job<T> {
    let re = 0;
    const answer = this.request<T>(what, members, (id) => {
      re = id;
    });
    return { answer, cancel: () => this.tell('cancel', { re }) };
  }

  /// Sends a request without waiting for its answer.
  tell(what: string, members: object = {}): void {
    this.request(what, members).catch(() => undefined);
  }

  private request_once<T>(what: string, members: object, numbered: (id: number) => void): Promise<T> {
    return new Promise<T>((resolve, reject) => {
      const socket = this.socket_;
      if (!socket || socket.readyState !== WebSocket.OPEN) return reject(new Lost('the server is not there'));
      const id = this.next_id_;
      this.next_id_ += 1;
      numbered(id);
      this.waiting_.set(id, { resolve: resolve as (answer: never) => void, reject });
      socket.send(JSON.stringify({ do: what, id, ...members }));
      this.counts.sent += 1;
    });
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data !== 'string') {
      if (is_answer(data)) {
        const { head, ...arrays } = read_packed<Answer>(data);
        return this.settle({ ...head, arrays });
      }
      this.counts.packets += 1;
      this.counts.packet_bytes += data.byteLength;
      this.counts.last_packet_bytes = data.byteLength;
      this.listener_.on_packet(data);
      return;
    }
    const message = JSON.parse(data) as Answer;
    if (message.re === undefined || (message.is !== 'done' && message.is !== 'refused')) {
      if (message.is === 'hello') {
        this.tries_ = 0;
        this.is_greeted_ = true;
      }
      this.listener_.on_news(message as unknown as News);
      return;
    }
    this.settle(message);
  }

  private settle(message: Answer): void {
    const waiting = this.waiting_.get(message.re ?? 0);
    this.waiting_.delete(message.re ?? 0);
    if (message.is === 'done') waiting?.resolve(message as never);
    else waiting?.reject(new Refusal(message.message ?? 'refused', message as Refusal['facts']));
  }

  private lose(socket: WebSocket): void {
    if (socket !== this.socket_) return;
    this.socket_ = null;
    this.is_greeted_ = false;
    for (const waiting of this.waiting_.values()) waiting.reject(new Lost('the server was lost'));
    this.waiting_.clear();
    if (this.is_closed_) return;
    this.listener_.on_lost();
    const pause = kPauses[Math.min(this.tries_, kPauses.length - 1)];
    this.tries_ += 1;
    setTimeout(() => this.connect(), pause);
  }
}
