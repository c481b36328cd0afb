import { type FromRobot, type PictureHeader, type ToRobot, readPicture } from './protocol';

export type Link = 'connecting' | 'up' | 'lost';

export interface Handlers {
  link: (link: Link) => void;
  message: (message: FromRobot) => void;
  picture: (header: PictureHeader, jpeg: Uint8Array<ArrayBuffer>) => void;
  /** The first message of every connection. */
  hello: () => ToRobot;
}

const firstWait = 300;
const longestWait = 5000;
const silenceBeforeProbe = 3000;
const probeTimeout = 3000;

/** The time before try `n` (0, 1, ...), ms: doubles, with some chance in it so that a class does not knock as one. */
export function waitBefore(n: number, random: number): number {
  return Math.min(longestWait, firstWait * 2 ** n) * (0.75 + random / 2);
}

/** The WebSocket to the robot: connects, notices silence, connects again for as long as the page lives. */
export class Connection {
  private socket: WebSocket | null = null;
  private tries = 0;
  private heardAt = 0;
  private timer = 0;
  private probing = false;

  constructor(private readonly handlers: Handlers) {
    window.addEventListener('online', () => this.connectNow());
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden) this.connectNow();
    });
    window.setInterval(() => void this.probe(), 1000);
    this.open();
  }

  /** False when there is no connection: nothing is queued, an old command must not move a robot later. */
  send(message: ToRobot): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  sendText(text: string): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(text);
    return true;
  }

  /** Connects anew, as somebody else. */
  restart(): void {
    this.socket?.close();
  }

  private open(): void {
    window.clearTimeout(this.timer);
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    const socket = new WebSocket(`${scheme}://${location.host}/ws`);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    socket.onopen = () => {
      this.heardAt = performance.now();
      socket.send(JSON.stringify(this.handlers.hello()));
    };
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.receive(event.data);
    socket.onclose = () => this.lost(socket);
  }

  private receive(data: string | ArrayBuffer): void {
    this.heardAt = performance.now();
    if (typeof data !== 'string') {
      const picture = readPicture(data);
      if (picture) this.handlers.picture(picture.header, picture.jpeg);
      return;
    }
    const message = JSON.parse(data) as FromRobot;
    if (message.type === 'welcome') {
      this.tries = 0;
      this.handlers.link('up');
    }
    this.handlers.message(message);
  }

  private lost(socket: WebSocket): void {
    if (socket !== this.socket) return;
    this.socket = null;
    this.handlers.link('lost');
    this.timer = window.setTimeout(() => this.open(), waitBefore(this.tries++, Math.random()));
  }

  private connectNow(): void {
    if (this.socket) return;
    this.tries = 0;
    this.open();
  }

  /** A dead network closes no socket for minutes: after some silence ask the robot over HTTP. */
  private async probe(): Promise<void> {
    const socket = this.socket;
    if (this.probing || socket?.readyState !== WebSocket.OPEN || document.hidden) return;
    if (performance.now() - this.heardAt < silenceBeforeProbe) return;
    this.probing = true;
    try {
      await fetch('/api/setup', { signal: AbortSignal.timeout(probeTimeout), cache: 'no-store' });
      this.heardAt = performance.now();
    } catch {
      socket.onclose = null;
      socket.close();
      this.lost(socket);
    } finally {
      this.probing = false;
    }
  }
}
