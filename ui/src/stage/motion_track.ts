/** Smooth motion between telemetry: draws a little in the past, where two messages surround the moment. */

export interface Pose {
  x_m: number;
  y_m: number;
  heading_deg: number;
  pan_deg: number;
}

interface Sample {
  t_us: number;
  pose: Pose;
}

const delay_us = 90_000;
const kept = 40;
/** A jump further than this is a new place (put back, another room), not a motion. */
const jump_m = 0.6;

/** From a to b by this part, the short way round; degrees. */
export function mixAngle(a: number, b: number, part: number): number {
  const turn = ((((b - a) % 360) + 540) % 360) - 180;
  return a + turn * part;
}

function mix(a: Pose, b: Pose, part: number): Pose {
  return {
    x_m: a.x_m + (b.x_m - a.x_m) * part,
    y_m: a.y_m + (b.y_m - a.y_m) * part,
    heading_deg: mixAngle(a.heading_deg, b.heading_deg, part),
    pan_deg: mixAngle(a.pan_deg, b.pan_deg, part),
  };
}

export class MotionTrack {
  private samples: Sample[] = [];
  /** Robot's clock minus the page's clock, by the message that was quickest to arrive. */
  private offset_us = 0;

  /** `now_ms`: the page's clock when the message arrived. */
  push(t_us: number, pose: Pose, now_ms: number): void {
    const last = this.samples.at(-1);
    const jumped = last && Math.hypot(pose.x_m - last.pose.x_m, pose.y_m - last.pose.y_m) > jump_m;
    if (!last || t_us < last.t_us || jumped) this.samples = [];
    const offset = t_us - now_ms * 1000;
    // Follows a slow drift, but one late message does not pull the picture back.
    this.offset_us = this.samples.length === 0 ? offset : Math.max(offset, this.offset_us - 2000);
    if (last && t_us === last.t_us && this.samples.length) this.samples.pop();
    this.samples.push({ t_us, pose });
    if (this.samples.length > kept) this.samples.shift();
  }

  /** The pose to draw at this moment of the page's clock, or null before the first message. */
  at(now_ms: number): Pose | null {
    const last = this.samples.at(-1);
    if (!last) return null;
    const wanted = now_ms * 1000 + this.offset_us - delay_us;
    if (wanted >= last.t_us) return last.pose;
    for (let i = this.samples.length - 1; i > 0; i--) {
      const a = this.samples[i - 1]!;
      const b = this.samples[i]!;
      if (wanted >= a.t_us) return mix(a.pose, b.pose, (wanted - a.t_us) / (b.t_us - a.t_us));
    }
    return this.samples[0]!.pose;
  }

  /** Whether the drawing has reached the newest pose, so that nothing moves any more. */
  settled(now_ms: number): boolean {
    const last = this.samples.at(-1);
    return !last || now_ms * 1000 + this.offset_us - delay_us >= last.t_us;
  }
}
