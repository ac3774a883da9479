// Graphs with zoom and values at the cursor, drawn by Dygraphs.

const CURVE_COLOURS = ["#1f5a92", "#b3470f", "#2c7a4b", "#8b4a8b", "#a03030", "#5b6770", "#7d6a0c", "#1c7f8c"];

// Creates an element with attributes and children; names of events begin with "on".
hawser.make = function (tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== false && value !== undefined) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children);
  return element;
};

// Rows [x, y of each curve] of curves with different x: null where a curve has no point.
hawser.rowsOf = function (curves) {
  const same = curves.every((curve) => curve.x.length === curves[0].x.length && (curve.x === curves[0].x || curve.x.every((x, i) => x === curves[0].x[i])));
  if (same) return Array.from(curves[0].x, (x, i) => [x, ...curves.map((curve) => curve.y[i])]);
  const rows = new Map();
  curves.forEach((curve, c) => {
    for (let i = 0; i < curve.x.length; i++) {
      if (!rows.has(curve.x[i])) rows.set(curve.x[i], new Array(curves.length).fill(null));
      rows.get(curve.x[i])[c] = curve.y[i];
    }
  });
  return [...rows].sort((a, b) => a[0] - b[0]).map(([x, y]) => [x, ...y]);
};

hawser.Graph = class {
  // what: {title, x, y, curves: [{label, x, y, dashed, colour}]}
  constructor(what) {
    this.legend = hawser.make("div", {class: "legend", "aria-live": "polite"});
    this.plot = hawser.make("div", {class: "plot", tabindex: 0, role: "img", onkeydown: (event) => this.key(event)});
    this.title = hawser.make("span", {class: "graph-title"});
    const whole = hawser.make("button", {type: "button", onclick: () => this.graph && this.graph.resetZoom()}, "Whole range");
    this.whole = whole;
    this.element = hawser.make("div", {class: "graph"}, hawser.make("div", {class: "graph-head"}, this.title, whole), this.plot, this.legend);
    if (what) this.show(what);
  }

  show(what) {
    const curves = what.curves.filter((curve) => curve.x.length);
    this.title.textContent = what.title || "";
    this.whole.setAttribute("aria-label", `Whole range of the graph ${what.title || what.y}`);
    this.plot.setAttribute("aria-label", `Graph of ${what.y} over ${what.x}${what.title ? `, ${what.title}` : ""}; left and right arrows read off values`);
    this.element.hidden = curves.length === 0;
    if (!curves.length) return;
    this.names = [what.x, ...hawser.distinct(curves.map((curve) => curve.label))];
    const series = {};
    curves.forEach((curve, k) => {
      series[this.names[k + 1]] = {color: curve.colour || CURVE_COLOURS[k % CURVE_COLOURS.length], strokePattern: curve.dashed ? [6, 4] : null,
                                   strokeWidth: curve.wide || 1.5};
    });
    const number = (value) => (value === null || value === undefined ? "" : hawser.number(value));
    const options = {
      file: hawser.rowsOf(curves), labels: this.names, series, xlabel: what.x, ylabel: what.y, labelsDiv: this.legend, legend: "always",
      connectSeparatedPoints: true, axisLabelFontSize: 12, gridLineColor: "#dfe5ea", axisLineColor: "#54616d", highlightCircleSize: 3,
      yRangePad: 6, xRangePad: 2, yAxisLabelWidth: 62, width: null, height: null,
      axes: {x: {valueFormatter: number, axisLabelFormatter: number}, y: {valueFormatter: number, axisLabelFormatter: number}},
    };
    if (this.graph) {
      this.graph.updateOptions(options);
      return;
    }
    // A graph has a size only when it is on the page.
    const start = () => {
      if (!this.plot.clientWidth) return;
      this.graph = new Dygraph(this.plot, options.file, options);
      watch.disconnect();
    };
    const watch = new ResizeObserver(start);
    watch.observe(this.plot);
    this.pending = options;
  }

  // Moves the cursor to another point.
  key(event) {
    const step = {ArrowLeft: -1, ArrowRight: 1, PageDown: -20, PageUp: 20}[event.key];
    if (!step || !this.graph) return;
    event.preventDefault();
    const rows = this.graph.numRows();
    this.row = Math.min(rows - 1, Math.max(0, (this.row === undefined ? (step > 0 ? -1 : rows) : this.row) + step));
    this.graph.setSelection(this.row);
  }
};

// Distinct names of curves.
hawser.distinct = function (names) {
  return names.map((name, k) => {
    const before = names.slice(0, k).filter((other) => other === name).length;
    return before ? `${name} (${before + 1})` : name;
  });
};
