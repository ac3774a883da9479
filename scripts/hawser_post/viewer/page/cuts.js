// Sections: cuts away the model above a level or in front of a vertical plane.

hawser.Cuts = class {
  constructor(renderer, camera) {
    this.renderer = renderer;
    this.camera = camera;
    this.kind = "none";
    this.share = 1;
  }

  // kind: "none", "plan" or "elevation"; share: position of the cut in the model, 0 to 1.
  set(kind, share) {
    this.kind = kind;
    this.share = share;
    if (kind === "none") {
      this.renderer.clippingPlanes = [];
      return;
    }
    const {low, high} = this.camera;
    if (kind === "plan") {
      this.at = low.z + share * (high.z - low.z);
      this.renderer.clippingPlanes = [new THREE.Plane(new THREE.Vector3(0, 0, -1), this.at)];
      return;
    }
    // Normal to the horizontal direction of an elevation.
    const way = new THREE.Vector3(this.camera.across[1], -this.camera.across[0], 0).normalize();
    const corners = [[low.x, low.y], [low.x, high.y], [high.x, low.y], [high.x, high.y]].map(([x, y]) => x * way.x + y * way.y);
    const [least, most] = [Math.min(...corners), Math.max(...corners)];
    this.at = least + share * (most - least);
    this.renderer.clippingPlanes = [new THREE.Plane(way.negate(), this.at)];
  }

  // Description of the cut.
  describe(centre) {
    if (this.kind === "plan") return `cut at z = ${hawser.number(this.at + centre[2])} m`;
    if (this.kind === "elevation") {
      const {across} = this.camera;
      return `cut ${hawser.number(this.at + centre[0] * across[1] - centre[1] * across[0])} m before the axis`;
    }
    return "no cut";
  }
};
