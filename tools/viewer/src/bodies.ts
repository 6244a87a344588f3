// SPDX-License-Identifier: MIT
// The robots' boxes, and the shadows that they throw on a flat floor.
import { BoxGeometry, Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, MeshLambertMaterial } from "three";
import { theme } from "./theme";

const limbInk = new Color(0x2b333d);

/** Position of the sun, from the origin. */
export const sunAt = [4, -7, 14] as const;

/** Projects along the light onto the plane a little above the floor. */
function shadowMatrix(): Matrix4 {
  const [x, y, z] = sunAt;
  return new Matrix4().set(1, 0, -x / z, 0, 0, 1, -y / z, 0, 0, 0, 0, 0.0012, 0, 0, 0, 1);
}

export class Bodies {
  readonly group = new Group();
  private boxes!: InstancedMesh;
  private shadows!: InstancedMesh;
  private most = 0;
  private readonly geometry = new BoxGeometry(1, 1, 1);
  private readonly material = new MeshLambertMaterial();
  private readonly shadowMaterial = new MeshBasicMaterial({ depthWrite: false });
  private readonly colour = new Color();
  private rootColour = new Color();
  private limbColour = new Color();
  private count = 0;

  constructor(most: number, private readonly hasFlatFloor: boolean) {
    this.reserve(most);
    this.paint();
  }

  /** Room for that many boxes. */
  private reserve(most: number): void {
    for (const mesh of this.most > 0 ? [this.boxes, this.shadows] : []) mesh.dispose();
    this.group.clear();
    this.most = most;
    this.boxes = new InstancedMesh(this.geometry, this.material, most);
    this.boxes.frustumCulled = false;
    this.shadows = new InstancedMesh(this.geometry, this.shadowMaterial, most);
    this.shadows.instanceMatrix = this.boxes.instanceMatrix;
    this.shadows.frustumCulled = false;
    this.shadows.renderOrder = -2;
    this.shadows.matrixAutoUpdate = false;
    this.shadows.matrix.copy(shadowMatrix());
    this.shadows.visible = this.hasFlatFloor;
    this.group.add(this.shadows, this.boxes);
  }

  /** Takes the colours of the theme. */
  paint(): void {
    this.shadowMaterial.color.set(theme().shadow);
  }

  /** Begins a picture of at most `boxes` boxes. */
  clear(boxes: number): void {
    if (boxes > this.most) this.reserve(Math.max(boxes, Math.ceil(1.5 * this.most)));
    this.count = 0;
  }

  /** The colour of the robot whose boxes come next. */
  begin(colour: string): void {
    this.rootColour.set(colour);
    this.limbColour.copy(this.rootColour).lerp(limbInk, 0.45);
  }

  add(frame: Matrix4, isRoot: boolean): void {
    this.boxes.setMatrixAt(this.count, frame);
    this.boxes.setColorAt(this.count, this.colour.copy(isRoot ? this.rootColour : this.limbColour));
    ++this.count;
  }

  done(): void {
    this.boxes.count = this.count;
    this.shadows.count = this.count;
    this.boxes.instanceMatrix.needsUpdate = true;
    if (this.boxes.instanceColor) this.boxes.instanceColor.needsUpdate = true;
  }
}
