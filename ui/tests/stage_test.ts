import { describe, expect, it } from 'vitest';
import { angleOfPoint, wrapAngle } from '../src/blocks/dial';
import { MotionTrack, mixAngle } from '../src/stage/motion_track';
import { boundaryPieces, freeTop, nearest, nearestPoint } from '../src/stage/overlays';
import { sonarPoints } from '../src/stage/room_draw';
import { fitRoom } from '../src/stage/room_view';
import { waitBefore } from '../src/wire/connection';
import { type Sonar, readPicture } from '../src/wire/protocol';

const pose = (x_m: number, heading_deg = 0) => ({ x_m, y_m: 0, heading_deg, pan_deg: 0 });

describe('smooth motion', () => {
  it('goes the short way round', () => {
    expect(mixAngle(170, -170, 0.5)).toBeCloseTo(180);
    expect(mixAngle(-10, 10, 0.5)).toBeCloseTo(0);
  });

  it('lies between two messages and never ahead of the last', () => {
    const track = new MotionTrack();
    track.push(1_000_000, pose(0), 5000);
    track.push(1_100_000, pose(0.2), 5100);
    expect(track.at(5140)!.x_m).toBeCloseTo(0.1, 5);
    expect(track.at(9999)!.x_m).toBeCloseTo(0.2, 5);
    expect(track.settled(5140)).toBe(false);
    expect(track.settled(5200)).toBe(true);
  });

  it('does not slide over a jump', () => {
    const track = new MotionTrack();
    track.push(1_000_000, pose(0), 5000);
    track.push(1_050_000, pose(2), 5050);
    expect(track.at(5060)!.x_m).toBe(2);
  });
});

const sonar: Sonar = {
  frame: 1,
  t_us: 0,
  pan_deg: 0,
  trusted: true,
  readings: [
    [90, 'blocked', 0.5, 0.01],
    [0, 'clear', 2, 0.1],
    [-90, 'not_seen', null, null],
  ],
  boundary: [
    [0, 100, 'blocked'],
    [5, 140, 'blocked'],
    [10, 60, 'clear'],
    [200, 90, 'blocked'],
  ],
};

describe('overlays', () => {
  it('cuts the boundary where the answer changes and where columns are missing', () => {
    expect(boundaryPieces(sonar.boundary).map((piece) => [piece.answer, piece.points.length])).toEqual([
      ['blocked', 2],
      ['clear', 1],
      ['blocked', 1],
    ]);
  });

  it('names the nearest blocked reading, and where it is', () => {
    expect(nearest(sonar)).toBe(0.5);
    expect(nearestPoint(sonar.boundary)).toEqual([5, 140]);
    expect(nearest({ ...sonar, readings: [[0, 'clear', 1, 0]] })).toBeNull();
  });

  it('puts readings to the left of the robot on its left', () => {
    const [left, ahead, ...rest] = sonarPoints({ ...pose(1), y_m: 1 }, sonar);
    expect(left!.point[0]).toBeCloseTo(1);
    expect(left!.point[1]).toBeCloseTo(1.5);
    expect(ahead).toEqual({ point: [3, 1], blocked: false });
    expect(rest).toEqual([]);
  });

  it('fits the room with y upwards', () => {
    const view = fitRoom({ min_x_m: -2, min_y_m: -1, max_x_m: 2, max_y_m: 1 }, 424, 424);
    expect([view.scale, view.x(-2), view.x(2)]).toEqual([100, 12, 412]);
    expect(view.y(1)).toBeLessThan(view.y(-1));
  });
});

describe('the dial', () => {
  it('is zero ahead and positive to the right', () => {
    expect(angleOfPoint(0, -50)).toBe(0);
    expect(angleOfPoint(50, 0)).toBe(90);
    expect(angleOfPoint(-50, 0)).toBe(-90);
    expect(angleOfPoint(0, 50)).toBe(180);
    expect([wrapAngle(270), wrapAngle(-181), wrapAngle(720)]).toEqual([-90, 179, 0]);
  });
});

describe('the wire', () => {
  it('splits a picture from its header', () => {
    const header = new TextEncoder().encode('{"frame":7,"t_us":1,"width":2,"height":3}');
    const bytes = new Uint8Array(4 + header.length + 2);
    new DataView(bytes.buffer).setUint32(0, header.length, true);
    bytes.set(header, 4);
    bytes.set([0xff, 0xd8], 4 + header.length);
    const picture = readPicture(bytes.buffer);
    expect(picture?.header.frame).toBe(7);
    expect([...picture!.jpeg]).toEqual([0xff, 0xd8]);
    expect(readPicture(bytes.buffer.slice(0, 10))).toBeNull();
  });

  it('waits longer from try to try, up to a limit', () => {
    const waits = [0, 1, 2, 3, 10].map((n) => waitBefore(n, 0.5));
    expect(waits).toEqual([300, 600, 1200, 2400, 5000]);
    expect(waitBefore(0, 0)).toBeLessThan(waitBefore(0, 1));
  });
});

describe('labels on the picture', () => {
  it('stand where they are wanted, unless another one is there', () => {
    const there = [{ left: 50, top: 40, width: 60 }];
    expect(freeTop([], { left: 40, top: 40, width: 50 }, 200)).toBe(40);
    expect(freeTop(there, { left: 120, top: 40, width: 50 }, 200)).toBe(40);
    expect(freeTop(there, { left: 40, top: 40, width: 50 }, 200)).toBe(16);
    expect(freeTop(there, { left: 40, top: 30, width: 50 }, 200)).toBe(16);
    expect(freeTop([{ left: 50, top: 10, width: 60 }], { left: 40, top: 10, width: 50 }, 200)).toBe(34);
  });
});
