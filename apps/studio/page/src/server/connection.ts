// SPDX-License-Identifier: Apache-2.0
// The WebSocket of the page: requests with their answers, messages, scene packets. It connects again if the connection
// is lost.
import type { PacketArrays } from './packet.ts';
import { is_answer, read_packed } from './packet.ts';
import type { Answers, Refused, RequestName, Requests, ServerMessage } from './protocol.ts';
import { Refusal } from './protocol.ts';

/// Requests whose answers have arrays.
type Packed = 'overlays' | 'cloud';

/// The members of an answer, and its arrays.
export type Answer<K extends RequestName> = Answers[K] & (K extends Packed ? { arrays: PacketArrays } : unknown);

type Numbered = (id: number) => void;

/// The members of a request, which may be left out if none is required. `numbered` is called with the request's number.
type Sent<K extends RequestName> =
  Partial<Requests[K]> extends Requests[K]
    ? [members?: Requests[K], numbered?: Numbered]
    : [members: Requests[K], numbered?: Numbered];

type AnyAnswer =
  | { is: 'done'; re: number; arrays?: PacketArrays }
  | ({ arrays?: PacketArrays; is: 'refused'; re: number | null } & Refused);
type Waiting = { resolve: (answer: never) => void; reject: (fault: Error) => void };

export interface Listener {
  /// Called after the server's `hello`.
  on_message(message: ServerMessage): void;
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
  async request<K extends RequestName>(what: K, ...[members, numbered]: Sent<K>): Promise<Answer<K>> {
    for (;;) {
      try {
        return await this.request_once<K>(what, members ?? {}, numbered);
      } catch (fault) {
        // There were too many messages per second. The refused message had no effect, so it is sent again.
        if (!(fault instanceof Refusal) || fault.facts.limit !== 'messages_per_second') throw fault;
        await new Promise((done) => setTimeout(done, kLimitPause));
      }
    }
  }

  begin<K extends RequestName>(what: K, members: Requests[K]): Job<Answer<K>> {
    let re = 0;
    const numbered: Numbered = (id) => {
      re = id;
    };
    const answer = this.request(what, ...([members, numbered] as Sent<K>));
    return { answer, cancel: () => this.tell('cancel', { re }) };
  }

  /// Sends a request without waiting for its answer.
  tell<K extends RequestName>(what: K, ...sent: Sent<K>): void {
    this.request(what, ...sent).catch(() => undefined);
  }

  private request_once<K extends RequestName>(what: K, members: object, numbered?: Numbered): Promise<Answer<K>> {
    return new Promise<Answer<K>>((resolve, reject) => {
      const socket = this.socket_;
      if (!socket || socket.readyState !== WebSocket.OPEN) return reject(new Lost('the server is not there'));
      const id = this.next_id_;
      this.next_id_ += 1;
      numbered?.(id);
      this.waiting_.set(id, { resolve: resolve as (answer: never) => void, reject });
      socket.send(JSON.stringify({ do: what, id, ...members }));
      this.counts.sent += 1;
    });
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data !== 'string') {
      if (is_answer(data)) {
        const { head, ...arrays } = read_packed<AnyAnswer>(data);
        return this.settle({ ...head, arrays });
      }
      this.counts.packets += 1;
      this.counts.packet_bytes += data.byteLength;
      this.counts.last_packet_bytes = data.byteLength;
      this.listener_.on_packet(data);
      return;
    }
    const message = JSON.parse(data) as AnyAnswer | ServerMessage;
    if (message.is === 'done' || message.is === 'refused') return this.settle(message);
    if (message.is === 'hello') {
      this.tries_ = 0;
      this.is_greeted_ = true;
    }
    this.listener_.on_message(message);
  }

  private settle(answer: AnyAnswer): void {
    const waiting = this.waiting_.get(answer.re ?? 0);
    this.waiting_.delete(answer.re ?? 0);
    if (answer.is === 'done') waiting?.resolve(answer as never);
    else waiting?.reject(new Refusal(answer.message, answer));
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
