// Polls a server for changes: a run in progress, or a case that was run or changed.

const EVERY = 1500;  // ms

hawser.follow = function (view, root) {
  if (!root.dataset.base) return;
  const {model, controls} = view;
  const box = hawser.make("input", {type: "checkbox", checked: true});
  const bar = hawser.make("progress", {max: 1, value: 0, "aria-label": "Progress of the run"});
  const words = hawser.make("span", {role: "status"});
  const line = hawser.make("div", {class: "bar"}, bar, words, hawser.make("label", {}, box, " Follow the run"));
  line.hidden = true;
  controls.element.prepend(line);

  const grown = async () => {
    const atEnd = view.player.output === model.outputs - 1;
    const old = model.outputs;
    const header = await model.source.header();
    for (const field of header.fields) Object.assign(model.field(field.name) || {}, {low: field.low, high: field.high});
    model.header.times = header.times;
    model.header.contacts = header.contacts;
    model.header.ended = header.ended;
    model.forget(old - 1);
    for (const name of [...model.loaded.keys()]) if (/^(ends|series|statistics)\//.test(name)) model.loaded.delete(name);
    controls.slider.max = header.times.length - 1;
    controls.time.hidden = header.times.length < 2;
    if (view.player.output >= model.outputs) await view.player.show(model.outputs - 1);  // the run was restarted from an earlier time
    if (view.whole) view.limit(true);
    if (view.scene.ofRun) await view.values(view.scene.ofRun.label);
    if (!view.player.playing) view.pace();
    if (box.checked && atEnd && !view.player.playing) {
      await view.player.show(header.times.length - 1);
      await view.choose(view.chosen);
    }
  };

  const ask = async () => {
    try {
      const answer = await fetch(`${root.dataset.base}status`);
      if (!answer.ok) throw new Error(await answer.text());
      const status = await answer.json();
      if (status.stamp !== model.source.stamp) {
        location.reload();
        return;
      }
      const running = status.kind === "run" && !status.ended;
      line.hidden = !running && !status.words;
      bar.hidden = box.parentNode.hidden = !running;
      bar.value = status.duration > 0 ? Math.min(1, status.time / status.duration) : 0;
      const soFar = status.duration > 0 ? `the run has written t = ${status.time.toFixed(1)} s of ${status.duration} s` : "the run has not ended";
      words.textContent = status.words || (running ? soFar : "");
      if (status.outputs !== model.outputs || (status.ended && !model.header.ended)) await grown();
    } catch (error) {
      line.hidden = false;
      words.textContent = error instanceof TypeError ? "the server has ended" : error.message;
    }
    setTimeout(ask, EVERY);
  };
  setTimeout(ask, EVERY);
};
