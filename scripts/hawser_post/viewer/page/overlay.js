// Text over the picture: names, legend, time, scale, axes and the numbers of notes.

const INK = "#16202b";
const SPRING = "#1d6b2f";
const MOST_NAMES = 40;
const MOST_WORDS = 500;  // cached as pictures

hawser.Overlay = class {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    this.words = new Map();
    this.bar = document.createElement("canvas");
  }

  resize(width, height, ratio) {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    [this.width, this.height, this.ratio] = [width, height, ratio];
  }

  clear() {
    this.pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.pen.clearRect(0, 0, this.width, this.height);
  }

  // Text with a light edge, drawn once and copied afterwards. x is its left or right side, or its centre.
  text(words, x, y, {align = "left", bold = false, ink = INK, size = 12} = {}) {
    const key = `${words} ${bold} ${ink} ${size} ${this.ratio}`;
    if (!this.words.has(key)) {
      if (this.words.size > MOST_WORDS) this.words.clear();
      this.words.set(key, this.drawn(words, bold, ink, size));
    }
    const picture = this.words.get(key);
    const [w, h] = [picture.width / this.ratio, picture.height / this.ratio];
    const left = {left: x - 3, right: x - w + 3, center: x - w / 2}[align];
    this.pen.drawImage(picture, Math.round(left * this.ratio) / this.ratio, Math.round((y - size - 2) * this.ratio) / this.ratio, w, h);
  }

  drawn(words, bold, ink, size) {
    const font = `${bold ? "600 " : ""}${size}px system-ui, "DejaVu Sans", sans-serif`;
    this.pen.font = font;
    const picture = document.createElement("canvas");
    picture.width = Math.ceil((this.pen.measureText(words).width + 6) * this.ratio);
    picture.height = Math.ceil((1.5 * size + 4) * this.ratio);
    const pen = picture.getContext("2d");
    pen.scale(this.ratio, this.ratio);
    pen.font = font;
    pen.lineWidth = 3;
    pen.lineJoin = "round";
    pen.strokeStyle = "rgba(255,255,255,0.85)";
    pen.strokeText(words, 3, size + 2);
    pen.fillStyle = ink;
    pen.fillText(words, 3, size + 2);
    return picture;
  }

  // Names, [{words, places: [{x, y}]}], each at the first of its places that overlaps no other name and no
  // box of `taken`; names without such a place are omitted. Returns the words that were drawn.
  names(names, taken) {
    const [boxes, written] = [[...taken], []];
    for (const {words, places} of names) {
      if (written.length >= MOST_NAMES) break;
      const [w, h] = [7 * words.length + 6, 14];
      const free = ({x, y}) => boxes.every((b) => x + 6 > b.x + b.w || x + 6 + w < b.x || y - 6 > b.y + b.h || y - 6 + h < b.y);
      const place = places.find(free);
      if (!place) continue;
      boxes.push({x: place.x + 6, y: place.y - 6, w, h});
      this.text(words, place.x + 6, place.y + 4);
      written.push(words);
    }
    return written;
  }

  // Draws links, [{a, b}] on the screen, as springs.
  springs(links) {
    const {pen} = this;
    [pen.lineWidth, pen.strokeStyle, pen.lineJoin] = [2, SPRING, "round"];
    for (const {a, b} of links) {
      const length = Math.hypot(b.x - a.x, b.y - a.y);
      const turns = Math.min(14, Math.max(2, Math.round(length / 12)));
      const [across_x, across_y] = [-5 * (b.y - a.y) / (length || 1), 5 * (b.x - a.x) / (length || 1)];
      pen.beginPath();
      pen.moveTo(a.x, a.y);
      for (let k = 0; k <= 2 * turns; k++) {
        const [share, side] = [0.2 + 0.6 * k / (2 * turns), k % (2 * turns) === 0 ? 0 : k % 2 ? 1 : -1];
        pen.lineTo(a.x + share * (b.x - a.x) + side * across_x, a.y + share * (b.y - a.y) + side * across_y);
      }
      pen.lineTo(b.x, b.y);
      pen.stroke();
    }
  }

  // Draws the numbers of notes, as in the list, each with a line to its place.
  badges(places) {
    const {pen} = this;
    for (const {x, y, place} of places) {
      pen.beginPath();
      pen.moveTo(place.x, place.y);
      pen.lineTo(x, y);
      pen.lineWidth = 1;
      pen.strokeStyle = INK;
      pen.stroke();
    }
    for (const {number, x, y, warning} of places) {
      pen.beginPath();
      pen.arc(x, y, 9, 0, 2 * Math.PI);
      pen.fillStyle = warning ? "#a31515" : "#1f5a92";
      pen.fill();
      pen.lineWidth = 1.5;
      pen.strokeStyle = "white";
      pen.stroke();
      pen.fillStyle = "white";
      pen.font = '600 11px system-ui, "DejaVu Sans", sans-serif';
      pen.textAlign = "center";
      pen.fillText(String(number), x, y + 4);
    }
  }

  // Draws the colour bar with numbers, and words below it; null: no colours.
  legend(colours, field, words) {
    if (!field) return;
    const {pen} = this;
    const [x, top, wide, high] = [14, 34, 16, Math.min(220, this.height - 110)];
    this.text(field.unit && field.unit !== "1" ? `${field.label} [${field.unit}]` : field.label, x, 20, {bold: true});
    this.paintBar(colours, high);
    pen.drawImage(this.bar, x, top, wide, high);
    pen.lineWidth = 1;
    pen.strokeStyle = INK;
    pen.strokeRect(x + 0.5, top + 0.5, wide, high);
    const [low, top_] = [colours.low / field.factor, colours.high / field.factor];
    for (const tick of hawser.ticks(low, top_, 5)) {
      const y = top + high - high * (top_ > low ? (tick - low) / (top_ - low) : 0.5);
      pen.lineWidth = 1;
      pen.strokeStyle = INK;
      pen.beginPath();
      pen.moveTo(x + wide, y);
      pen.lineTo(x + wide + 4, y);
      pen.stroke();
      this.text(hawser.number(tick), x + wide + 7, y + 4);
    }
    words.forEach((line, k) => this.text(line, x, top + high + 18 + 15 * k, {size: 11}));
  }

  // Paints the colours from the largest value to the smallest, one row each.
  paintBar(colours, high) {
    const key = `${colours.chosen.name} ${high}`;
    if (this.barKey === key) return;
    this.barKey = key;
    [this.bar.width, this.bar.height] = [1, high];
    const pen = this.bar.getContext("2d");
    for (let k = 0; k < high; k++) {
      pen.fillStyle = `rgb(${colours.at(1 - (k + 0.5) / high)})`;
      pen.fillRect(0, k, 1, 1);
    }
  }

  // Draws a scale bar of a round length.
  scale(pixel) {
    const {pen} = this;
    const most = 150 * pixel;
    const decade = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].find((n) => n * decade <= most) * decade;
    const [x, y] = [this.width - 16, this.height - 16];
    pen.lineWidth = 2;
    pen.strokeStyle = INK;
    pen.beginPath();
    pen.moveTo(x - length / pixel, y - 5);
    pen.lineTo(x - length / pixel, y);
    pen.lineTo(x, y);
    pen.lineTo(x, y - 5);
    pen.stroke();
    this.text(`${hawser.number(length)} m`, x, y - 9, {align: "right"});
  }

  // Draws the directions of x, y and z.
  axes(camera) {
    const {pen} = this;
    const [x, y] = [46, this.height - 46];
    ["x", "y", "z"].forEach((name, k) => {
      const way = new THREE.Vector3().setComponent(k, 1).transformDirection(camera.matrixWorldInverse);
      pen.lineWidth = 2;
      pen.strokeStyle = ["#a31515", "#1d6b2f", "#1f5a92"][k];
      pen.beginPath();
      pen.moveTo(x, y);
      pen.lineTo(x + 28 * way.x, y - 28 * way.y);
      pen.stroke();
      if (Math.hypot(way.x, way.y) > 0.15) this.text(name, x + 37 * way.x, y - 37 * way.y + 4, {align: "center", bold: true});
    });
  }
};
