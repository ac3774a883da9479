// The displayed time, and its animation.

hawser.Player = class {
  // onOutput(output): called when the displayed output changes.
  constructor(scene, onOutput) {
    this.scene = scene;
    this.model = scene.model;
    this.onOutput = onOutput;
    this.output = 0;
    this.time = this.model.header.times[0];
    this.speed = 1;
    this.playing = false;
  }

  // Shows an output when it is loaded; the last request counts.
  async show(output) {
    const {model, scene} = this;
    this.output = Math.min(model.outputs - 1, Math.max(0, output));
    this.time = model.header.times[this.output];
    const requested = this.output;
    await model.ready(scene.needs(), [requested]);
    if (requested !== this.output || this.playing) return;
    scene.set(requested, 0);
    this.onOutput(requested);
  }

  play(on) {
    if (on && this.output >= this.model.outputs - 1) {
      this.output = 0;
      this.time = this.model.header.times[0];
    }
    this.playing = on && this.model.outputs > 1;
    if (this.playing) this.frame(performance.now());
    else this.show(this.output);
  }

  // The output before a time.
  before(time) {
    const {times} = this.model.header;
    let [low, high] = [0, times.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  async frame(now) {
    const {model, scene} = this;
    const {times} = model.header;
    const last = times[times.length - 1];
    const output = Math.min(this.before(this.time), model.outputs - 2);
    try {
      await model.ready(scene.needs(), [output, output + 1]);
    } catch (error) {
      this.playing = false;
      this.failed(error);
      return;
    }
    if (!this.playing) return;
    const share = Math.min(1, (this.time - times[output]) / (times[output + 1] - times[output] || 1));
    if (share >= 1) scene.set(output + 1, 0);
    else scene.set(output, share);
    const passed = this.output;
    this.output = scene.output;
    if (passed !== this.output || this.time >= last) this.onOutput(this.output);
    this.ahead(output + 2);
    requestAnimationFrame((next) => {
      if (!this.playing) return;
      this.time = Math.min(last, this.time + this.speed * Math.min(0.25, (next - now) / 1000));
      if (share >= 1 && this.time >= last) {
        this.playing = false;
        this.onOutput(this.output);
        this.ended();
        return;
      }
      this.frame(next);
    });
  }

  // Requests data that will be shown soon.
  ahead(output) {
    const later = Math.min(this.model.outputs - 1, output + Math.ceil(this.model.header.perBlock / 3));
    this.model.ready(this.scene.needs(), [later]).catch(() => {});
  }

  ended() {}

  failed() {}
};
