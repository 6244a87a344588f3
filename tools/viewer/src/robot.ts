// SPDX-License-Identifier: MIT
// A robot's boxes in space, from its root pose and joint angles.
import { Matrix4, Quaternion, Vector3 } from "three";
import type { RobotModel } from "./recording";

const vector = (v: number[]): Vector3 => new Vector3(v[0], v[1], v[2]);
const quaternion = (q: number[]): Quaternion => new Quaternion(q[1], q[2], q[3], q[0]);
const one = new Vector3(1, 1, 1);

export class RobotShape {
  readonly boxes: { link: number; frame: Matrix4; part: string }[] = [];
  private readonly rest: Matrix4[] = [];
  private readonly parents: number[] = [];
  private readonly axes: Vector3[] = [];
  private readonly links: Matrix4[] = [];
  private readonly turn = new Matrix4();

  constructor(readonly model: RobotModel) {
    for (const [index, link] of model.links.entries()) {
      this.parents.push(link.parent);
      this.rest.push(new Matrix4().compose(vector(link.offset_m), quaternion(link.rotation), one));
      this.axes.push(link.hinge ? vector(link.hinge.axis) : new Vector3(0, 1, 0));
      this.links.push(new Matrix4());
      for (const box of link.boxes) {
        const size = vector(box.half_extents_m).multiplyScalar(2);
        this.boxes.push({ link: index, part: box.part, frame: new Matrix4().compose(vector(box.centre_m), quaternion(box.orientation), size) });
      }
    }
  }

  /** The links' frames for a pose as Recording.poseInto gives it; without joint angles all hinges are at rest. */
  place(pose: Float32Array): Matrix4[] {
    const root = this.links[0];
    root.compose(new Vector3(pose[0], pose[1], pose[2]), new Quaternion(pose[4], pose[5], pose[6], pose[3]), one);
    for (let link = 1; link < this.links.length; ++link) {
      const own = this.links[link].multiplyMatrices(this.links[this.parents[link]], this.rest[link]);
      if (pose.length > 6 + link) own.multiply(this.turn.makeRotationAxis(this.axes[link], pose[7 + link - 1]));
    }
    return this.links;
  }
}
