// Figures of a report: interactive graphs replace the pictures of curves on the screen; prints keep the
// pictures.

hawser.figures = function () {
  const watch = new IntersectionObserver((entries) => {
    for (const {isIntersecting, target} of entries) {
      if (!isIntersecting) continue;
      watch.unobserve(target);
      hawser.figure(target).catch(() => {});  // the picture stays
    }
  }, {rootMargin: "300px"});
  for (const figure of document.querySelectorAll("figure[data-curves]")) watch.observe(figure);
};

hawser.figure = async function (figure) {
  const script = figure.querySelector("script");
  const what = JSON.parse(figure.dataset.curves);
  const block = await hawser.unpacked(hawser.bytesOfBase64(script.textContent), Float64Array);
  const row = (k) => block.values.subarray(k * block.columns, (k + 1) * block.columns);
  const curves = what.curves.map((curve, k) => ({
    label: curve.label, dashed: curve.dashed, colour: curve.colour,
    x: Array.from(row(2 * k).subarray(0, curve.points), (v) => curve.x[0] + v * curve.x[1]),
    y: Array.from(row(2 * k + 1).subarray(0, curve.points), (v) => curve.y[0] + v * curve.y[1]),
  }));
  const graph = new hawser.Graph();
  graph.element.classList.add("on-screen");
  const picture = figure.querySelector("img");
  picture.classList.add("on-paper");
  picture.before(graph.element);
  graph.show({title: what.title, x: what.x, y: what.y, curves});
};
